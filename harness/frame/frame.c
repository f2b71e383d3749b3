#include "frame.h"
#include <stdlib.h>
#include <string.h>
#include "base/half.h"
#include "base/memory.h"
#include "prelude.h"

enum { MAX_BINDS = AOB_MAX_IN + 4 };

static uint32_t use_of(enum aob_gpu_bind_kind kind)
{
    return kind == AOB_GPU_STORAGE ? AOB_GPU_USE_STORAGE : AOB_GPU_USE_SAMPLED;
}

static enum aob_gpu_bind_kind kind_of(enum aob_fetch fetch)
{
    return fetch == AOB_FETCH_STORAGE ? AOB_GPU_STORAGE : AOB_GPU_SAMPLED;
}

static enum aob_gpu_bind_kind input_kind(const struct aob_graph_bind *in, enum aob_fetch fetch)
{
    return in->filter == AOB_BILINEAR ? AOB_GPU_SAMPLED : kind_of(fetch);
}

static struct aob_gpu_texture *upload(const struct aob_screen *screen, uint32_t uses, enum aob_format format,
                                      void *texels, struct aob_error *error)
{
    const struct aob_projection *view = &screen->gbuffer->projection;
    const struct aob_gpu_texture_desc desc = {
        .format = format, .width = view->width, .height = view->height, .uses = uses, .texels = texels};
    struct aob_gpu_texture *texture = aob_gpu_texture_create(screen->gpu, &desc, error);
    free(texels);
    return texture;
}

bool aob_screen_init(struct aob_screen *screen, struct aob_gpu *gpu, const struct aob_gbuffer *gbuffer,
                     const struct aob_options *options, struct aob_error *error)
{
    *screen = (struct aob_screen){.gpu = gpu, .gbuffer = gbuffer};
    struct aob_encoding *encoding = &screen->encoding;
    uint32_t uses = use_of(kind_of((enum aob_fetch)options->fetch));
    if (!aob_encoding_init(encoding, options, gbuffer, error))
        return false;
    screen->depth = upload(screen, uses, aob_encoding_depth_format(encoding),
                           aob_encoding_depth_texels(encoding, gbuffer), error);
    if (aob_encoding_is_shared(encoding))
        screen->normal = screen->depth;
    else if (screen->depth && encoding->normals != AOB_NORMALS_FROM_DEPTH)
        screen->normal = upload(screen, uses, aob_encoding_normal_format(encoding),
                                aob_encoding_normal_texels(encoding, gbuffer), error);
    if (screen->depth && (screen->normal || encoding->normals == AOB_NORMALS_FROM_DEPTH))
        return true;
    aob_screen_finish(screen);
    return false;
}

void aob_screen_finish(struct aob_screen *screen)
{
    if (screen->gpu && screen->normal != screen->depth)
        aob_gpu_texture_destroy(screen->gpu, screen->normal);
    if (screen->gpu)
        aob_gpu_texture_destroy(screen->gpu, screen->depth);
    *screen = (struct aob_screen){0};
}

/* A table's texels as the module writes them; NULL of a target. */
static void *table_texels(const struct aob_graph_texture *texture, const void *values)
{
    if (!texture->fill)
        return NULL;
    void *texels =
        aob_alloc((size_t)texture->width * (size_t)texture->height, aob_gpu_texel_size(texture->format));
    texture->fill(values, texels);
    return texels;
}

/* What live passes do with a texture, so that a device may keep it in the form that suits just that. */
static uint32_t texture_uses(const struct aob_pass_graph *graph, int texture, enum aob_fetch fetch)
{
    uint32_t uses = 0;
    for (int i = 0; i < graph->pass_count; i++) {
        const struct aob_graph_pass *pass = &graph->passes[i];
        if (!pass->live)
            continue;
        if (pass->depth == texture)
            uses |= use_of(kind_of(fetch));
        for (int k = 0; k < pass->in_count; k++)
            if (pass->in[k].texture == texture)
                uses |= use_of(input_kind(&pass->in[k], fetch));
        for (int k = 0; k < pass->out_count; k++)
            if (pass->out[k].texture == texture)
                uses |= AOB_GPU_USE_TARGET;
    }
    for (int i = 0; i < AOB_OUTPUT_COUNT; i++)
        if (graph->outputs[i] == texture)
            uses |= AOB_GPU_USE_READ_BACK;
    return uses;
}

