/* Crytek's screen-space ambient occlusion: Kajalin, "Screen-Space Ambient Occlusion", ShaderX7 (2009), 6.1, as in
 * Crysis (2007): the open share of a sphere about the surface point. A flat wall gives one half, by design, and a
 * convex edge more.
 *
 * What it claims: a point of the sphere is open if no surface lies between it and the centre, so directions count
 * uniformly, an occluder at distance t counts the samples that are longer, and the half of the sphere below the
 * surface is solid: A = V / 2, then amplified. That the estimate finds a convex edge brighter than a plane, and that
 * the range check pulls samples towards its default, is no part of the definition.
 *
 * Notes. The listing is followed in what it means:
 * - Its rotation matrix has signs (m10, m20) with which it is no rotation; here it takes the z axis to the vector.
 * - Its rotationTC is screenSize * screenSize / 4; the tile repeats every four pixels.
 * - fRangeIsValid is 0 where the range is valid.
 * - Its offsets are shares of the screen's width and height in x and y, and 2 x depth x share along z: a sphere only
 *   where the field of view is 90 degrees and the screen square. Here a share s is a sphere of 2 x depth x s in scene
 *   units (`size` = screen), or the longest offset is `radius` at all depths (`size` = scene). In the listing the
 *   longest is .01 x (1 + 2.4/N)^N: .082, .094, .098 of the screen for N = 8, 16, 24.
 * - Reads outside the image return its edge, as the text argues for.
 * The hemisphere, which the text names only, ignores what does not rise above the tangent plane: without that an open
 * wall tilted by 30 degrees had a mean of .975 at 160x90, darkened by its own pixels. */
#include <aobudget/steps.h>
#include <math.h>
#include "shaders.h"

enum { TILE = 4 };

struct values {
    float radius, screen_radius, range, range_default, blur_tolerance;
    int32_t samples, size, rotation, hemisphere, amplification, blur, divisor, depth_divisor, seed;
};

static const char *const sizes[] = {"scene", "screen", NULL};
static const char *const rotations[] = {"matrix", "mirror", NULL};
static const char *const switches[] = {"off", "on", NULL};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-6, .max = 1e6,
              .initial = 0.5,
              .doc = "Length of the longest offset; more darkens from farther. With size = screen only the "
                     "truth's radius."),
    AOB_PARAM(struct values, screen_radius, .scale = AOB_LOG2, .min = 1e-4, .max = 1, .initial = 0.0936,
              .doc =
                  "With size = screen: the longest offset (the text's offsetScale at its end) as a share of "
                  "a 90-degree view; more darkens from farther."),
    AOB_PARAM(struct values, range, .scale = AOB_LOG2, .min = 1e-3, .max = 1e6, .initial = 1,
              .doc =
                  "How much nearer than the centre, as a share of its own depth, a surface is when it counts "
                  "range_default only (fRangeIsValid); more lets it occlude from farther in front."),
    AOB_PARAM(struct values, range_default, .min = 0, .max = 1, .initial = 0.5,
              .doc = "What a sample out of range counts; more brightens beside nearer objects."),
    AOB_PARAM(struct values, samples, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_CONSTANT,
              .min = 8, .max = 4096, .initial = 16,
              .doc = "Offsets a pixel, a multiple of 8 (nSamplesNum, 8, 16 or 24; beyond, further cubes are "
                     "turned as well); more lowers noise."),
    AOB_PARAM(struct values, size, .stage = AOB_CONSTANT, .choices = sizes, .initial = 0,
              .doc =
                  "What stays the same at all depths: the sphere in the scene, or on the screen (the text)."),
    AOB_PARAM(struct values, rotation, .stage = AOB_CONSTANT, .choices = rotations, .initial = 0,
              .doc =
                  "How the tile's vector turns the offsets: by a matrix, or by mirroring at the plane across "
                  "it, which is cheaper."),
    AOB_PARAM(struct values, hemisphere, .stage = AOB_CONSTANT, .choices = switches,
              .doc = "On reads normals and flips the offsets to the normal's side, which wastes none "
                     "and makes a flat wall 1 (the text's future improvement)."),
    AOB_PARAM(struct values, amplification, .stage = AOB_CONSTANT, .choices = switches, .initial = 1,
              .doc = "On makes the result min(1, A*A + A): a flat wall is .75, and 1 is reached at .618."),
    AOB_PARAM_TILE_BLUR(struct values, blur),
    AOB_PARAM_TILE_TOLERANCE(struct values, blur_tolerance),
    AOB_PARAM_DIVISOR(struct values, divisor),
    AOB_PARAM_DEPTH_DIVISOR(struct values, depth_divisor),
    AOB_PARAM(struct values, seed, .stage = AOB_CONSTANT, .min = 0, .max = 1e6, .initial = 0,
              .doc = "Seed of the tile's 16 random vectors (sRotSampler4x4)."),
};

