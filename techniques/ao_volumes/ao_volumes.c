/* Ambient occlusion volumes: McGuire, "Ambient Occlusion Volumes", two-page text of 2010. Each triangle's volume is
 * drawn over the image; every pixel in it adds the triangle's form factor in closed form. */
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius;
    int32_t falloff, sides, cull, divisor;
};

static const char *const switches[] = {"off", "on", NULL};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.25,
              .doc =
                  "The text's delta: farthest distance of an occluder, and how far a volume reaches beyond "
                  "its triangle; more darkens more, and draws larger volumes."),
    AOB_PARAM(struct values, falloff, .stage = AOB_CONSTANT, .min = 0, .max = 1, .initial = 0,
              .doc =
                  "0: the part of a triangle within the radius counts; 1: all of it counts, times "
                  "1 - (its distance)/radius, and the image depends on how surfaces are cut into triangles."),
    AOB_PARAM(struct values, sides, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 3, .max = 64,
              .initial = 8,
              .doc = "Sides of the polygon that stands for the disc within the radius (falloff 0); more is "
                     "rounder."),
    AOB_PARAM(struct values, cull, .stage = AOB_CONSTANT, .choices = switches, .initial = 1,
              .doc = "On draws a volume over the tiles only whose surfaces lie in its depths, and not at all "
                     "where there are none; off over all of its rectangle; the image is the same."),
    AOB_PARAM(struct values, divisor, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_HOST, .min = 1,
              .max = 4, .rule = AOB_POWER_OF_TWO, .initial = 4,
              .doc = "Divides the size of the AO, upsampled at the end: 1 full, 2 half, 4 quarter (the text "
                     "samples less than each pixel too); less costs up to 16 times as much."),
};

static float falloff(const void *values, float t)
{
    return ((const struct values *)values)->falloff ? 1 - t : 1;
}

static enum aob_distance distance(const void *values)
{
    return ((const struct values *)values)->falloff ? AOB_DISTANCE_TRIANGLE : AOB_DISTANCE_RAY;
}

/* The polygon has the disc's area, so its corners lie outside the disc; volume.glsl has the same ratio. */
static float reach(const struct values *v)
{
    float k = (float)v->sides, turn = 6.2831853f / k;
    return v->falloff ? v->radius : v->radius * sqrtf(turn / sinf(turn));
}

enum { TILE = 8 }; /* tile_size.glsl */

/* Depths of the tiles, by which volumes are culled; id 0 where they are not. */
static aob_tex tiles(struct aob_graph *graph, const struct values *v)
{
    if (!v->cull)
        return (aob_tex){0};
    aob_tex ranges =
        aob_texture(graph, .name = "tiles", .format = AOB_RG32F, .divisor = (uint32_t)(TILE * v->divisor));
    aob_pass(graph, .name = "tiles", .shader = "tiles", .reads = AOB_DEPTH,
             .out = {{.name = "range", .tex = ranges}});
    return ranges;
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    uint32_t divisor = (uint32_t)v->divisor;
    aob_tex ranges = tiles(graph, v);
    aob_tex sum = aob_texture(graph, .name = "occlusion", .format = AOB_R32F, .divisor = divisor);
    aob_tex low = aob_texture(graph, .name = "visibility", .format = AOB_R32F, .divisor = divisor);
    aob_pass(graph, .name = "volumes", .draw = AOB_TRIANGLES, .vertex = "bounds", .shader = "volume",
             .per_triangle = 6, .reach = reach(v), .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = v->cull ? "tiles" : NULL, .tex = ranges}},
             .out = {{.name = "occlusion", .tex = sum}});
    aob_pass(graph, .name = "visibility", .shader = "visibility", .in = {{.name = "occlusion", .tex = sum}},
             .out = {{.name = "visibility", .tex = low}});
    return aob_output(graph, AOB_OUT_VISIBILITY, aob_step_upsample(graph, .tex = low, .divisor = v->divisor));
}

static const struct aob_by_definition by_definition[] = {
    {"coincident_faces",
     "Algorithm: \"Where many thin objects are stacked, the volumes can interpenetrate and produce darker "
     "results than ray tracing\"; a face that lies twice has two volumes."},
    {"inverted_faces", "Algorithm: a volume is its polygon \"extruded along its face normal\", so that "
                       "nothing lies before a face that is turned away."},
    {0},
};

static struct aob_clearance clearance(const void *values)
{
    (void)values;
    return (struct aob_clearance){
        .because = "triangles darken what they are near to, and no depth image shows them all"};
}

AOB_TECHNIQUE(
    ao_volumes, .title = "Ambient occlusion volumes", .revision = 6, .shaders = aob_shaders_ao_volumes,
    .summary = "The scene's triangles themselves, not the depth buffer, occlude: each is clipped to the "
               "pixel's tangent plane and to the radius, and its form factor is added in closed form.",
    .notes =
        "A triangle counts where its front faces the pixel: meshes must be closed, fronts outwards; an open "
        "sheet casts nothing behind it. Volumes of surfaces thinner than half the radius overlap and are "
        "counted twice: darker than ray tracing, as the text says. The text gives no distance limit; "
        "falloff 0 clips to the disc that the ball of the radius cuts out of the triangle's plane; falloff 1 "
        "is traced by the distance of the triangle that a ray meets, at any length of the ray. Each volume "
        "is drawn as the rectangle in the image of two boxes around it, and its pixels decide: more "
        "fragments than the text's prisms. Volumes that reach no surface are culled by the depths of tiles "
        "of 8 x 8 pixels. "
        "The text gives the signed area of a disc's segment; here it is Lambert's sum, with angles by atan2.",
    .citation = "McGuire: Ambient Occlusion Volumes, text of two pages (2010)", .params = params,
    .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_COSINE, .falloff = falloff, .distance = distance},
    .by_definition = by_definition, .clearance = clearance, .build = build);
