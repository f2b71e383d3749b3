/* For the tests of `stress`: one technique that keeps every property, and builds of it that have a single fault each, which
 * the property of the fault's name must catch (caught.txt has the lists). FAULT is a number of
 * shaders/fault.glsl; 0 is the sound one. */
#include <aobudget/steps.h>
#include <string.h>
#include "shaders.h"

struct values {
    float radius, falloff;
    int32_t slices, steps, blur, divisor, history;
};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5, .doc = "Farthest distance of an occluder."),
    AOB_PARAM(struct values, falloff, .min = 0, .max = 1, .initial = 0.3,
              .doc = "Share of the radius over which occlusion fades out."),
    AOB_PARAM(struct values, slices, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 1, .max = 64,
              .initial = 4, .doc = "Slices about the view vector."),
    AOB_PARAM(struct values, steps, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 1, .max = 64,
              .initial = 8, .doc = "Taps on each side of a slice."),
    AOB_PARAM_BLUR(struct values, blur, 3),
    AOB_PARAM_DIVISOR(struct values, divisor),
    AOB_PARAM_HISTORY(struct values, history),
};

enum { LEVELS = 2 };

static float falloff(const void *values, float t)
{
    const struct values *v = values;
    return v->falloff > 0 && (1 - t) / v->falloff < 1 ? (1 - t) / v->falloff : 1;
}

/* Level l holds the depth of every (1 << l)th pixel, so that each texel is an exact point of a surface. */
static aob_tex lay_pyramid(struct aob_graph *graph)
{
    static const char *const names[LEVELS] = {"level_0", "level_1"};
    aob_tex pyramid = aob_texture(graph, .name = "pyramid", .format = AOB_R32F, .levels = LEVELS);
    aob_pass(graph, .name = names[0], .shader = "first", .reads = AOB_DEPTH,
             .out = {{.name = "depth", .tex = pyramid}});
    for (uint32_t l = 1; l < LEVELS; l++)
        aob_pass(graph, .name = names[l], .shader = "coarser",
                 .in = {{.name = "finer", .tex = pyramid, .level = l - 1}},
                 .out = {{.name = "depth", .tex = pyramid, .level = l}});
    return pyramid;
}

static aob_tex lay_soften(struct aob_graph *graph, aob_tex raw, const struct values *v)
{
    if (v->blur == 0)
        return raw;
    aob_tex soft = aob_texture(graph, .name = "soft", .format = aob_open_format(aob_open_kind(graph)),
                               .divisor = (uint32_t)v->divisor);
    aob_pass(graph, .name = "soften", .shader = "soften", .reads = AOB_DEPTH | AOB_NORMAL,
             .defines = {{"FAULT", FAULT}}, .in = {{.name = "raw", .tex = raw}},
             .out = {{.name = "softened", .tex = soft}});
    return soft;
}

/* The fault BILINEAR_UPSAMPLING has a pass of its own, and all others the shared one. */
static aob_tex lay_upsample(struct aob_graph *graph, aob_tex low, const struct values *v)
{
    enum { BILINEAR_UPSAMPLING = 23 };
    if (FAULT != BILINEAR_UPSAMPLING || v->divisor == 1)
        return aob_step_upsample(graph, .tex = low, .divisor = v->divisor, .output = aob_open_kind(graph));
    aob_tex full = aob_texture(graph, .name = "full", .format = aob_open_format(aob_open_kind(graph)));
    aob_pass(graph, .name = "bilinear", .shader = "bilinear", .reads = AOB_DEPTH,
             .in = {{.name = "low", .tex = low}}, .out = {{.name = "full", .tex = full}});
    return full;
}

/* The mean over time: the shared step, or one with a fault. */
static aob_tex lay_mean(struct aob_graph *graph, aob_tex now, const struct values *v)
{
    enum { KEEPS_EVERYTHING = 54, FORGETS_AT_ONCE = 55 };
    if (v->history <= 1 || (FAULT != KEEPS_EVERYTHING && FAULT != FORGETS_AT_ONCE))
        return aob_step_temporal(
            graph, .tex = now, .frames = v->history, .output = aob_open_kind(graph),
            .changes = aob_step_changes(graph, .frames = v->history, .taps = v->blur, .divisor = v->divisor));
    aob_tex mean = aob_texture(graph, .name = "mean", .format = AOB_RGBA32F);
    if (aob_open_kind(graph) == AOB_OUT_VISIBILITY)
        mean = aob_texture(graph, .name = "mean_share", .format = AOB_R32F);
    aob_pass(graph, .name = "mean", .shader = "mean", .defines = {{"FAULT", FAULT}},
             .in = {{.name = "now", .tex = now}, {.name = "before", .tex = aob_previous(graph, mean)}},
             .out = {{.name = "mean", .tex = mean}});
    return mean;
}

