#include "frame.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "past.h"
#include "planes.h"
#include "prelude.h"
#include "programs.h"

enum { MAX_BINDS = AOB_MAX_IN + 7 };

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

static bool create_texture(struct aob_frame *frame, int index, struct aob_gpu_texture **into,
                           struct aob_error *error)
{
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    const struct aob_graph_texture *texture = &frame->graph.textures[index];
    int w, h;
    aob_graph_texture_size(texture, view->width, view->height, &w, &h);
    void *texels = table_texels(texture, frame->values);
    const struct aob_gpu_texture_desc desc = {.format = texture->format,
                                              .width = w,
                                              .height = h,
                                              .levels = texture->levels,
                                              .uses = texture_uses(&frame->graph, index, frame->fetch) |
                                                      (frame->readable ? AOB_GPU_USE_READ_BACK : 0),
                                              .texels = texels};
    frame->unfit = !aob_gpu_texture_fits(frame->screen->gpu, &desc, error);
    *into = aob_gpu_texture_create(frame->screen->gpu, &desc, error);
    free(texels);
    if (!*into)
        return aob_fail_in(error, "texture '%s'", texture->name);
    frame->memory_bytes +=
        aob_graph_texture_texels(texture, view->width, view->height) * aob_gpu_texel_size(texture->format);
    return true;
}

static bool create_textures(struct aob_frame *frame, const struct aob_past *past, struct aob_error *error)
{
    for (int i = 0; i < frame->graph.texture_count; i++) {
        const struct aob_graph_texture *texture = &frame->graph.textures[i];
        if ((texture->used && !create_texture(frame, i, &frame->textures[i], error)) ||
            (texture->kept && !frame->follows && !create_texture(frame, i, &frame->earlier[i], error)))
            return false;
        if (frame->follows)
            frame->earlier[i] = past->left[i];
    }
    return true;
}

static struct aob_gpu_bind make_bind(enum aob_gpu_bind_kind kind, int binding, enum aob_filter filter,
                                     const struct aob_gpu_texture *texture)
{
    return (struct aob_gpu_bind){
        .kind = kind, .binding = (uint32_t)binding, .filter = filter, .texture = texture, .level_count = 1};
}

/* What a pass finds as a texture of the graph, in its first form or turned. */
static const struct aob_gpu_texture *texture_of(const struct aob_frame *frame,
                                                const struct aob_graph_bind *bind, bool turned)
{
    return frame->graph.textures[bind->texture].kept && bind->previous != turned
               ? frame->earlier[bind->texture]
               : frame->textures[bind->texture];
}

/* The depth and normal, materials and velocity of the screen. */
static size_t gather_screen(const struct aob_frame *frame, const struct aob_graph_pass *pass,
                            struct aob_gpu_bind binds[MAX_BINDS])
{
    const struct aob_screen *screen = frame->screen;
    enum aob_gpu_bind_kind kind = kind_of(frame->fetch, AOB_NEAREST, 1);
    size_t count = 0;
    if (pass->reads & AOB_DEPTH || (pass->reads && !screen->normal))
        binds[count++] = make_bind(kind, AOB_BINDING_DEPTH, AOB_NEAREST, screen->depth);
    if ((pass->reads & AOB_NORMAL) && screen->normal)
        binds[count++] = make_bind(kind, AOB_BINDING_NORMAL, AOB_NEAREST, screen->normal);
    if (pass->reads & AOB_VELOCITY)
        binds[count++] = make_bind(kind, AOB_BINDING_VELOCITY, AOB_NEAREST, screen->velocity);
    if (pass->reads & AOB_MATERIAL) {
        binds[count++] = make_bind(kind, AOB_BINDING_ALBEDO, AOB_NEAREST, screen->albedo);
        binds[count++] = make_bind(kind, AOB_BINDING_SHINE, AOB_NEAREST, screen->shine);
    }
    return count;
}

