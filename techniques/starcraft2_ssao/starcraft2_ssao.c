/* Screen space ambient occlusion of StarCraft II: Filion, "Principles and Practice of Screen Space Ambient Occlusion",
 * Game Programming Gems 8 (2010), 1.2. Points of the normal's hemisphere are compared with the depth buffer; a blocker
 * function of the depth between says how much each is occluded.
 *
 * Notes: listing 1.2.6 normalises the reflected offset, which would undo the lengths of half to full radius that the
 * text asks for: lengths are kept. Listing 1.2.5 names the thresholds in another order than its callers: names count.
 * The text raises the falling value to the power, (1 - x)^p, the listing only x: the text's is used (one for p = 1).
 * Listing 1.2.2 takes the plain average, the text one weighted by distance, and nearer points are to count more:
 * `distance_weight` has all three. The matrix of MakeRotation in listing 1.2.6 is never used. The offsets are a table here, as
 * a pass has no constant registers: one fetch a sample more than the text's. Depth is read at texel centres, so a slanted
 * plane would occlude itself by far more than c_occlusionEpsilon: a surface within epsilon of the tangent plane counts
 * nothing (the text has no such test). */
#include <aobudget/points.h>
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius, full_occlusion, no_occlusion, power;
    float small_radius, small_full_occlusion, small_no_occlusion, small_power;
    float epsilon, distance_weight, max_screen_radius, near_distance, blur_depth, blur_normal;
    int32_t samples, first_sample, radii, blocker, near_factor, noise_size, seed;
    int32_t blur, blur_passes, divisor, depth_divisor;
};
enum { BLOCKER_TEXELS = 256, RADII_TWO = 1, BLOCKER_TABLE = 1 };

static const char *const radii[] = {"one", "two", NULL}, *const blockers[] = {"formula", "table", NULL};

#define LENGTH .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2
#define COUNT  .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, LENGTH, .min = 1e-6, .max = 1e6, .initial = 0.5,
              .doc = "p_fOcclusionRadius, of the wide set: longest offset; more darkens from farther."),
    AOB_PARAM(struct values, full_occlusion, LENGTH, .min = 0, .max = 1e6, .initial = 0.1,
              .doc = "p_fFullOcclusionThreshold: depth in front of a sample up to which it counts whole."),
    AOB_PARAM(struct values, no_occlusion, LENGTH, .min = 1e-6, .max = 1e6, .initial = 0.5,
              .doc = "p_fNoOcclusionThreshold: depth in front of a sample from which it counts nothing."),
    AOB_PARAM(struct values, power, .min = 0.01, .max = 100, .initial = 1,
              .doc = "p_fOcclusionPower: exponent of the fall between the thresholds; more falls sooner."),
    AOB_PARAM(struct values, small_radius, LENGTH, .min = 1e-6, .max = 1e6, .initial = 0.125,
              .doc = "Longest offset of the small set (radii = two); more widens dark creases."),
    AOB_PARAM(struct values, small_full_occlusion, LENGTH, .min = 0, .max = 1e6, .initial = 0.1,
              .doc = "Threshold full_occlusion of the small set; more darkens creases."),
    AOB_PARAM(struct values, small_no_occlusion, LENGTH, .min = 1e-6, .max = 1e6, .initial = 0.125,
              .doc = "Threshold no_occlusion of the small set; more darkens creases."),
    AOB_PARAM(struct values, small_power, .min = 0.01, .max = 100, .initial = 1,
              .doc = "Exponent `power` of the small set; more falls sooner."),
    AOB_PARAM(struct values, epsilon, .unit = AOB_UNIT_LENGTH, .min = 0, .max = 1e6, .initial = 0.01,
              .doc = "c_occlusionEpsilon: least depth in front of a sample, and height over the tangent "
                     "plane; more hides self-occlusion."),
    AOB_PARAM(struct values, distance_weight, .stage = AOB_HOST, .min = -8, .max = 8, .initial = -1,
              .doc =
                  "Weight of a sample is its distance to this power; less counts near ones more, 0 alike."),
    AOB_PARAM(struct values, max_screen_radius, .unit = AOB_UNIT_PIXEL, .min = 0, .max = 65536, .initial = 0,
              .doc = "Caps the offsets' length on a full-size screen; less shrinks close-ups, 0 is no cap."),
    AOB_PARAM(struct values, near_distance, LENGTH, .stage = AOB_CONSTANT, .min = 1e-6, .max = 1e6,
              .initial = 2,
              .doc = "Depth below which near_factor raises the samples, as near_distance / depth."),
    AOB_PARAM(struct values, near_factor, COUNT, .stage = AOB_CONSTANT, .min = 1, .max = 16, .initial = 1,
              .doc = "How many times the samples close-ups get at most; more lowers their noise, 1 is off."),
    AOB_PARAM(struct values, samples, COUNT, .stage = AOB_CONSTANT, .min = 1, .max = 4096, .initial = 16,
              .doc =
                  "iSampleCount: points a pixel, a quarter of them small if radii = two; more lowers noise."),
    AOB_PARAM(struct values, first_sample, .unit = AOB_UNIT_COUNT, .stage = AOB_HOST, .min = 0, .max = 65536,
              .initial = 0,
              .doc = "Where in p_vSSAOSamplePoints, an endless sequence, the first offset is taken."),
    AOB_PARAM(struct values, radii, .stage = AOB_CONSTANT, .choices = radii, .initial = RADII_TWO,
              .doc = "All samples at the radius, or a quarter at the small one and the darker result wins."),
    AOB_PARAM(struct values, blocker, .stage = AOB_CONSTANT, .choices = blockers,
              .doc = "The blocker function computed, or looked up in a one-dimensional table."),
    AOB_PARAM(struct values, noise_size, .unit = AOB_UNIT_PIXEL, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 1, .max = 256, .initial = 64,
              .doc = "Side of the tile of random normals that mirror the offsets; more repeats less."),
    AOB_PARAM(struct values, seed, .stage = AOB_HOST, .min = 0, .max = 1e6, .initial = 0,
              .doc = "Seed of the random normals."),
    AOB_PARAM_BLUR(struct values, blur, 9),
    AOB_PARAM_BLUR_PASSES(struct values, blur_passes, 2),
    AOB_PARAM(struct values, blur_depth, LENGTH, .min = 0, .max = 1e6, .initial = 0.1,
              .doc =
                  "Depth between pixels beyond which the blur does not mix them; more smooths over edges."),
    AOB_PARAM(struct values, blur_normal, .min = -1, .max = 1, .initial = 0.9,
              .doc = "Cosine between normals below which the blur does not mix them; less smooths creases."),
    AOB_PARAM_DIVISOR(struct values, divisor),
    AOB_PARAM_DEPTH_DIVISOR(struct values, depth_divisor),
};

