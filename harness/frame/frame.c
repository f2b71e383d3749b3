#include "frame.h"
#include <stdlib.h>
#include <string.h>
#include "base/half.h"
#include "base/memory.h"
#include "planes.h"
#include "prelude.h"
#include "programs.h"

enum { MAX_BINDS = AOB_MAX_IN + 6 };

static uint32_t use_of(enum aob_gpu_bind_kind kind)
{
    return kind == AOB_GPU_STORAGE ? AOB_GPU_USE_STORAGE : AOB_GPU_USE_SAMPLED;
}

static enum aob_gpu_bind_kind kind_of(enum aob_fetch fetch, enum aob_filter filter, int levels)
{
    return aob_prelude_is_storage(fetch, filter, levels) ? AOB_GPU_STORAGE : AOB_GPU_SAMPLED;
}

static enum aob_gpu_bind_kind input_kind(const struct aob_graph_bind *in, enum aob_fetch fetch)
{
    return kind_of(fetch, in->filter, in->level_count);
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
            uses |= use_of(kind_of(fetch, AOB_NEAREST, pass->depth_levels));
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
    if (graph->clear == texture)
        uses |= AOB_GPU_USE_READ_BACK;
    return uses;
}

static bool create_textures(struct aob_frame *frame, struct aob_error *error)
{
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    for (int i = 0; i < frame->graph.texture_count; i++) {
        const struct aob_graph_texture *texture = &frame->graph.textures[i];
        int w, h;
        if (!texture->used)
            continue;
        aob_graph_texture_size(texture, view->width, view->height, &w, &h);
        void *texels = table_texels(texture, frame->values);
        const struct aob_gpu_texture_desc desc = {.format = texture->format,
                                                  .width = w,
                                                  .height = h,
                                                  .levels = texture->levels,
                                                  .uses = texture_uses(&frame->graph, i, frame->fetch) |
                                                          (frame->readable ? AOB_GPU_USE_READ_BACK : 0),
                                                  .texels = texels};
        frame->unfit = !aob_gpu_texture_fits(frame->screen->gpu, &desc, error);
        frame->textures[i] = aob_gpu_texture_create(frame->screen->gpu, &desc, error);
        free(texels);
        if (!frame->textures[i])
            return aob_fail_in(error, "texture '%s'", texture->name);
        frame->memory_bytes += aob_graph_texture_texels(texture, view->width, view->height) *
                               aob_gpu_texel_size(texture->format);
    }
    return true;
}

static struct aob_gpu_bind make_bind(enum aob_gpu_bind_kind kind, int binding, enum aob_filter filter,
                                     const struct aob_gpu_texture *texture)
{
    return (struct aob_gpu_bind){
        .kind = kind, .binding = (uint32_t)binding, .filter = filter, .texture = texture, .level_count = 1};
}

static size_t gather_binds(const struct aob_frame *frame, const struct aob_graph_pass *pass,
                           struct aob_gpu_bind binds[MAX_BINDS])
{
    enum aob_gpu_bind_kind kind = kind_of(frame->fetch, AOB_NEAREST, 1);
    size_t count = 0;
    if (pass->reads & AOB_DEPTH || (pass->reads && !frame->screen->normal))
        binds[count++] = make_bind(kind, AOB_BINDING_DEPTH, AOB_NEAREST, frame->screen->depth);
    if (pass->depth >= 0) {
        binds[count] = make_bind(kind_of(frame->fetch, AOB_NEAREST, pass->depth_levels),
                                 AOB_BINDING_OWN_DEPTH, AOB_NEAREST, frame->textures[pass->depth]);
        binds[count++].level_count = pass->depth_levels;
    }
    if ((pass->reads & AOB_NORMAL) && frame->screen->normal)
        binds[count++] = make_bind(kind, AOB_BINDING_NORMAL, AOB_NEAREST, frame->screen->normal);
    if (pass->reads & AOB_MATERIAL) {
        binds[count++] = make_bind(kind, AOB_BINDING_ALBEDO, AOB_NEAREST, frame->screen->albedo);
        binds[count++] = make_bind(kind, AOB_BINDING_SHINE, AOB_NEAREST, frame->screen->shine);
    }
    for (int i = 0; i < pass->in_count; i++) {
        const struct aob_graph_bind *in = &pass->in[i];
        binds[count] = make_bind(input_kind(in, frame->fetch), AOB_BINDING_FIRST_INPUT + i, in->filter,
                                 frame->textures[in->texture]);
        binds[count].first_level = in->level;
        binds[count].vertex = pass->draw == AOB_TRIANGLES; /* as aob_prelude_write_vertex declares it */
        binds[count++].level_count = in->level_count;
    }
    if (pass->draw == AOB_TRIANGLES) {
        binds[count] =
            make_bind(AOB_GPU_SAMPLED, AOB_BINDING_TRIANGLES, AOB_NEAREST, frame->screen->geometry->texture);
        binds[count++].vertex = true;
    }
    return count;
}

