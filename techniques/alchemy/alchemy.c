/* Alchemy ambient obscurance: McGuire, Osman, Bukowski, Hennessy, "The Alchemy Screen-Space Ambient
 * Obscurance Algorithm", HPG 2011: equation 10, a separable cross-bilateral filter, the cross of the composite.
 *
 * Notes. Equations 4 and 6 lack the 1/pi of equation 3; with it, equation 10 is the mean over directions of
 * g(t) = sigma t / (t^2 + epsilon), which is not bounded by 1. The text's sigma is a length and its epsilon a square of
 * one, so its picture depends on the unit; here both are shares of the radius, and the picture is the same at every
 * scale. The text's images have r = 0.5 m, sigma = 1 and epsilon = 1e-4: intensity 2, epsilon 4e-4. It samples a disc, not
 * directions, and leaves the difference alone, as the text does. The text draws bands of the sample count (figure 5, table
 * 1) but not where they change: here after each `band_pixels` of the projected radius, and no samples where it is below
 * half a pixel, since all of them would be the pixel itself. A guard band is a run option. */
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius, intensity, contrast, bias, epsilon;
    int32_t samples, samples_per_band, bands, band_pixels, divisor, blur, composite, seed;
};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5, .doc = "Radius r of the sampled disc and farthest distance of an occluder."),
    AOB_PARAM(struct values, intensity, .min = 0, .max = 100, .initial = 1,
              .doc =
                  "The text's sigma as a share of the radius: scales the obscurance before it is subtracted "
                  "from 1."),
    AOB_PARAM(struct values, contrast, .min = 0.01, .max = 100, .initial = 1,
              .doc = "The text's k: exponent of the result; more darkens the dark."),
    AOB_PARAM(
        struct values, bias, .min = 0, .max = 1, .initial = 1e-4,
        .doc = "The text's beta, times the depth: more hides self-occlusion, and leaks light into corners."),
    AOB_PARAM(
        struct values, epsilon, .min = 1e-12, .max = 1, .initial = 4e-4,
        .doc =
            "The text's epsilon as a share of the squared radius: keeps the division finite; more lights up "
            "corners."),
    AOB_PARAM(struct values, samples, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 4096, .initial = 12,
              .doc = "Points on the disc a pixel (the text's s) where bands are off; more lowers noise."),
    AOB_PARAM(struct values, samples_per_band, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 0,
              .max = 64, .initial = 0,
              .doc = "Points that each band of the projected radius adds (table 1: 2 to 4); 0: no bands."),
    AOB_PARAM(struct values, bands, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 1, .max = 16,
              .initial = 3,
              .doc = "Most bands a pixel gets (table 1: 1 or 3); more spends more on near surfaces."),
    AOB_PARAM(struct values, band_pixels, .unit = AOB_UNIT_PIXEL, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 1024, .initial = 16,
              .doc = "Projected radius that a band covers; more takes fewer points at the same distance."),
    AOB_PARAM_DIVISOR(struct values, divisor),
    AOB_PARAM_BLUR(struct values, blur, 13),
    AOB_PARAM_CROSS5(struct values, composite),
    AOB_PARAM(struct values, seed, .min = 0, .max = 1e6, .initial = 0,
              .doc = "Seed of the spiral's rotation per pixel."),
};

/* Equation 10 amounts to g(t) = sigma t / (t^2 + epsilon) under the cosine; all in radii. */
static float falloff(const void *values, float t)
{
    const struct values *v = values;
    return v->intensity * t / (t * t + v->epsilon);
}

static float map(const void *values, float visibility)
{
    const struct values *v = values;
    return powf(fmaxf(0, visibility), v->contrast);
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex raw =
        aob_texture(graph, .name = "visibility", .format = AOB_R16F, .divisor = (uint32_t)v->divisor);
    aob_pass(graph, .name = "obscurance", .shader = "obscurance",
             .reads = AOB_DEPTH | AOB_NORMAL | AOB_CLEARANCE, .border = AOB_FAR,
             .out = {{.name = "visibility", .tex = raw}});
    raw = aob_step_blur(graph, .tex = raw, .taps = v->blur, .divisor = v->divisor);
    raw = aob_step_upsample(graph, .tex = raw, .divisor = v->divisor);
    return aob_output(graph, AOB_OUT_VISIBILITY,
                      aob_step_cross5(graph, .tex = raw, .taps = v->composite ? 5 : 0));
}

static const struct aob_by_definition by_definition[] = {
    {"ortho_slides", "The bias is beta times the depth: \"We scale it by z\" (2.3, equation 10), so that it "
                     "grows with the distance of the camera."},
    {"crease_to_corner",
     "2.3: \"a ball about C projects to an ellipse, not a disk. Like Loos and Sloan, we ignore this "
     "source of error because it is relatively small for a typical field of view up to 70 degrees.\""},
    {"approach_crease",
     "Section 1: \"under-obscurance due to unseen occluders ... outside the field of view\"; it samples the "
     "whole disc of radius r, of which the image then holds a small part."},
    {"closer_than_radius",
     "Section 1: \"under-obscurance due to unseen occluders ... outside the field of view\"; it samples the "
     "whole disc of radius r, of which the image then holds a small part."},
    {"inside_box", "Section 1: \"under-obscurance due to unseen occluders ... outside the field of view\"; "
                   "it samples the whole disc of radius r, of which the image then holds a small part."},
    {0},
};

/* Where all rises by the sine s the sum's terms are at most s r / |v|, whose mean over the disc is 2, and twice that where samples are
 * rounded to near pixels: 8 intensity s, and as many times more as the contrast is above 1. What lies below the bias is nothing, so
 * rounding is; without a bias it is not. */
static struct aob_clearance clearance(const void *values)
{
    const struct values *v = values;
    float steep = 8 * v->intensity * (v->contrast > 1 ? v->contrast : 1);
    return (struct aob_clearance){.sine = v->bias < 4e-6f ? 0
                                          : steep > 0.04f ? 1 / (255 * steep)
                                                          : 0.1f,
                                  .because = "the rounding of depths darkens open planes where bias is 0"};
}

AOB_TECHNIQUE(
    alchemy, .title = "Alchemy ambient obscurance", .revision = 5, .shaders = aob_shaders_alchemy,
    .citation = "McGuire, Osman, Bukowski, Hennessy: The Alchemy Screen-Space Ambient Obscurance "
                "Algorithm, HPG 2011",
    .summary =
        "Obscurance: every visible point of a disc about the surface point counts by its height over the "
        "tangent plane over its squared distance (equation 10), subtracted from 1.",
    .notes =
        "Equations 4 and 6 lack the 1/pi of equation 3; equation 10 is taken as it stands, so the "
        "definition's falloff is intensity t / (t^2 + epsilon), which is not bounded by 1. The text's sigma "
        "is "
        "a length and its epsilon a squared one; here they are shares of the radius and of its square, so "
        "that no unit shows: the text's images (r = 0.5 m, sigma 1, epsilon 1e-4) have intensity 2 and "
        "epsilon 4e-4, and are darker than the default. It samples the disc, not directions: on a "
        "golden-angle spiral of equal areas, turned by a random angle in each pixel, where the text takes "
        "random points.",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_COSINE, .falloff = falloff, .map = map},
    .by_definition = by_definition, .sampling = {"samples", AOB_SEQUENCE_STRATIFIED}, .clearance = clearance,
    .build = build);