static float blocked(float delta, float epsilon, float full, float none, float power)
{
    if (delta <= epsilon || delta >= none)
        return 0;
    return delta <= full ? 1 : powf(1 - (delta - full) / (none - full), power);
}

/* A sample at s radii on a ray that meets a surface at t < s is occluded by blocked(depth between). That depth is along
 * the view, so no function of t is exact; s - t, the depth where the ray is the view's, is nearest. The mean over s,
 * even in 1/2..1, by weight. With two radii this is the wide set: the darker of two means is not one mean. */
static float falloff(const void *values, float t)
{
    enum { STEPS = 128 };
    const struct values *v = values;
    float sum = 0, weights = 0;
    for (int i = 0; i < STEPS; i++) {
        float s = 0.5f + 0.5f * ((float)i + 0.5f) / STEPS, w = powf(s, v->distance_weight);
        weights += w;
        sum += w * blocked((s - t) * v->radius, v->epsilon, v->full_occlusion, v->no_occlusion, v->power);
    }
    return sum / weights;
}

static void fill_offsets(const void *values, void *texels)
{
    const struct values *v = values;
    float(*texel)[4] = texels;
    for (int i = 0; i < v->samples * v->near_factor; i++) {
        uint32_t k = (uint32_t)(v->first_sample + i + 1);
        float length = 0.5f + 0.5f * aob_point_inverse(k, 5);
        aob_point_on_sphere(aob_point_inverse(k, 2), aob_point_inverse(k, 3), texel[i]);
        for (int c = 0; c < 3; c++)
            texel[i][c] *= length;
        texel[i][3] = powf(length, v->distance_weight);
    }
}

static uint32_t scramble(uint32_t x)
{
    x = (x ^ x >> 16) * 0x7feb352du;
    x = (x ^ x >> 15) * 0x846ca68bu;
    return x ^ x >> 16;
}

static void fill_normals(const void *values, void *texels)
{
    const struct values *v = values;
    unsigned char(*texel)[4] = texels;
    for (int32_t i = 0; i < v->noise_size * v->noise_size; i++) {
        uint32_t h = scramble((uint32_t)i + scramble((uint32_t)v->seed));
        float n[3];
        aob_point_on_sphere((float)(h >> 8) / 16777216, (float)(scramble(h) >> 8) / 16777216, n);
        for (int c = 0; c < 3; c++)
            texel[i][c] = (unsigned char)lrintf(127.5f + 127.5f * n[c]);
        texel[i][3] = 255;
    }
}

static void fill_blocker(const void *values, void *texels)
{
    const struct values *v = values;
    float *texel = texels;
    for (int i = 0; i < BLOCKER_TEXELS; i++) {
        float part = (float)i / (BLOCKER_TEXELS - 1);
        texel[i] = blocked(part * v->no_occlusion, v->epsilon, v->full_occlusion, v->no_occlusion, v->power);
        texel[BLOCKER_TEXELS + i] = blocked(part * v->small_no_occlusion, v->epsilon, v->small_full_occlusion,
                                            v->small_no_occlusion, v->small_power);
    }
}

