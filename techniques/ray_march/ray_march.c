/* Brute-force ray marching of the depth buffer: Bavoil and Sainz, "Image-Space Horizon-Based Ambient Occlusion",
 * ShaderX7 (2009), 6.2, "Image space ambient occlusion with ray marching": what a depth buffer, taken as a height
 * field, can tell about occlusion. More of everything takes it there. */
#include <aobudget/steps.h>
#include "shaders.h"

struct values {
    float radius, attenuation;
    int32_t directions, rays, steps, weighting;
};

static const char *const weightings[] = {"cosine", "uniform", NULL};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5,
              .doc =
                  "The text's R: length of a ray; samples of the depth farther away than this are outliers "
                  "and ignored."),
    AOB_PARAM(
        struct values, attenuation, .min = 0, .max = 1, .initial = 1,
        .doc = "Share a in W(r) = 1 - a r^2 of an occluder at r radii; 1 is the text's, 0 the hard cutoff."),
    AOB_PARAM(struct values, directions, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 4096, .initial = 8,
              .doc = "Azimuths about the normal (the text's N_d); more lowers noise."),
    AOB_PARAM(struct values, rays, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT, .min = 1,
              .max = 256, .initial = 4,
              .doc = "Elevations at each azimuth (N_r); more lowers noise; the text needs three at least."),
    AOB_PARAM(struct values, steps, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 1024, .initial = 8,
              .doc =
                  "Even steps along a ray (N_s); more misses fewer thin occluders and places hits better."),
    AOB_PARAM(struct values, weighting, .stage = AOB_CONSTANT, .choices = weightings,
              .initial = AOB_WEIGHT_UNIFORM,
              .doc = "How directions are weighted: by the bare solid angle as in equation 6.2.3, or with the "
                     "cosine (6.2.1)."),
};

static float falloff(const void *values, float t)
{
    return 1 - ((const struct values *)values)->attenuation * t * t;
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex open = aob_texture(graph, .name = "visibility", .format = aob_open_format(aob_open_kind(graph)));
    aob_pass(graph, .name = "march", .shader = "march", .reads = AOB_DEPTH | AOB_NORMAL | AOB_CLEARANCE,
             .border = AOB_FAR, .defines = {{"BENT", aob_wants(graph, AOB_OUT_BENT_NORMAL)}},
             .out = {{.name = "visibility", .tex = open}});
    return aob_open_outputs(graph, aob_open_kind(graph), open);
}

static const struct aob_by_definition by_definition[] = {
    {"distinct_taps",
     "\"N_d directions (theta angles), N_r rays per direction (phi angles), and N_s steps per ray\" (6.2, "
     "Ray "
     "Marching): on a plane that faces the camera the rays of a direction step over the same pixels."},
    {0},
};

/* A surface that rises less than .02 above the plane is hit by no ray. */
static struct aob_clearance clearance(const void *values)
{
    (void)values;
    return (struct aob_clearance){.sine = 0.019f};
}

AOB_TECHNIQUE(
    ray_march, .title = "Ray marching of the depth buffer", .revision = 4, .shaders = aob_shaders_ray_march,
    .summary =
        "Rays in the hemisphere about the normal, marched in even steps; the first step below the depth "
        "buffer, taken as a height field, is a hit and counts by its distance. With many of each it is "
        "what a depth buffer alone can tell.",
    .notes =
        "The text divides by N_r N_s and calls N_d the directions; the mean over all rays needs N_d N_r. "
        "Steps are even in space, the second of the text's two ways, up to where a ray leaves the image; the "
        "text goes on. Depth samples under the tangent plane "
        "stop no ray, nor those less than 1.1 degrees above it, as normals of 8 bits lean: without that, "
        "texels darken tilted planes. The text gives no noise: directions turn "
        "and elevations move in a 4x4 tile. The bent normal is not in the text: it is the mean over the "
        "hemisphere less the closed rays.",
    .citation = "Bavoil, Sainz: Image-Space Horizon-Based Ambient Occlusion, ShaderX7 (2009), 6.2, with ray "
                "marching",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_UNIFORM, .falloff = falloff}, .by_definition = by_definition,
    .sampling = {"directions", AOB_SEQUENCE_STRATIFIED}, .clearance = clearance, .build = build);