static struct aob_prelude_desc prelude_of(const struct aob_frame *frame, int index)
{
    return (struct aob_prelude_desc){.graph = &frame->graph,
                                     .pass = &frame->graph.passes[index],
                                     .values = frame->values,
                                     .encoding = &frame->screen->encoding,
                                     .fetch = frame->fetch,
                                     .light = &frame->screen->light,
                                     .planes = frame->planes};
}

static bool create_program(struct aob_frame *frame, int index, struct aob_error *error)
{
    const struct aob_graph_pass *pass = &frame->graph.passes[index];
    const struct aob_prelude_desc desc = prelude_of(frame, index);
    struct aob_text fragment = {0}, vertex = {0};
    aob_prelude_write(&desc, &fragment);
    if (pass->draw == AOB_TRIANGLES)
        aob_prelude_write_vertex(&desc, &vertex);
    const struct aob_gpu_program_desc program = {.vertex = vertex.data, /* NULL where there is none */
                                                 .fragment = fragment.data,
                                                 .rewrite = frame->rewrites ? &frame->rewrites[index] : NULL};
    frame->programs[index] = frame->lender ? aob_programs_lend(frame->lender, &program, error)
                                           : aob_gpu_program_create_desc(frame->screen->gpu, &program, error);
    aob_text_finish(&fragment);
    aob_text_finish(&vertex);
    if (!frame->programs[index] && pass->draw == AOB_TRIANGLES)
        return aob_fail_in(error, "pass '%s', shaders '%s' (vertex) and '%s' (fragment)", pass->name,
                           pass->vertex, pass->shader);
    return frame->programs[index] || aob_fail_in(error, "pass '%s', shader '%s'", pass->name, pass->shader);
}

static bool create_pass(struct aob_frame *frame, int index, struct aob_error *error)
{
    const struct aob_graph_pass *pass = &frame->graph.passes[index];
    const struct aob_prelude_desc prelude = prelude_of(frame, index);
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    bool triangles = pass->draw == AOB_TRIANGLES;
    struct aob_gpu_bind binds[MAX_BINDS];
    struct aob_gpu_target targets[AOB_MAX_OUT];
    unsigned char block[AOB_UNIFORM_MAX];
    for (int o = 0; o < pass->out_count; o++)
        targets[o] = (struct aob_gpu_target){frame->textures[pass->out[o].texture], pass->out[o].level};
    struct aob_gpu_pass_desc desc = {
        .binds = binds,
        .bind_count = gather_binds(frame, pass, binds),
        .targets = targets,
        .target_count = (size_t)pass->out_count,
        .vertex_count = triangles ? pass->per_triangle * (uint32_t)frame->screen->geometry->count : 0,
        .blend = triangles ? AOB_GPU_ADD : AOB_GPU_REPLACE,
        .uniforms = block,
        .uniform_size = aob_prelude_uniforms(&prelude, view, 0, block),
        .storage = frame->storage,
        .in_parts = frame->storage};
    aob_graph_divided(view->width, view->height, aob_graph_target_divisor(&frame->graph, pass), &desc.width,
                      &desc.height);
    frame->unfit = !aob_gpu_pass_fits(frame->screen->gpu, &desc, error);
    if (frame->unfit)
        return aob_fail_in(error, "pass '%s'", pass->name);
    if (!create_program(frame, index, error))
        return false;
    desc.program = frame->programs[index];
    frame->passes[index] = aob_gpu_pass_create(frame->screen->gpu, &desc, error);
    return frame->passes[index] || aob_fail_in(error, "pass '%s'", pass->name);
}