enum { LIGHT_ALWAYS = 52 }; /* the fault that lays for nobody */

/* Visibility after bounces. With its fault visibility goes through the pass as well, so that it is always laid. */
static aob_tex lay_bounces(struct aob_graph *graph, aob_tex open)
{
    bool always = FAULT == LIGHT_ALWAYS;
    if (!always && !aob_wants(graph, AOB_OUT_VISIBILITY_RGB))
        return open;
    aob_tex bounced = aob_texture(graph, .name = "bounces", .format = AOB_RGBA16F);
    struct aob_pass pass = {.name = "bounces",
                            .shader = "bounces",
                            .reads = AOB_DEPTH | AOB_MATERIAL,
                            .defines = {{"FAULT", FAULT}},
                            .in = {{.name = "open", .tex = open}},
                            .out = {{.name = "bounced", .tex = bounced}}};
    if (always) {
        open = aob_texture(graph, .name = "kept", .format = aob_open_format(aob_open_kind(graph)));
        pass.out[1] = (struct aob_bind){.name = "kept", .tex = open};
    }
    aob_pass_add(graph, &pass);
    aob_output(graph, AOB_OUT_VISIBILITY_RGB, bounced);
    return open;
}

/* One pass and one texture for an output that is wanted, of the name of both. */
static void lay_effect(struct aob_graph *graph, enum aob_output which, const struct aob_tex_desc *desc,
                       uint32_t reads, aob_tex open)
{
    if (!aob_wants(graph, which))
        return;
    aob_tex texture = aob_texture(graph, .name = desc->name, .format = desc->format);
    aob_pass(graph, .name = desc->name, .shader = desc->name, .reads = AOB_DEPTH | AOB_NORMAL | reads,
             .defines = {{"FAULT", FAULT}}, .in = {{.name = "open", .tex = open}},
             .out = {{.name = desc->name, .tex = texture}});
    aob_output(graph, which, texture);
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex pyramid = lay_pyramid(graph);
    aob_tex raw = aob_texture(graph, .name = "visibility", .format = aob_open_format(aob_open_kind(graph)),
                              .divisor = (uint32_t)v->divisor);
    aob_pass(graph, .name = "horizon", .shader = "horizon", .reads = AOB_DEPTH | AOB_NORMAL, .depth = pyramid,
             .border = AOB_FAR,
             .defines = {{"FAULT", FAULT},
                         {"BENT", aob_wants(graph, AOB_OUT_BENT_NORMAL)},
                         {"LIGHT", aob_wants(graph, AOB_OUT_IRRADIANCE)}},
             .out = {{.name = "visibility", .tex = raw}});
    aob_tex open = lay_mean(graph, lay_upsample(graph, lay_soften(graph, raw, v), v), v);
    open = lay_bounces(graph, open);
    lay_effect(graph, AOB_OUT_SPECULAR, &(struct aob_tex_desc){.name = "specular", .format = AOB_R16F},
               AOB_MATERIAL, open);
    lay_effect(graph, AOB_OUT_IRRADIANCE, &(struct aob_tex_desc){.name = "irradiance", .format = AOB_RGBA16F},
               AOB_LIGHT, open);
    return aob_open_outputs(graph, aob_open_kind(graph), open);
}

AOB_TECHNIQUE(broken, .title = "Horizons, sound or with one fault", .citation = "tests", .revision = 1,
              .params = params, .param_count = sizeof params / sizeof *params,
              .values_size = sizeof(struct values), .shaders = aob_shaders_broken,
              .definition = {.weight = AOB_WEIGHT_COSINE, .falloff = falloff}, .build = build);
AOB_MODULE(&aob_technique_broken);
