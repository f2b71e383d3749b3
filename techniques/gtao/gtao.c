/* Ground-truth ambient occlusion: Jimenez, Wu, Pesce, Jarabo, "Practical Real-Time Strategies for Accurate
 * Indirect Occlusion", ATVI-TR-19-01. Horizons on both sides of each slice, closed-form inner integral. */
#include <aobudget/steps.h>
#include <math.h>
#include <string.h>
#include "lobe.h"
#include "shaders.h"

struct values {
    float radius, falloff;
    int32_t slices, steps, weighting, noise_index, divisor, depth_divisor, blur, history, irradiance_by,
        specular_by;
};

enum { COSINE };
enum { BY_MOMENTS, BY_ZONAL, BY_LOOK_UP, BY_PLAIN, BY_TRIPLE_PRODUCT };
enum { BY_CAP, BY_CONE, BY_VISIBILITY };
static const char *const weightings[] = {"cosine", "uniform", NULL};
static const char *const irradiances[] = {"moments",    "zonal",          "bent_normal",
                                          "visibility", "triple_product", NULL};
static const char *const speculars[] = {"cap", "cone", "visibility", NULL};

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
    AOB_PARAM(
        struct values, weighting, .stage = AOB_CONSTANT, .choices = weightings,
        .doc =
            "How directions are weighted: with the cosine as in the text, or by the bare solid angle, which "
            "gives no bounces, specular or irradiance."),
    AOB_PARAM(struct values, noise_index, .min = 0, .max = 1e6, .initial = 0,
              .doc = "Frame of the temporal noise: turns slices and moves steps; 24 are the text's."),
    AOB_PARAM_DIVISOR(struct values, divisor),
    AOB_PARAM_DEPTH_DIVISOR(struct values, depth_divisor),
    AOB_PARAM_BLUR(struct values, blur, 5),
    AOB_PARAM_HISTORY(struct values, history),
    AOB_PARAM(
        struct values, irradiance_by, .output = AOB_OUT_IRRADIANCE, .stage = AOB_HOST, .choices = irradiances,
        .doc = "How irradiance is made, where it is wanted; zonal is the text's, and the rest compare."),
    AOB_PARAM(
        struct values, specular_by, .output = AOB_OUT_SPECULAR, .stage = AOB_HOST, .choices = speculars,
        .doc =
            "How specular is made, where it is wanted: a closed cap, the text's open cone, or visibility."),
};

static float falloff(const void *values, float t)
{
    const struct values *v = values;
    return v->falloff > 0 ? fminf(1, (1 - t) / v->falloff) : 1;
}

/* Light is made of means that are weighed by the cosine. */
static bool gives_light(const struct values *v)
{
    return v->weighting == COSINE;
}

/* Whether an output is wanted that is made of the bent normal. */
static enum aob_output open_kind(const struct aob_graph *graph, const struct values *v)
{
    bool light = aob_wants(graph, AOB_OUT_IRRADIANCE) && v->irradiance_by != BY_PLAIN,
         lobe = aob_wants(graph, AOB_OUT_SPECULAR) && v->specular_by != BY_VISIBILITY;
    return gives_light(v) && (light || lobe) ? AOB_OUT_BENT_NORMAL : aob_open_kind(graph);
}

static bool lay_irradiance(struct aob_graph *graph, const struct values *v, aob_tex open)
{
    if (!aob_wants(graph, AOB_OUT_IRRADIANCE))
        return true;
    aob_tex light = aob_texture(graph, .name = "irradiance", .format = AOB_RGBA16F);
    return aob_pass(graph, .name = "irradiance", .shader = "irradiance",
                    .reads = AOB_DEPTH | AOB_NORMAL | AOB_LIGHT,
                    .defines = {{"IRRADIANCE_BY", v->irradiance_by}}, .in = {{.name = "open", .tex = open}},
                    .out = {{.name = "irradiance", .tex = light}}) &&
           aob_output(graph, AOB_OUT_IRRADIANCE, light);
}