bool aob_frame_init_desc(struct aob_frame *frame, struct aob_screen *screen,
                         const struct aob_frame_desc *desc, struct aob_error *error)
{
    const struct aob_technique *technique = desc->technique;
    *frame = (struct aob_frame){.screen = screen,
                                .fetch = desc->fetch,
                                .readable = desc->readable,
                                .lender = desc->rewrites ? NULL : desc->programs,
                                .planes = desc->planes,
                                .rewrites = desc->rewrites,
                                .storage = desc->storage};
    memcpy(frame->values, desc->values, technique->values_size);
    if (!aob_graph_build(&frame->graph, technique, desc->values, desc->wanted, error))
        return false;
    bool ok = aob_geometry_serves(screen->geometry, &frame->graph, &screen->gbuffer->projection, error);
    frame->unfit = !ok;
    if (ok) {
        ok = aob_screen_provide(screen, aob_graph_reads(&frame->graph), error);
        frame->unfit = screen->unfit;
    }
    ok = ok && (!frame->planes || aob_planes_init(frame->planes, &frame->graph, screen, error));
    ok = ok && create_textures(frame, error);
    for (int i = 0; ok && i < frame->graph.pass_count; i++)
        if (frame->graph.passes[i].live)
            ok = create_pass(frame, i, error);
    if (!ok) {
        aob_fail_in(error, "%s", technique->name);
        aob_frame_finish(frame);
    }
    return ok;
}

bool aob_frame_init(struct aob_frame *frame, struct aob_screen *screen, const struct aob_technique *technique,
                    const void *values, enum aob_fetch fetch, struct aob_error *error)
{
    return aob_frame_init_desc(
        frame, screen, &(struct aob_frame_desc){.technique = technique, .values = values, .fetch = fetch},
        error);
}

void aob_frame_finish(struct aob_frame *frame)
{
    if (!frame->screen)
        return;
    struct aob_gpu *gpu = frame->screen->gpu;
    for (int i = 0; i < AOB_MAX_PASS; i++) {
        aob_gpu_pass_destroy(gpu, frame->passes[i]);
        if (!frame->lender)
            aob_gpu_program_destroy(gpu, frame->programs[i]);
    }
    for (int i = 0; i < AOB_MAX_TEXTURE; i++)
        aob_gpu_texture_destroy(gpu, frame->textures[i]);
    frame->screen = NULL;
}

/* build() and check() see uniforms as well: a radius may decide how far triangles reach. Whether these values would lay
 * out the frame that there is. */
static bool lays_the_same(const struct aob_frame *frame, const void *values, struct aob_error *error)
{
    const struct aob_technique *technique = frame->graph.technique;
    struct aob_pass_graph *graph = AOB_NEW(struct aob_pass_graph);
    char before[AOB_KEY_SIZE], after[AOB_KEY_SIZE];
    bool ok = aob_graph_build(graph, technique, values, frame->graph.wanted, error);
    if (ok) {
        aob_graph_digest(&frame->graph, frame->values, before);
        aob_graph_digest(graph, values, after);
        bool same = strcmp(before, after) == 0;
        for (int p = 0; same && p < graph->pass_count; p++)
            same = graph->passes[p].reach == frame->graph.passes[p].reach;
        ok = same || aob_fail(error, "%s: these values lay out other passes: they need another frame",
                              technique->name);
    }
    free(graph);
    return ok;
}