/* The share of the offsets that are at least t long: offset i of N is (1 + 2.4/N)^(i + 1 - N) of the longest. */
static float falloff(const void *values, float t)
{
    const struct values *v = values;
    double steps = t > 0 ? floor(-log((double)t) / log1p(2.4 / v->samples) + 1e-6) : INFINITY;
    return (float)(fmin(steps + 1, v->samples) / v->samples);
}

/* A sphere of the screen's has another radius at each depth. */
static float definition_radius(const void *values)
{
    const struct values *v = values;
    return v->size ? NAN : v->radius;
}

static float map(const void *values, float visibility)
{
    const struct values *v = values;
    float a = v->hemisphere ? visibility : 0.5f * visibility;
    return v->amplification ? fminf(1, a * a + a) : a;
}

/* Integer hash (Wang 2007), to [0, 1). */
static double hash(uint32_t x)
{
    x = (x ^ 61u) ^ (x >> 16);
    x *= 9u;
    x = (x ^ (x >> 4)) * 0x27d4eb2du;
    return (x ^ (x >> 15)) / 4294967296.0;
}

/* 16 unit vectors, one in each of 16 layers of the sphere of equal area, as the listing's rgb = (v + 1) / 2. */
static void fill_tile(const void *values, void *texels)
{
    static const int layers[TILE * TILE] = {0, 8, 2, 10, 12, 4, 14, 6, 3, 11, 1, 9, 15, 7, 13, 5};
    const struct values *v = values;
    unsigned char *rgba = texels;
    for (uint32_t i = 0; i < TILE * TILE; i++, rgba += 4) {
        double z = 1 - (2 * layers[i] + 1) / 16.0, r = sqrt(1 - z * z);
        double a = 6.28318530717959 * hash((uint32_t)v->seed * 16u + i);
        double xyz[3] = {r * cos(a), r * sin(a), z};
        for (int k = 0; k < 3; k++)
            rgba[k] = (unsigned char)(127.5 + 127.5 * xyz[k] + 0.5);
        rgba[3] = 0;
    }
}

static bool check(const void *values, const char **why)
{
    const struct values *v = values;
    *why = "samples: must be a multiple of 8, the corners of a cube";
    if (v->samples % 8)
        return false;
    *why = "blur: must be 5, the tile, or 0, off";
    return v->blur == 0 || v->blur == 5;
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    uint32_t reads = AOB_DEPTH | AOB_CLEARANCE | (v->hemisphere ? AOB_NORMAL : 0);
    aob_tex tile = aob_texture(graph, .name = "tile", .format = AOB_RGBA8, .width = TILE, .height = TILE,
                               .fill = fill_tile);
    aob_tex raw = aob_texture(graph, .name = "access", .format = AOB_R16F, .divisor = (uint32_t)v->divisor);
    aob_tex low = aob_step_downsample(graph, .divisor = v->depth_divisor);
    aob_pass(graph, .name = "access", .shader = "access", .reads = reads, .depth = low, .border = AOB_CLAMP,
             .in = {{.name = "tile", .tex = tile}}, .out = {{.name = "access", .tex = raw}});
    raw = aob_step_tile_blur(graph, .tex = raw, .taps = v->blur, .divisor = v->divisor);
    return aob_output(graph, AOB_OUT_VISIBILITY, aob_step_upsample(graph, .tex = raw, .divisor = v->divisor));
}

