/* Unsharp mask of the depth buffer: Luft, Colditz, Deussen, "Image Enhancement by Unsharp Masking the Depth
 * Buffer", SIGGRAPH 2006. A pixel is darkened by as much as its surroundings, blurred, lie before it. Two
 * departures: depths are compared in units of `radius` and no further than that (the text's depths end at 1), and
 * the Gaussian blur is sampled in pairs of opposite taps, then smoothed. */
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius, kernel, strength;
    int32_t samples, blur;
};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5, .doc = "Depth difference that counts in full; more lightens shallow steps."),
    AOB_PARAM(struct values, kernel, .unit = AOB_UNIT_PIXEL, .scale = AOB_LOG2, .min = 1, .max = 512,
              .initial = 32, .doc = "Two standard deviations of the text's Gaussian G; more widens shade."),
    AOB_PARAM(struct values, strength, .min = 0, .max = 100, .initial = 1,
              .doc = "The text's lambda, scales what is subtracted from 1; more darkens."),
    AOB_PARAM(struct values, samples, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 1024, .initial = 8, .doc = "Pairs of opposite taps; more lowers noise."),
    AOB_PARAM_BLUR(struct values, blur, 5),
};

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex raw = aob_texture(graph, .name = "visibility", .format = AOB_R16F);
    return aob_pass(graph, .name = "unsharp", .shader = "unsharp", .reads = AOB_DEPTH, .border = AOB_FAR,
                    .out = {{.name = "visibility", .tex = raw}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY,
                      aob_step_blur(graph, .tex = raw, .taps = v->blur, .divisor = 1));
}

/* The text derives no integral. The nearest honest claim is what the picture is taken for: cosine-weighted
 * visibility within `radius`, its shade times `strength`. */
static float map(const void *values, float visibility)
{
    const struct values *v = values;
    return fmaxf(0, 1 - v->strength * (1 - visibility));
}

AOB_TECHNIQUE(depth_unsharp, .title = "Unsharp mask of the depth buffer", .revision = 1,
              .citation = "Luft, Colditz, Deussen: Image Enhancement by Unsharp Masking the Depth Buffer, "
                          "SIGGRAPH 2006",
              .params = params, .param_count = sizeof params / sizeof *params,
              .values_size = sizeof(struct values), .shaders = aob_shaders_depth_unsharp,
              .definition = {.weight = AOB_WEIGHT_COSINE, .map = map},
              .sampling = {"samples", AOB_SEQUENCE_STRATIFIED}, .build = build);
AOB_MODULE(&aob_technique_depth_unsharp);