bool aob_frame_set(struct aob_frame *frame, int number, const void *values, struct aob_error *error)
{
    const struct aob_technique *technique = frame->graph.technique;
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    unsigned char block[AOB_UNIFORM_MAX];
    for (uint32_t i = 0; i < technique->param_count; i++) {
        const struct aob_param *param = &technique->params[i];
        if (param->stage != AOB_UNIFORM &&
            memcmp(frame->values + param->offset, (const char *)values + param->offset, 4) != 0)
            return aob_fail(error, "%s: parameter '%s' is no uniform: another value needs another frame",
                            technique->name, param->name);
    }
    if (!lays_the_same(frame, values, error))
        return false;
    memcpy(frame->values, values, technique->values_size);
    for (int i = 0; i < frame->graph.pass_count; i++) {
        const struct aob_prelude_desc prelude = prelude_of(frame, i);
        size_t size = frame->passes[i] ? aob_prelude_uniforms(&prelude, view, number, block) : 0;
        if (size && !aob_gpu_pass_set_uniforms(frame->screen->gpu, frame->passes[i], block, size, error))
            return aob_fail_in(error, "%s: pass '%s'", technique->name, frame->graph.passes[i].name);
    }
    return true;
}

bool aob_frame_run(struct aob_frame *frame, int repeats, struct aob_frame_time *time, struct aob_error *error)
{
    struct aob_gpu_pass *passes[AOB_MAX_PASS];
    struct aob_gpu_time times[AOB_MAX_PASS], whole;
    size_t count = 0;
    for (int i = 0; i < frame->graph.pass_count; i++)
        if (frame->passes[i])
            passes[count++] = frame->passes[i];
    const struct aob_gpu_run_desc desc = {passes, count, repeats};
    if (!aob_gpu_run(frame->screen->gpu, &desc, times, &whole, error))
        return aob_fail_in(error, "%s", frame->graph.technique->name);
    if (!time)
        return true;
    *time = (struct aob_frame_time){.whole = whole};
    count = 0;
    for (int i = 0; i < frame->graph.pass_count; i++)
        if (frame->passes[i])
            time->passes[i] = times[count++];
    return true;
}

static float component(const unsigned char *texel, enum aob_format format, int c)
{
    uint16_t half;
    float whole;
    switch (format) {
    case AOB_R8:
    case AOB_RG8:
    case AOB_RGBA8:
        return (float)texel[c] / 255.0f;
    case AOB_R16:
        memcpy(&half, texel + 2 * c, sizeof half);
        return (float)half / 65535.0f;
    case AOB_R16F:
    case AOB_RG16F:
    case AOB_RGBA16F:
        memcpy(&half, texel + 2 * c, sizeof half);
        return aob_half_to_float(half);
    default:
        memcpy(&whole, texel + 4 * c, sizeof whole);
        return whole;
    }
}

bool aob_frame_read(struct aob_frame *frame, enum aob_output which, int components, float *pixels,
                    struct aob_error *error)
{
    const struct aob_gpu_texture *texture = frame->textures[frame->graph.outputs[which]];
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    size_t size = aob_gpu_texel_size(texture->format), stride = (size_t)texture->width;
    size_t guard = (size_t)frame->screen->gbuffer->guard, w = (size_t)view->width, h = (size_t)view->height;
    int first = aob_graph_output_component(&frame->graph, which);
    unsigned char *texels = aob_alloc(stride * (size_t)texture->height, size);
    bool ok = aob_gpu_texture_read(frame->screen->gpu, texture, 0, texels, error);
    for (size_t y = guard; ok && y < h - guard; y++)
        for (size_t x = guard; x < w - guard; x++)
            for (int c = 0; c < components; c++)
                *pixels++ = component(texels + (y * stride + x) * size, texture->format, first + c);
    free(texels);
    return ok;
}