static bool create_textures(struct aob_frame *frame, const void *values, enum aob_fetch fetch,
                            struct aob_error *error)
{
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    for (int i = 0; i < frame->graph.texture_count; i++) {
        const struct aob_graph_texture *texture = &frame->graph.textures[i];
        int w, h;
        if (!texture->used)
            continue;
        aob_graph_texture_size(texture, view->width, view->height, &w, &h);
        void *texels = table_texels(texture, values);
        frame->textures[i] = aob_gpu_texture_create(
            frame->screen->gpu,
            &(struct aob_gpu_texture_desc){.format = texture->format,
                                           .width = w,
                                           .height = h,
                                           .uses = texture_uses(&frame->graph, i, fetch),
                                           .texels = texels},
            error);
        free(texels);
        if (!frame->textures[i])
            return aob_fail_in(error, "texture '%s'", texture->name);
        frame->memory_bytes += (size_t)w * (size_t)h * aob_gpu_texel_size(texture->format);
    }
    return true;
}

static struct aob_gpu_bind make_bind(enum aob_gpu_bind_kind kind, int binding, enum aob_filter filter,
                                     const struct aob_gpu_texture *texture)
{
    return (struct aob_gpu_bind){
        .kind = kind, .binding = (uint32_t)binding, .filter = filter, .texture = texture};
}

static size_t gather_binds(const struct aob_frame *frame, const struct aob_graph_pass *pass,
                           enum aob_fetch fetch, struct aob_gpu_bind binds[MAX_BINDS])
{
    enum aob_gpu_bind_kind kind = kind_of(fetch);
    size_t count = 0;
    if (pass->reads & AOB_DEPTH || (pass->reads && !frame->screen->normal))
        binds[count++] = make_bind(kind, AOB_BINDING_DEPTH, AOB_NEAREST, frame->screen->depth);
    if (pass->depth >= 0)
        binds[count++] = make_bind(kind, AOB_BINDING_OWN_DEPTH, AOB_NEAREST, frame->textures[pass->depth]);
    if ((pass->reads & AOB_NORMAL) && frame->screen->normal)
        binds[count++] = make_bind(kind, AOB_BINDING_NORMAL, AOB_NEAREST, frame->screen->normal);
    for (int i = 0; i < pass->in_count; i++)
        binds[count++] = make_bind(input_kind(&pass->in[i], fetch), AOB_BINDING_FIRST_INPUT + i,
                                   pass->in[i].filter, frame->textures[pass->in[i].texture]);
    if (pass->draw == AOB_TRIANGLES)
        binds[count++] =
            make_bind(AOB_GPU_SAMPLED, AOB_BINDING_TRIANGLES, AOB_NEAREST, frame->screen->geometry->texture);
    return count;
}

static bool create_program(struct aob_frame *frame, int index, const void *values, enum aob_fetch fetch,
                           struct aob_error *error)
{
    const struct aob_graph_pass *pass = &frame->graph.passes[index];
    const struct aob_prelude_desc desc = {&frame->graph, pass, values, &frame->screen->encoding, fetch};
    struct aob_text fragment = {0}, vertex = {0};
    struct aob_gpu *gpu = frame->screen->gpu;
    aob_prelude_write(&desc, &fragment);
    if (pass->draw == AOB_TRIANGLES)
        aob_prelude_write_vertex(&desc, &vertex);
    frame->programs[index] = pass->draw == AOB_TRIANGLES
                                 ? aob_gpu_program_create_geometry(gpu, vertex.data, fragment.data, error)
                                 : aob_gpu_program_create(gpu, fragment.data, error);
    aob_text_finish(&fragment);
    aob_text_finish(&vertex);
    return frame->programs[index] || aob_fail_in(error, "pass '%s', shader '%s'", pass->name, pass->shader);
}