static size_t gather_binds(const struct aob_frame *frame, const struct aob_graph_pass *pass, bool turned,
                           struct aob_gpu_bind binds[MAX_BINDS])
{
    size_t count = gather_screen(frame, pass, binds);
    if (pass->depth >= 0) {
        const struct aob_graph_bind depth = {.texture = pass->depth};
        binds[count] = make_bind(kind_of(frame->fetch, AOB_NEAREST, pass->depth_levels),
                                 AOB_BINDING_OWN_DEPTH, AOB_NEAREST, texture_of(frame, &depth, turned));
        binds[count++].level_count = pass->depth_levels;
    }
    for (int i = 0; i < pass->in_count; i++) {
        const struct aob_graph_bind *in = &pass->in[i];
        binds[count] = make_bind(input_kind(in, frame->fetch), AOB_BINDING_FIRST_INPUT + i, in->filter,
                                 texture_of(frame, in, turned));
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
                                     .then = &frame->screen->then,
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

/* In its first form, or turned; the program is made with the first. */
static bool create_form(struct aob_frame *frame, int index, bool turned, struct aob_error *error)
{
    const struct aob_graph_pass *pass = &frame->graph.passes[index];
    const struct aob_prelude_desc prelude = prelude_of(frame, index);
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    bool triangles = pass->draw == AOB_TRIANGLES;
    struct aob_gpu_pass **into = turned ? &frame->turned[index] : &frame->passes[index];
    struct aob_gpu_bind binds[MAX_BINDS];
    struct aob_gpu_target targets[AOB_MAX_OUT];
    unsigned char block[AOB_UNIFORM_MAX];
    for (int o = 0; o < pass->out_count; o++)
        targets[o] = (struct aob_gpu_target){texture_of(frame, &pass->out[o], turned), pass->out[o].level};
    struct aob_gpu_pass_desc desc = {
        .binds = binds,
        .bind_count = gather_binds(frame, pass, turned, binds),
        .targets = targets,
        .target_count = (size_t)pass->out_count,
        .vertex_count = triangles ? pass->per_triangle * (uint32_t)frame->screen->geometry->count : 0,
        .blend = triangles ? AOB_GPU_ADD : AOB_GPU_REPLACE,
        .uniforms = block,
        .uniform_size = aob_prelude_uniforms(&prelude, view, frame->number, block),
        .storage = frame->storage,
        .in_parts = frame->storage};
    aob_graph_divided(view->width, view->height, aob_graph_target_divisor(&frame->graph, pass), &desc.width,
                      &desc.height);
    frame->unfit = !aob_gpu_pass_fits(frame->screen->gpu, &desc, error);
    if (frame->unfit)
        return aob_fail_in(error, "pass '%s'", pass->name);
    if (!frame->programs[index] && !create_program(frame, index, error))
        return false;
    desc.program = frame->programs[index];
    *into = aob_gpu_pass_create(frame->screen->gpu, &desc, error);
    return *into || aob_fail_in(error, "pass '%s'", pass->name);
}

/* Whether a pass reads or writes one of the textures that are kept. */
static bool turns(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass)
{
    bool kept = pass->depth >= 0 && graph->textures[pass->depth].kept;
    for (int i = 0; i < pass->in_count; i++)
        kept = kept || graph->textures[pass->in[i].texture].kept;
    for (int o = 0; o < pass->out_count; o++)
        kept = kept || graph->textures[pass->out[o].texture].kept;
    return kept;
}

static bool create_pass(struct aob_frame *frame, int index, struct aob_error *error)
{
    return create_form(frame, index, false, error) &&
           (frame->follows || !turns(&frame->graph, &frame->graph.passes[index]) ||
            create_form(frame, index, true, error));
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
    frame->follows = desc->past && aob_graph_keeps_history(&frame->graph);
    frame->number = frame->follows ? desc->past->number + 1 : 0;
    bool ok = aob_geometry_serves(screen->geometry, &frame->graph, &screen->gbuffer->projection, error);
    frame->unfit = !ok;
    if (ok) {
        ok = aob_screen_provide(screen, aob_graph_reads(&frame->graph), error);
        frame->unfit = screen->unfit;
    }
    ok = ok && (!frame->planes || aob_planes_init(frame->planes, &frame->graph, screen, error));
    ok = ok && create_textures(frame, desc->past, error);
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
        aob_gpu_pass_destroy(gpu, frame->turned[i]);
        if (!frame->lender)
            aob_gpu_program_destroy(gpu, frame->programs[i]);
    }
    for (int i = 0; i < AOB_MAX_TEXTURE; i++) {
        aob_gpu_texture_destroy(gpu, frame->textures[i]);
        if (!frame->follows)
            aob_gpu_texture_destroy(gpu, frame->earlier[i]);
    }
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

static bool set_uniforms(struct aob_frame *frame, int index, struct aob_error *error)
{
    const struct aob_prelude_desc prelude = prelude_of(frame, index);
    struct aob_gpu *gpu = frame->screen->gpu;
    unsigned char block[AOB_UNIFORM_MAX];
    if (!frame->passes[index])
        return true;
    size_t size = aob_prelude_uniforms(&prelude, &frame->screen->gbuffer->projection, frame->number, block);
    return aob_gpu_pass_set_uniforms(gpu, frame->passes[index], block, size, error) &&
           (!frame->turned[index] ||
            aob_gpu_pass_set_uniforms(gpu, frame->turned[index], block, size, error));
}

bool aob_frame_set(struct aob_frame *frame, int number, const void *values, struct aob_error *error)
{
    const struct aob_technique *technique = frame->graph.technique;
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
    frame->number = number;
    for (int i = 0; i < frame->graph.pass_count; i++)
        if (!set_uniforms(frame, i, error))
            return aob_fail_in(error, "%s: pass '%s'", technique->name, frame->graph.passes[i].name);
    return true;
}