static const struct aob_by_definition by_definition[] = {
    {"plane_is_open", "\"In the case of a flat wall ... the visibility ratio is approximately 0.5\" (6.1, "
                      "figure 6.1.4), which is .75 amplified."},
    {"tilted_plane", "Occlusion from points \"having a too big depth difference compared to the center\" is "
                     "replaced by a default (6.1, Depth Range Check), and a steep plane has such differences "
                     "within the sphere."},
    {"faces_alike", "Occlusion from points \"having a too big depth difference compared to the center\" is "
                    "replaced by a default (6.1, Depth Range Check), and a steep plane has such differences "
                    "within the sphere."},
    {"more_radius_darkens", "\"Pixels on the edge appear brighter than on the rest of the object\" (6.1, "
                            "figure 6.1.4, right), and a larger sphere meets more edges."},
    {"crease_to_corner",
     "The depth range check of the listing (fRangeIsValid) divides by the depth, and what is as far away "
     "has half the depth 60 degrees off the axis."},
    {"ortho_slides", "The depth range check of the listing (fRangeIsValid) divides by the depth, so that "
                     "what is out of range depends on the distance of the camera."},
    {"border_is_open",
     "Overview: \"depth values of a scene behind the edges of the screen are very similar to the values "
     "right at the border\", so reads return the edge, which bends a tilted plane."},
    {"step_edge_halo",
     "Listing, fRangeIsValid: a nearer surface is faded out by its difference as a share of its own depth, "
     "whatever the radius; to one that is nearer by less than its depth it is an occluder."},
    {"thin_fence",
     "Listing, fRangeIsValid: a nearer surface is faded out by its difference as a share of its own depth, "
     "whatever the radius; to one that is nearer by less than its depth it is an occluder."},
    {"approach_crease", "Overview: \"geometry outside of the camera frustum does not cast occlusion\"; of "
                        "the offsets, as long as ever, most then lie there, and read the edge's depth."},
    {"closer_than_radius",
     "Overview: \"geometry outside of the camera frustum does not cast occlusion\"; of the offsets, as long "
     "as ever, most then lie there, and pixels on an edge \"appear brighter\"."},
    {"inside_box", "Overview: \"geometry outside of the camera frustum does not cast occlusion\"; of the "
                   "offsets, as long as ever, most then lie there, and read the edge's depth."},
    {"radius_below_pixel",
     "The listing's last line squares a pixel's share of open samples before anything is blurred "
     "(A*A + A, 6.1): noise makes it brighter, and there is none below a pixel."},
    {"radius_enormous",
     "A few samples at fixed shares of the radius (6.1, the listing); beyond the image the depth is the "
     "edge's (Geometry outside of the camera frustum), and before the eye all is open."},
    {0},
};

/* With the hemisphere a sample counts whole where the surface at its pixel rises above the tangent plane by no more than 1e-5 of how far
 * away it is and 1e-6 of the depth. So a plane is 1, whatever the range check says. Of the whole sphere a plane has no one value: its
 * share depends on how the offsets fall in each pixel, and on how steep the plane is. */
static struct aob_clearance clearance(const void *values)
{
    const struct values *v = values;
    return (struct aob_clearance){
        .occluders = AOB_OCCLUDERS_IN_FRONT,
        .sine = v->hemisphere && v->size == 0 ? 1e-5f : 0,
        .inside = true,
        .because = v->hemisphere ? "the sphere of size = screen has another radius at each depth"
                                 : "an open plane has no one value without hemisphere = on"};
}

AOB_TECHNIQUE(
    crytek_ssao, .title = "Crytek screen-space ambient occlusion", .revision = 3,
    .shaders = aob_shaders_crytek_ssao,
    .citation = "Kajalin: Screen-Space Ambient Occlusion, ShaderX7 (2009), 6.1",
    .summary = "The share of a sphere about the surface point that lies in front of the depth buffer, "
               "from the corners of one to three cubes. A flat wall is one half by design (.75 "
               "amplified), a convex edge brighter.",
    .notes = "The rotation matrix has its signs corrected, the tile its size. The longest offset is "
             "a length in the scene or a share of the screen as of a 90-degree view, a sphere "
             "either way; the text's is the screen's, which claims nothing that could be traced. The blur is "
             "a centred box of 5x5 taps, the outer ones by half, with a test against the tangent plane. More "
             "than 24 samples turn the further cubes as well.",
    .params = params, .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
    .definition = {.weight = AOB_WEIGHT_UNIFORM, .radius = definition_radius, .falloff = falloff, .map = map},
    .by_definition = by_definition, .sampling = {"samples", AOB_SEQUENCE_STRATIFIED}, .check = check,
    .clearance = clearance, .build = build);
