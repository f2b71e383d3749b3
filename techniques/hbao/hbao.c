/* Horizon-based ambient occlusion: Bavoil and Sainz, "Image-Space Horizon-Based Ambient Occlusion", ShaderX7 (2009),
 * 6.2: horizons in the image, attenuated for each sample, tangents for each sample against snapping. */
#include <aobudget/points.h>
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius, attenuation, angle_bias, intensity, min_step, blur_depth;
    int32_t directions, steps, weighting, snapping, tangents, divisor, depth_divisor, blur;
};

enum { TILE = 4 };

static const char *const weightings[] = {"cosine", "uniform", NULL};
static const char *const snappings[] = {"per_sample", "per_direction", "off", NULL};
static const char *const tangents[] = {"per_sample", "per_direction", NULL};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5,
              .doc =
                  "The text's R: farthest distance of an occluder, farther samples are ignored; more darkens "
                  "more and from farther."),
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
    AOB_PARAM(struct values, min_step, .unit = AOB_UNIT_PIXEL, .min = 0, .max = 64, .initial = 0,
              .doc = "Where a step is shorter than this the pixel stays open; more is cheaper and loses "
                     "occlusion far away. The text's early exit is at 1, 0 is without."),
    AOB_PARAM(struct values, weighting, .stage = AOB_CONSTANT, .choices = weightings,
              .initial = AOB_WEIGHT_UNIFORM,
              .doc = "How directions are weighted: by the bare solid angle as in equation 6.2.3, or with the "
                     "cosine (6.2.1)."),
    AOB_PARAM(struct values, snapping, .stage = AOB_CONSTANT, .choices = snappings,
              .doc =
                  "To texel centres: each sample; the first sample and the step of a direction, cheaper but "
                  "banded; or not, which mixes a texel's depth with another place."),
    AOB_PARAM(struct values, tangents, .stage = AOB_CONSTANT, .choices = tangents,
              .doc = "Tangent plane under each sample (equation 6.2.9), or one a direction (6.2.8)."),
    AOB_PARAM_DIVISOR(struct values, divisor),
    AOB_PARAM_DEPTH_DIVISOR(struct values, depth_divisor),
    AOB_PARAM_BLUR(struct values, blur, 9),
    AOB_PARAM(struct values, blur_depth, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.03,
              .doc = "Depth apart at which a tap of the blur counts exp(-1/2): the root of the text's depth "
                     "variance; more smooths across depths."),
};

static float falloff(const void *values, float t)
{
    return 1 - ((const struct values *)values)->attenuation * t * t;
}

/* Texel: (cos a, sin a, b) of equation 6.2.10, a in a direction's share of the circle and b in [0, 1). */
static void fill_jitter(const void *values, void *texels)
{
    float(*jitter)[4] = texels;
    for (uint32_t y = 0; y < TILE; y++)
        for (uint32_t x = 0; x < TILE; x++) {
            float point[2], *texel = jitter[y * TILE + x];
            aob_point_square((x + y) % TILE * TILE + x, TILE * TILE, point);
            float a = 6.28318531f * point[0] / (float)((const struct values *)values)->directions;
            texel[0] = cosf(a);
            texel[1] = sinf(a);
            texel[2] = point[1];
            texel[3] = 0;
        }
}

static float map(const void *values, float visibility)
{
    const struct values *v = values;
    return fminf(1, fmaxf(0, 1 - v->intensity * (1 - visibility)));
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex depth = aob_step_downsample(graph, .divisor = v->depth_divisor);
    aob_tex jitter = aob_texture(graph, .name = "jitter", .format = AOB_RGBA32F, .width = TILE,
                                 .height = TILE, .fill = fill_jitter);
    aob_tex open = aob_texture(graph, .name = "visibility", .format = aob_open_format(aob_open_kind(graph)),
                               .divisor = (uint32_t)v->divisor);
    aob_pass(graph, .name = "horizon", .shader = "horizon", .reads = AOB_DEPTH | AOB_NORMAL | AOB_CLEARANCE,
             .depth = depth, .border = AOB_FAR, .defines = {{"BENT", aob_wants(graph, AOB_OUT_BENT_NORMAL)}},
             .in = {{.name = "jitter", .tex = jitter}}, .out = {{.name = "visibility", .tex = open}});
    open = aob_step_blur(graph, .tex = open, .taps = v->blur, .divisor = v->divisor,
                         .output = aob_open_kind(graph));
    open = aob_step_upsample(graph, .tex = open, .divisor = v->divisor, .output = aob_open_kind(graph));
    return aob_open_outputs(graph, aob_open_kind(graph), open);
}

static const struct aob_by_definition by_definition[] = {
    {"crease_to_corner", "Directions and jittering: \"We pick N_d 2D directions theta in image space\", with "
                         "one projected size of the radius "
                         "for all, so that directions and lengths are even in the image only."},
    {0},
};

/* A sample that rises less than .02 above the plane closes nothing. The tangent of a direction, and places between texels, close
 * open planes as well. */
static struct aob_clearance clearance(const void *values)
{
    const struct values *v = values;
    enum { PER_SAMPLE = 0, OFF = 2 };
    return (struct aob_clearance){
        .sine = v->tangents == PER_SAMPLE && v->snapping != OFF ? 0.019f : 0,
        .because = "open planes are darkened by one tangent a direction, and by places between texels"};
}

AOB_TECHNIQUE(
    hbao, .title = "Horizon-based ambient occlusion", .revision = 6, .shaders = aob_shaders_hbao,
    .summary =
        "Visibility from horizons about the view axis: along even directions in the image each sample "
        "that raises the horizon adds the sector it closes, attenuated by its distance. Elevations are "
        "grounded by the tangent plane under each sample.",
    .notes =
        "Equation 6.2.4 integrates the elevation to pi - t + pi/2; the hemisphere ends at pi/2, and 6.2.5 "
        "follows from that. Directions even in the image stand for even azimuths, as in the text: exact "
        "without perspective only. The text gives the tile of jitters no numbers; its 16 pairs are even in "
        "both. Half-size AO is blurred at its own size and then upsampled; the text does both in one. "
        "Outside the image there is nothing, where the text repeats the edge, and a direction's steps are "
        "even up to the edge, where the text goes on. A tangent is that of the exact "
        "plane through the point and across its normal, perspective included; the text adds steps along "
        "the image's axes (6.2.11), which is not perspective correct. With a tangent for each sample, those "
        "less than 1.1 degrees above the surface's plane close nothing, as normals of 8 bits lean and a "
        "plane that is seen edge on has every elevation. The text's early exit shows as an edge "
        "in deep views, and leaves all of "
        "one open whose steps are below a texel, so it is off by default. MSAA is left out. "
        "The bent normal is not in the text: it is the mean over the hemisphere less what the horizons "
        "close, "
        "by the same integral; `intensity` does not act on it.",
    .citation = "Bavoil, Sainz: Image-Space Horizon-Based Ambient Occlusion, ShaderX7 (2009), 6.2",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_UNIFORM, .falloff = falloff, .map = map},
    .by_definition = by_definition, .sampling = {"directions", AOB_SEQUENCE_STRATIFIED},
    .clearance = clearance, .build = build);
