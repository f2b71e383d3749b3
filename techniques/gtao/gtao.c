/* Ground-truth ambient occlusion: Jimenez, Wu, Pesce, Jarabo, "Practical Real-Time Strategies for Accurate
 * Indirect Occlusion", ATVI-TR-19-01. Horizons on both sides of each slice, closed-form inner integral. */
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius, falloff;
    int32_t slices, steps, weighting, noise_index, divisor, depth_divisor, blur;
};

static const char *const weightings[] = {"cosine", "uniform", NULL};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5, .doc = "Farthest distance of an occluder; more darkens more and from farther."),
    AOB_PARAM(struct values, falloff, .min = 0, .max = 1, .initial = 0,
              .doc = "Share of the radius over which occlusion fades out; 0 is the hard cutoff."),
    AOB_PARAM(struct values, slices, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 4096, .initial = 3,
              .doc = "Slices about the view vector (the text's sliceCount); more lowers noise."),
    AOB_PARAM(struct values, steps, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 1024, .initial = 6,
              .doc =
                  "Taps on each side of a slice (directionSampleCount); more finds horizons more exactly."),
    AOB_PARAM(struct values, weighting, .stage = AOB_CONSTANT, .choices = weightings,
              .doc =
                  "How directions are weighted: with the cosine as in the text, or by the bare solid angle."),
    AOB_PARAM(struct values, noise_index, .min = 0, .max = 1e6, .initial = 0,
              .doc = "Frame of the temporal noise: turns slices and moves steps; repeats after 24."),
    AOB_PARAM_DIVISOR(struct values, divisor),
    AOB_PARAM_DEPTH_DIVISOR(struct values, depth_divisor),
    AOB_PARAM_BLUR(struct values, blur, 5),
};

static float falloff(const void *values, float t)
{
    const struct values *v = values;
    return v->falloff > 0 ? fminf(1, (1 - t) / v->falloff) : 1;
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex depth = aob_step_downsample(graph, .divisor = v->depth_divisor);
    aob_tex open = aob_texture(graph, .name = "visibility", .format = aob_open_format(graph),
                               .divisor = (uint32_t)v->divisor);
    aob_pass(graph, .name = "horizon", .shader = "horizon", .reads = AOB_DEPTH | AOB_NORMAL, .depth = depth,
             .border = AOB_FAR, .defines = {{"BENT", aob_wants(graph, AOB_OUT_BENT_NORMAL)}},
             .out = {{.name = "visibility", .tex = open}});
    open = aob_step_blur(graph, .tex = open, .taps = v->blur, .divisor = v->divisor,
                         .output = aob_open_kind(graph));
    open = aob_step_upsample(graph, .tex = open, .divisor = v->divisor, .output = aob_open_kind(graph));
    return aob_open_outputs(graph, open);
}

AOB_TECHNIQUE(
    gtao, .title = "Ground-truth ambient occlusion", .revision = 5, .shaders = aob_shaders_gtao,
    .summary = "Visibility from horizons: in each slice about the view vector the highest elevation on both "
               "sides within the radius, then the closed-form integral of the cosine between them.",
    .notes =
        "Slices are even about the view vector, not in the image; taps below the tangent plane, or less "
        "than 0.1 degrees above it, are "
        "ignored; the search is as long as the slice of the ball; the integral is divided by the open "
        "slice's (docs/decisions/0009); a search that would leave the image ends at its edge "
        "(docs/decisions/0040). The text leaves open how half size is sampled up, and gives no "
        "noise tables. The bent normal is summed in the slices themselves, without the text's rotation, "
        "which "
        "takes a slice out of its plane; visibility and bent normal are filtered together. Multi-bounce and "
        "specular occlusion of the text are not outputs yet.",
    .citation = "Jimenez, Wu, Pesce, Jarabo: Practical Real-Time Strategies for Accurate Indirect "
                "Occlusion, ATVI-TR-19-01 (2016)",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_COSINE, .falloff = falloff},
    .sampling = {"slices", AOB_SEQUENCE_STRATIFIED}, .build = build);