static bool lay_specular(struct aob_graph *graph, const struct values *v, aob_tex open)
{
    if (!aob_wants(graph, AOB_OUT_SPECULAR))
        return true;
    aob_tex specular = aob_texture(graph, .name = "specular", .format = AOB_R16F);
    struct aob_pass pass = {.name = "specular",
                            .shader = "plain_specular",
                            .in = {{.name = "open", .tex = open}},
                            .out = {{.name = "specular", .tex = specular}}};
    if (v->specular_by != BY_VISIBILITY) {
        pass.shader = "specular";
        pass.reads = AOB_DEPTH | AOB_NORMAL | AOB_MATERIAL;
        pass.in[1] = (struct aob_bind){
            .name = "lobes",
            .tex = aob_texture(graph, .name = "lobes", .format = AOB_R16, .width = GTAO_LOBE_EDGES,
                               .height = GTAO_LOBE_CONES * GTAO_LOBE_SHAPES, .fill = gtao_lobe_fill),
            .filter = AOB_BILINEAR};
        const struct aob_define defines[] = {{"EDGES", GTAO_LOBE_EDGES},
                                             {"CONES", GTAO_LOBE_CONES},
                                             {"SHAPES", GTAO_LOBE_SHAPES},
                                             {"LEAST_PERCENT", (int)(100 * GTAO_LOBE_LEAST + 0.5)},
                                             {"SPECULAR_BY", v->specular_by}};
        memcpy(pass.defines, defines, sizeof defines);
    }
    return aob_pass_add(graph, &pass) && aob_output(graph, AOB_OUT_SPECULAR, specular);
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    enum aob_output kind = open_kind(graph, v);
    aob_tex depth = aob_step_downsample(graph, .divisor = v->depth_divisor);
    aob_tex open = aob_texture(graph, .name = "visibility", .format = aob_open_format(kind),
                               .divisor = (uint32_t)v->divisor);
    struct aob_changes changes =
        aob_step_changes(graph, .frames = v->history, .taps = v->blur, .divisor = v->divisor);
    struct aob_pass horizon = {.name = "horizon",
                               .shader = "horizon",
                               .reads = AOB_DEPTH | AOB_NORMAL | AOB_CLEARANCE,
                               .depth = depth,
                               .border = AOB_FAR,
                               .defines = {{"BENT", kind == AOB_OUT_BENT_NORMAL}},
                               .out = {{.name = "visibility", .tex = open}}};
    if (changes.changed.id)
        horizon.in[0] = (struct aob_bind){.name = "changed", .tex = changes.changed};
    aob_pass_add(graph, &horizon);
    open = aob_step_blur(graph, .tex = open, .taps = v->blur, .divisor = v->divisor, .output = kind);
    open = aob_step_upsample(graph, .tex = open, .divisor = v->divisor, .output = kind);
    open = aob_step_temporal(graph, .tex = open, .frames = v->history, .changes = changes, .output = kind);
    if (!aob_open_outputs(graph, kind, open))
        return false;
    return !gives_light(v) || (aob_step_bounces(graph, .tex = open) && lay_irradiance(graph, v, open) &&
                               lay_specular(graph, v, open));
}

/* What is closed up to an elevation e about a surface is sin^2 e of the cosine's hemisphere. Of the bare solid angle it is sin e, but
 * what rises less than 2e-3 is taken for the plane itself. */
static struct aob_clearance clearance(const void *values)
{
    const struct values *v = values;
    return (struct aob_clearance){.sine = v->weighting == AOB_WEIGHT_COSINE ? 0.05f : 2e-3f};
}

AOB_TECHNIQUE(
    gtao, .title = "Ground-truth ambient occlusion", .revision = 5, .shaders = aob_shaders_gtao,
    .summary = "Visibility from horizons: in each slice about the view vector the highest elevation on both "
               "sides within the radius, then the closed-form integral of the cosine between them.",
    .notes = "Slices are even about the view vector, not in the image; taps below the tangent plane, or "
             "less than 0.1 degrees above it, are ignored; the search is as long as the slice of the "
             "ball; the integral is divided by the open slice's (docs/decisions/0009); a search that "
             "would leave the image ends at its edge (docs/decisions/0040). The text leaves open how "
             "half size is sampled up, and gives no noise tables. The bent normal is summed in the "
             "slices themselves, without the text's rotation, which takes a slice out of its plane; "
             "visibility and bent normal are filtered together. Irradiance and specular occlusion take "
             "what is closed for a lobe or a cap of its own; the text's cone about the bent normal is "
             "there for comparison (docs/decisions/0043).",
    .citation = "Jimenez, Wu, Pesce, Jarabo: Practical Real-Time Strategies for Accurate Indirect "
                "Occlusion, ATVI-TR-19-01 (2016)",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_COSINE, .falloff = falloff},
    .sampling = {"slices", AOB_SEQUENCE_STRATIFIED}, .clearance = clearance, .build = build);
