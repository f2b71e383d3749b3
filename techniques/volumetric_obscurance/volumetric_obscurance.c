/* Volumetric obscurance as McGuire, Osman, Bukowski, Hennessy describe and measure it in "The Alchemy Screen-Space
 * Ambient Obscurance Algorithm", HPG 2011, sections 1.1 and 3: line samples through a sphere, at two resolutions.
 *
 * Notes. That text names the parts; the formula of a line follows from the geometry. With h half of the line's length
 * in the sphere and z the sampled depth relative to the centre's, positive away from the eye, a line is solid over
 * clamp(h - z, 0, 2 h). Solid in the whole sphere is sum(solid) / sum(2 h), which is 1/2 on a wall; visibility is twice
 * the rest. With normals the part above the tangent plane is counted alone. How the two resolutions are mixed is not
 * said: here evenly. */
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius, fine_radius;
    int32_t samples, resolutions, divisor, hemisphere, amplification, blur, seed;
};

static const char *const resolutions[] = {"one", "two", NULL};
static const char *const switches[] = {"off", "on", NULL};
enum { ONE, TWO };

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5, .doc = "Radius of the sphere; more darkens from farther."),
    AOB_PARAM(struct values, fine_radius, .min = 0.01, .max = 1, .initial = 1,
              .doc = "Share of the radius that the full-size image of two covers; less shows finer detail."),
    AOB_PARAM(struct values, samples, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 2, .max = 4096, .initial = 6,
              .doc = "Lines a pixel of each resolution, even, in opposite pairs; more lowers noise."),
    AOB_PARAM(struct values, resolutions, .stage = AOB_HOST, .choices = resolutions, .initial = TWO,
              .doc = "One image, divided by divisor, or the mean of it and one of full size."),
    AOB_PARAM(struct values, divisor, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_HOST, .min = 1,
              .max = 4, .rule = AOB_POWER_OF_TWO, .initial = 2,
              .doc =
                  "Divides the size of the (coarser) image and of the depth that it reads; more is cheaper."),
    AOB_PARAM(struct values, hemisphere, .stage = AOB_CONSTANT, .choices = switches, .initial = 1,
              .doc =
                  "On reads normals and counts the half of the sphere above the tangent plane alone; off is "
                  "the text's whole sphere, which is too bright where surfaces are convex."),
    AOB_PARAM(struct values, amplification, .stage = AOB_CONSTANT, .choices = switches, .initial = 1,
              .doc =
                  "On doubles the empty share of the sphere, so that a wall is open; off leaves it at 0.5."),
    AOB_PARAM_BLUR(struct values, blur, 13),
    AOB_PARAM(struct values, seed, .min = 0, .max = 1e6, .initial = 0,
              .doc = "Seed of the lines' rotation per pixel."),
};

/* All behind a hit at distance t is solid: of a cone of the unit sphere the share 1 - t^3. */
static float solid(float t)
{
    return t < 1 ? 1 - t * t * t : 0;
}

static float falloff(const void *values, float t)
{
    const struct values *v = values;
    return v->resolutions == ONE ? solid(t) : 0.5f * (solid(t) + solid(t / v->fine_radius));
}

static float map(const void *values, float visibility)
{
    const struct values *v = values;
    return v->amplification ? visibility : 0.5f * visibility;
}

static bool check(const void *values, const char **why)
{
    const struct values *v = values;
    *why = "samples: must be even, since lines come in pairs";
    return v->samples % 2 == 0;
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    uint32_t reads = AOB_DEPTH | AOB_CLEARANCE | (v->hemisphere ? AOB_NORMAL : 0);
    aob_tex raw = aob_texture(graph, .name = "coarse", .format = AOB_R16F, .divisor = (uint32_t)v->divisor);
    aob_pass(graph, .name = "coarse", .shader = "lines", .defines = {{"ROLE", v->resolutions == ONE ? 0 : 1}},
             .reads = reads, .depth = aob_step_downsample(graph, .divisor = v->divisor), .border = AOB_FAR,
             .out = {{.name = "visibility", .tex = raw}});
    raw = aob_step_upsample(graph, .tex = raw, .divisor = v->divisor);
    if (v->resolutions == TWO) {
        aob_tex fine = aob_texture(graph, .name = "fine", .format = AOB_R16F);
        aob_pass(graph, .name = "fine", .shader = "lines", .defines = {{"ROLE", 2}}, .reads = reads,
                 .border = AOB_FAR, .in = {{.name = "coarse", .tex = raw}},
                 .out = {{.name = "visibility", .tex = fine}});
        raw = fine;
    }
    return aob_output(graph, AOB_OUT_VISIBILITY,
                      aob_step_blur(graph, .tex = raw, .taps = v->blur, .divisor = 1));
}