static bool create_pass(struct aob_frame *frame, int index, const void *values, enum aob_fetch fetch,
                        struct aob_error *error)
{
    const struct aob_graph_pass *pass = &frame->graph.passes[index];
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    bool triangles = pass->draw == AOB_TRIANGLES;
    struct aob_gpu_bind binds[MAX_BINDS];
    struct aob_gpu_target targets[AOB_MAX_OUT];
    unsigned char block[AOB_UNIFORM_MAX];
    if (!create_program(frame, index, values, fetch, error))
        return false;
    for (int o = 0; o < pass->out_count; o++)
        targets[o] = (struct aob_gpu_target){frame->textures[pass->out[o].texture], 0};
    frame->passes[index] = aob_gpu_pass_create(
        frame->screen->gpu,
        &(struct aob_gpu_pass_desc){
            .program = frame->programs[index],
            .binds = binds,
            .bind_count = gather_binds(frame, pass, fetch, binds),
            .targets = targets,
            .target_count = (size_t)pass->out_count,
            .vertex_count = triangles ? pass->per_triangle * (uint32_t)frame->screen->geometry->count : 0,
            .blend = triangles ? AOB_GPU_ADD : AOB_GPU_REPLACE,
            .uniforms = block,
            .uniform_size =
                aob_prelude_uniforms(&frame->graph, pass, values, view, &frame->screen->encoding, block)},
        error);
    return frame->passes[index] || aob_fail_in(error, "pass '%s'", pass->name);
}

bool aob_frame_init(struct aob_frame *frame, const struct aob_screen *screen,
                    const struct aob_technique *technique, const void *values, enum aob_fetch fetch,
                    struct aob_error *error)
{
    *frame = (struct aob_frame){.screen = screen};
    bool ok = aob_graph_build(&frame->graph, technique, values, 1u << AOB_OUT_VISIBILITY, error);
    if (!ok)
        return false;
    ok = aob_geometry_serves(screen->geometry, &frame->graph, &screen->gbuffer->projection, error);
    frame->unfit = !ok;
    ok = ok && create_textures(frame, values, fetch, error);
    for (int i = 0; ok && i < frame->graph.pass_count; i++)
        if (frame->graph.passes[i].live)
            ok = create_pass(frame, i, values, fetch, error);
    if (!ok) {
        aob_fail_in(error, "%s", technique->name);
        aob_frame_finish(frame);
    }
    return ok;
}

void aob_frame_finish(struct aob_frame *frame)
{
    if (!frame->screen)
        return;
    struct aob_gpu *gpu = frame->screen->gpu;
    for (int i = 0; i < AOB_MAX_PASS; i++) {
        aob_gpu_pass_destroy(gpu, frame->passes[i]);
        aob_gpu_program_destroy(gpu, frame->programs[i]);
    }
    for (int i = 0; i < AOB_MAX_TEXTURE; i++)
        aob_gpu_texture_destroy(gpu, frame->textures[i]);
    frame->screen = NULL;
}

bool aob_frame_run(struct aob_frame *frame, struct aob_gpu_time *times, struct aob_error *error)
{
    for (int i = 0; i < frame->graph.pass_count; i++) {
        if (times)
            times[i] = (struct aob_gpu_time){0};
        if (frame->passes[i] &&
            !aob_gpu_pass_run(frame->screen->gpu, frame->passes[i], times ? &times[i] : NULL, error))
            return aob_fail_in(error, "%s: pass '%s'", frame->graph.technique->name,
                               frame->graph.passes[i].name);
    }
    return true;
}

static float first_component(const unsigned char *texel, enum aob_format format)
{
    uint16_t half;
    float whole;
    switch (format) {
    case AOB_R8:
    case AOB_RG8:
    case AOB_RGBA8:
        return (float)*texel / 255.0f;
    case AOB_R16:
        memcpy(&half, texel, sizeof half);
        return (float)half / 65535.0f;
    case AOB_R16F:
    case AOB_RG16F:
    case AOB_RGBA16F:
        memcpy(&half, texel, sizeof half);
        return aob_half_to_float(half);
    default:
        memcpy(&whole, texel, sizeof whole);
        return whole;
    }
}

bool aob_frame_read(struct aob_frame *frame, enum aob_output which, float *pixels, struct aob_error *error)
{
    const struct aob_gpu_texture *texture = frame->textures[frame->graph.outputs[which]];
    size_t size = aob_gpu_texel_size(texture->format), w = (size_t)texture->width,
           h = (size_t)texture->height;
    size_t guard = (size_t)frame->screen->gbuffer->guard, inner = w - 2 * guard;
    unsigned char *texels = aob_alloc(w * h, size);
    bool ok = aob_gpu_texture_read(frame->screen->gpu, texture, 0, texels, error);
    for (size_t y = guard; ok && y < h - guard; y++)
        for (size_t x = guard; x < w - guard; x++)
            pixels[(y - guard) * inner + x - guard] =
                first_component(texels + (y * w + x) * size, texture->format);
    free(texels);
    return ok;
}