static bool check(const void *values, const char **why)
{
    const struct values *v = values;
    *why = "samples: radii = two needs at least 4";
    if (v->radii == RADII_TWO && v->samples < 4)
        return false;
    *why = "samples, near_factor: their product must be at most 8192";
    if (v->samples * v->near_factor > 8192)
        return false;
    *why = "full_occlusion, small_full_occlusion: must be less than no_occlusion and small_no_occlusion";
    return v->full_occlusion < v->no_occlusion && v->small_full_occlusion < v->small_no_occlusion;
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex low = aob_step_downsample(graph, .divisor = v->depth_divisor);
    aob_tex offsets = aob_texture(graph, .name = "offsets", .format = AOB_RGBA32F, .height = 1,
                                  .width = (uint32_t)(v->samples * v->near_factor), .fill = fill_offsets);
    aob_tex normals =
        aob_texture(graph, .name = "random_normals", .format = AOB_RGBA8, .width = (uint32_t)v->noise_size,
                    .height = (uint32_t)v->noise_size, .fill = fill_normals);
    aob_tex raw =
        aob_texture(graph, .name = "visibility", .format = AOB_R16F, .divisor = (uint32_t)v->divisor);
    struct aob_pass pass = {.name = "occlusion",
                            .shader = "occlusion",
                            .reads = AOB_DEPTH | AOB_NORMAL | AOB_CLEARANCE,
                            .border = AOB_FAR,
                            .depth = low,
                            .in = {{.name = "offset", .tex = offsets}, {.name = "noise", .tex = normals}},
                            .out = {{.name = "visibility", .tex = raw}}};
    if (v->blocker == BLOCKER_TABLE)
        pass.in[2] =
            (struct aob_bind){.name = "blocker",
                              .tex = aob_texture(graph, .name = "blocker", .format = AOB_R32F,
                                                 .width = BLOCKER_TEXELS, .height = 2, .fill = fill_blocker)};
    aob_pass_add(graph, &pass);
    raw = aob_step_gaussian(graph, .tex = raw, .taps = v->blur, .passes = v->blur_passes,
                            .divisor = v->divisor);
    return aob_output(graph, AOB_OUT_VISIBILITY, aob_step_upsample(graph, .tex = raw, .divisor = v->divisor));
}

static const struct aob_by_definition by_definition[] = {
    {"step_edge_halo", "1.2, figure 1.2.4: the no-occlusion threshold counts from the sample, up to a radius "
                       "before the surface, so that a surface within twice the radius may occlude."},
    {"thin_fence", "1.2, figure 1.2.4: the no-occlusion threshold counts from the sample, up to a radius "
                   "before the surface, so that a surface within twice the radius may occlude."},
    {"approach_crease", "1.2, edge cases: \"samples outside the screen return a large depth value, ensuring "
                        "they would never occlude\"; offsets are at least half as long as the radius."},
    {"radius_enormous",
     "Samples lie at fixed shares of the radius, and those outside the screen return a large depth, so "
     "that they never occlude (1.2, Handling Edge Cases)."},
    {0},
};

/* A sample is occluded only if the surface at its pixel rises by more than epsilon above the tangent plane. That holds of the small set
 * as well, whose radius must be within the other. */
static struct aob_clearance clearance(const void *values)
{
    const struct values *v = values;
    bool within = v->radii != RADII_TWO || v->small_radius <= v->radius;
    bool takes_part = within && (double)v->epsilon >= 1e-6 * (double)v->radius && v->radius > 0;
    return (struct aob_clearance){
        .occluders = AOB_OCCLUDERS_IN_FRONT,
        .sine = takes_part ? 1 : 0,
        .rise = takes_part ? v->epsilon / v->radius : 0,
        .because = within ? "the rounding of depths darkens open planes where epsilon is below a millionth "
                            "of the radius"
                          : "small_radius, which reaches farther than radius, is no part of the proof"};
}

AOB_TECHNIQUE(
    starcraft2_ssao, .title = "StarCraft II ambient occlusion", .revision = 3,
    .shaders = aob_shaders_starcraft2_ssao,
    .citation = "Filion: Principles and Practice of Screen Space Ambient Occlusion, Game "
                "Programming Gems 8 (2010), 1.2",
    .summary = "How much of the points in the normal's hemisphere lies behind the depth buffer, by a "
               "blocker function of the depth between; a wide set and a small one, of which the darker "
               "wins.",
    .notes = "Reflected offsets keep their lengths (listing 1.2.6 normalises them); the fall is (1 - x)^p "
             "as in the text; the average is weighted as `distance_weight` says, since text and listing "
             "differ. A sample passes two tests of depth where the text has one: the surface lies more than "
             "epsilon "
             "in front of the sample, as in the text, and it also rises more than epsilon above the tangent "
             "plane, since depths of texel centres would make a slanted plane occlude itself; this loses "
             "occluders that are lower than epsilon. The definition is that of the wide "
             "set, along rays that lie in the view: no exact one over distance exists. The text's noise tile "
             "is 256 pixels "
             "wide, its depth a quarter size; the cap of the screen radius shrinks the sphere.",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_UNIFORM, .falloff = falloff}, .by_definition = by_definition,
    .sampling = {"samples", AOB_SEQUENCE_STRATIFIED}, .check = check, .clearance = clearance, .build = build);
