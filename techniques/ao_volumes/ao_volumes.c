/* Ambient occlusion volumes: McGuire, "Ambient Occlusion Volumes", two-page text of 2010. Each triangle's volume is drawn
 * over the image; every pixel in it adds the triangle's form factor in closed form. */
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

struct values {
    float radius;
    int32_t falloff, sides, divisor;
};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5,
              .doc =
                  "The text's delta: farthest distance of an occluder, and how far a volume reaches beyond "
                  "its triangle; more darkens more, and draws larger volumes."),
    AOB_PARAM(struct values, falloff, .stage = AOB_CONSTANT, .min = 0, .max = 1, .initial = 0,
              .doc =
                  "0: the part of a triangle within the radius counts; 1: all of it counts, times "
                  "1 - (its distance)/radius, and the image depends on how surfaces are cut into triangles."),
    AOB_PARAM(struct values, sides, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 3, .max = 64,
              .initial = 8,
              .doc = "Of the polygon that stands for the disc within the radius (falloff 0); more is "
                     "rounder."),
    AOB_PARAM_DIVISOR(struct values, divisor),
};

static bool check(const void *values, const char **why)
{
    return aob_step_divisor_check(((const struct values *)values)->divisor, why);
}

/* With falloff 1 what a hit counts depends on the triangle that is hit, which no falloff over the distance says. */
static float definition_radius(const void *values)
{
    const struct values *v = values;
    return v->falloff ? NAN : v->radius;
}

/* The polygon has the disc's area, so its corners lie outside the disc; volume.glsl has the same ratio. */
static float reach(const struct values *v)
{
    float k = (float)v->sides, turn = 6.2831853f / k;
    return v->falloff ? v->radius : v->radius * sqrtf(turn / sinf(turn));
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    uint32_t divisor = (uint32_t)v->divisor;
    aob_tex sum = aob_texture(graph, .name = "occlusion", .format = AOB_R32F, .divisor = divisor);
    aob_tex low = aob_texture(graph, .name = "visibility", .format = AOB_R32F, .divisor = divisor);
    aob_pass(graph, .name = "volumes", .draw = AOB_TRIANGLES, .vertex = "bounds", .shader = "volume",
             .per_triangle = 6, .reach = reach(v), .reads = AOB_DEPTH | AOB_NORMAL,
             .out = {{.name = "occlusion", .tex = sum}});
    aob_pass(graph, .name = "visibility", .shader = "visibility", .in = {{.name = "occlusion", .tex = sum}},
             .out = {{.name = "visibility", .tex = low}});
    return aob_output(graph, AOB_OUT_VISIBILITY, aob_step_upsample(graph, low, v->divisor));
}

AOB_TECHNIQUE(
    ao_volumes, .title = "Ambient occlusion volumes", .revision = 1, .shaders = aob_shaders_ao_volumes,
    .summary = "The scene's triangles themselves, not the depth buffer, occlude: each is clipped to the "
               "pixel's tangent plane and to the radius, and its form factor is added in closed form.",
    .notes =
        "A triangle counts where its front faces the pixel: meshes must be closed, fronts outwards; an open "
        "sheet casts nothing behind it. Volumes of surfaces thinner than half the radius overlap and are "
        "counted twice: darker than ray tracing, as the text says. The text gives no distance limit; "
        "falloff 0 clips to the disc that the ball of the radius cuts out of the triangle's plane; falloff 1 "
        "depends on the triangle that a ray meets, which no falloff over distance says: it is compared with "
        "nothing "
        "of its own. Each volume is drawn as the rectangle of its box in the image, and its pixels decide: "
        "more "
        "fragments than the text's prisms. "
        "The text gives the signed area of a disc's segment; here it is Lambert's sum, with angles by atan2.",
    .citation = "McGuire: Ambient Occlusion Volumes, text of two pages (2010)", .params = params,
    .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_COSINE, .radius = definition_radius}, .check = check, .build = build);
