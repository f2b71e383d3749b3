/* Horizon-based ambient occlusion: Bavoil and Sainz, "Image-Space Horizon-Based Ambient Occlusion", ShaderX7 (2009),
 * 6.2: horizons in the image, attenuated for each sample, tangents for each sample against snapping. */
#include <aobudget/steps.h>
#include "shaders.h"

struct values {
    float radius, attenuation, angle_bias, intensity;
    int32_t directions, steps, tangents, blur;
};

static const char *const tangents[] = {"per_sample", "per_direction", NULL};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5,
              .doc = "The text's R: farthest distance of an occluder; more darkens more and from farther."),
    AOB_PARAM(
        struct values, attenuation, .min = 0, .max = 1, .initial = 1,
        .doc = "Share a in W(r) = 1 - a r^2 of an occluder at r radii; 1 is the text's, 0 the hard cutoff."),
    AOB_PARAM(
        struct values, angle_bias, .unit = AOB_UNIT_RADIAN, .min = 0, .max = 1.5, .initial = 0,
        .doc = "Raises the tangent plane; more hides creases of coarse meshes, and loses shallow occluders."),
    AOB_PARAM(struct values, intensity, .min = 0, .max = 10, .initial = 1,
              .doc = "Scales the occlusion before it is subtracted from 1."),
    AOB_PARAM(struct values, directions, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 4096, .initial = 8,
              .doc = "Directions in the image (the text's N_d); more lowers noise."),
    AOB_PARAM(struct values, steps, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 1024, .initial = 8,
              .doc = "Samples along a direction (N_s); more finds horizons more exactly."),
    AOB_PARAM(struct values, tangents, .stage = AOB_CONSTANT, .choices = tangents,
              .doc = "Tangent plane under each sample (equation 6.2.9), or one a direction (6.2.8)."),
    AOB_PARAM_BLUR(struct values, blur, 9),
};

static float falloff(const void *values, float t)
{
    return 1 - ((const struct values *)values)->attenuation * t * t;
}

static bool check(const void *values, const char **why)
{
    return aob_step_blur_check(((const struct values *)values)->blur, why);
}

static bool build(struct aob_graph *graph, const void *values)
{
    aob_tex raw = aob_texture(graph, .name = "visibility", .format = AOB_R16F);
    return aob_pass(graph, .name = "horizon", .shader = "horizon", .reads = AOB_DEPTH | AOB_NORMAL,
                    .border = AOB_FAR, .out = {{.name = "visibility", .tex = raw}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY,
                      aob_step_blur(graph, raw, ((const struct values *)values)->blur, 1, 1));
}

AOB_TECHNIQUE(hbao, .title = "Horizon-based ambient occlusion", .revision = 1, .shaders = aob_shaders_hbao,
              .citation = "Bavoil, Sainz: Image-Space Horizon-Based Ambient Occlusion, ShaderX7 (2009), 6.2",
              .params = params, .param_count = sizeof params / sizeof *params,
              .values_size = sizeof(struct values),
              .definition = {.weight = AOB_WEIGHT_UNIFORM, .falloff = falloff},
              .sampling = {"directions", AOB_SEQUENCE_STRATIFIED}, .check = check, .build = build);