static const struct aob_by_definition by_definition[] = {
    {"step_edge_halo", "Alchemy, 1.1, of this technique: it \"tends to produce black halos\"; what a line "
                       "meets is solid however far before the surface."},
    {"thin_fence", "Alchemy, 1.1, of this technique: it \"tends to produce black halos\"; what a line meets "
                   "is solid however far before the surface."},
    {"crease_to_corner",
     "Alchemy, 2.3, of this technique: \"a ball about C projects to an ellipse, not a disk. Like Loos "
     "and Sloan, we ignore this source of error\"; its lines lie along the axis, in a disc of the image."},
    {"approach_crease", "Alchemy, 1.1, of this technique: \"unseen space is empty\"; its lines fill the "
                        "whole sphere, of which the image then holds a small part."},
    {"closer_than_radius", "Alchemy, 1.1, of this technique: \"unseen space is empty\"; its lines fill the "
                           "whole sphere, of which the image then holds a small part."},
    {"inside_box", "Alchemy, 1.1, of this technique: \"unseen space is empty\"; its lines fill the whole "
                   "sphere, of which the image then holds a small part."},
    {0},
};

/* A surface that comes in front of the plane makes each line solid by as much as it is in front. Six lines or more, on a disc of three
 * pixels or more, have a mean half length of .19 of the radius at least, to whichever pixels they are rounded: so 5e-4 of the radius
 * closes .0026. Fewer lines may all stand at the rim of the sphere, where it is thin. Without normals the whole sphere is asked, and
 * what lies behind the plane makes it brighter than open: that shows unless it is cut off at once. */
static struct aob_clearance clearance(const void *values)
{
    const struct values *v = values;
    bool two = v->resolutions == TWO, cut_off = v->hemisphere || (v->amplification && !two);
    float fine = two ? v->fine_radius : 1, coarse = (float)v->divisor, finer = two ? 1 / fine : 1;
    return (struct aob_clearance){
        .occluders = AOB_OCCLUDERS_IN_FRONT,
        .sine = v->samples >= 6 && cut_off ? 1 : 0,
        .rise = 5e-4f * fine,
        .least_pixels = (int32_t)ceilf(3 * fmaxf(coarse, finer)),
        .because = cut_off ? "fewer than six samples may all lie where a sphere is thin"
                           : "without normals what lies behind a plane makes it brighter than open"};
}

AOB_TECHNIQUE(
    volumetric_obscurance, .title = "Volumetric obscurance", .revision = 3,
    .shaders = aob_shaders_volumetric_obscurance,
    .summary =
        "The empty share of the half sphere above the surface point, by lines along the view that end at "
        "the depth buffer: a flat wall is open. Without normals, that of the whole sphere, doubled.",
    .notes =
        "The set-up is that of a secondary text: lines come in point-symmetric pairs; depth differences "
        "in perspective are "
        "taken as zc (1 - zc/z), which keeps walls open and holds for radii well below the depth; two "
        "resolutions are mixed evenly before the clamp. With hemisphere off more than half of the sphere is "
        "empty "
        "at a convex edge, so its value is above 1 there: the clamp hides that on open surfaces, but in "
        "the mean of two resolutions it takes away what the other one found, and convex parts that are "
        "occluded are too bright; blur and upsampling read normals.",
    .citation = "Loos, Sloan: Volumetric Obscurance, I3D 2010, as compared in McGuire et al.: The Alchemy "
                "Screen-Space Ambient Obscurance Algorithm, HPG 2011",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_UNIFORM, .falloff = falloff, .map = map},
    .by_definition = by_definition, .sampling = {"samples", AOB_SEQUENCE_STRATIFIED}, .check = check,
    .clearance = clearance, .build = build);
