/* aobudget/steps.h: steps that several techniques share, as inline helpers over technique.h. Their shaders are in
 * shaders/common/; a module includes them into a text of its own with the name said here. A step that fails has kept
 * its reason in the graph: build() may go on and fails at its end. */
#ifndef AOBUDGET_STEPS_H
#define AOBUDGET_STEPS_H
#include <stdio.h>
#include "technique.h"

/* Rows of a parameter table for the steps below: `field` is an int32_t of the values struct. */
#define AOB_PARAM_BLUR(T, field, taps)                                                                       \
    AOB_PARAM(T, field, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 0, .max = 33, .initial = taps, \
              .doc = "Taps of each axis of the edge-aware blur, odd; more smooths more; 0 is off.")
#define AOB_PARAM_BLUR_PASSES(T, field, passes)                                                              \
    AOB_PARAM(T, field, .unit = AOB_UNIT_COUNT, .stage = AOB_HOST, .min = 1, .max = 4, .initial = passes,    \
              .doc = "How often the blur is applied; more smooths more.")
#define AOB_PARAM_TILE_BLUR(T, field)                                                                        \
    AOB_PARAM(                                                                                               \
        T, field, .unit = AOB_UNIT_COUNT, .stage = AOB_HOST, .min = 0, .max = 5, .initial = 5,               \
        .doc =                                                                                               \
            "Taps of each axis of the depth-aware mean over a 4x4 tile: 5, the outer ones half, or 0, off.")
#define AOB_PARAM_TILE_TOLERANCE(T, field)                                                                   \
    AOB_PARAM(T, field, .scale = AOB_LOG2, .min = 1e-6, .max = 1, .initial = 0.01,                           \
              .doc =                                                                                         \
                  "How far from the centre's tangent plane, as a share of its depth, the tile blur mixes.")
#define AOB_PARAM_DIVISOR(T, field)                                                                          \
    AOB_PARAM(                                                                                               \
        T, field, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_HOST, .min = 1, .max = 4,          \
        .initial = 1,                                                                                        \
        .doc =                                                                                               \
            "Divides the size of the AO, upsampled at the end: 1 full, 2 half, 4 quarter; more is cheaper.")
#define AOB_PARAM_DEPTH_DIVISOR(T, field)                                                                    \
    AOB_PARAM(                                                                                               \
        T, field, .unit = AOB_UNIT_COUNT, .scale = AOB_LOG2, .stage = AOB_HOST, .min = 1, .max = 4,          \
        .initial = 1,                                                                                        \
        .doc = "Divides the size of the depth that is sampled: 1 full, 2 half, 4 quarter; more is cheaper.")
#define AOB_PARAM_CROSS5(T, field)                                                                           \
    AOB_PARAM(T, field, .stage = AOB_HOST, .choices = (const char *const[]){"off", "on", NULL},              \
              .doc = "A composite's cross of five pixels, weighed by surface: on smooths by a pixel.")

/* For check(): taps are 0 or odd; a divisor is 1, 2 or 4. */
static inline bool aob_step_blur_check(int32_t taps, const char **why)
{
    *why = "blur: the number of taps must be odd, or 0";
    return taps == 0 || taps % 2 == 1;
}
static inline bool aob_step_tile_blur_check(int32_t taps, const char **why)
{
    *why = "blur: must be 5, the tile, or 0, off";
    return taps == 0 || taps == 5;
}
static inline bool aob_step_divisor_check(int32_t divisor, const char **why)
{
    *why = "divisor, depth_divisor: must be 1, 2 or 4";
    return divisor == 1 || divisor == 2 || divisor == 4;
}

/* The depth divided, for aob_pass.depth: one pass with text "downsample" = common/downsample.glsl. Id 0, which is
 * the G-buffer's own depth, where the divisor is 1. */
enum aob_downsample {
    AOB_DOWNSAMPLE_FIRST,   /* the first pixel of each block: an exact surface point */
    AOB_DOWNSAMPLE_NEAREST, /* the block's nearest depth: keeps thin occluders, moves them by up to a block */
};
static inline aob_tex aob_step_downsample(struct aob_graph *graph, int32_t divisor, enum aob_downsample kind)
{
    char defines[40];
    if (divisor == 1)
        return (aob_tex){0};
    snprintf(defines, sizeof defines, "FACTOR=%d NEAREST_OF=%d", (int)divisor, (int)kind);
    aob_tex low = aob_texture(graph, .name = "low_depth", .format = AOB_R32F, .divisor = (uint32_t)divisor);
    aob_pass(graph, .name = "downsample", .shader = "downsample", .defines = defines, .reads = AOB_DEPTH,
             .out = {{.name = "depth", .tex = low}});
    return low;
}

/* `passes` times two passes of a separable filter over `raw`, whose size is the screen's by `divisor`: text "blur" =
 * common/cross_bilateral.glsl, or common/gaussian.glsl with uniform parameters blur_depth and blur_normal; constant
 * parameter `blur`. Returns the last texture: `raw` itself where taps is 0. */
static inline aob_tex aob_step_blur(struct aob_graph *graph, aob_tex raw, int32_t taps, int32_t passes,
                                    int32_t divisor)
{
    for (int i = 0; taps && i < 2 * passes; i++) {
        char name[24], defines[12];
        snprintf(name, sizeof name, "blur_%c%d", i % 2 ? 'y' : 'x', i / 2 + 1);
        snprintf(defines, sizeof defines, "AXIS=%d", i % 2);
        aob_tex next = aob_texture(graph, .name = name, .format = AOB_R16F, .divisor = (uint32_t)divisor);
        aob_pass(graph, .name = name, .shader = "blur", .defines = defines, .reads = AOB_DEPTH | AOB_NORMAL,
                 .in = {{.name = "raw", .tex = raw}}, .out = {{.name = "blurred", .tex = next}});
        raw = next;
    }
    return raw;
}

/* One pass of the mean over a tile of 4x4 pixels: text "blur" = common/tile_blur.glsl, uniform float parameter
 * blur_tolerance. `raw` itself where taps is 0. */
static inline aob_tex aob_step_tile_blur(struct aob_graph *graph, aob_tex raw, int32_t taps, int32_t divisor)
{
    if (taps == 0)
        return raw;
    aob_tex next = aob_texture(graph, .name = "tile_blur", .format = AOB_R16F, .divisor = (uint32_t)divisor);
    aob_pass(graph, .name = "tile_blur", .shader = "blur", .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = "raw", .tex = raw}}, .out = {{.name = "blurred", .tex = next}});
    return next;
}

/* Edge-aware upsampling to full size: one pass with text "upsample" = common/upsample.glsl. `low` itself where the
 * divisor is 1. */
static inline aob_tex aob_step_upsample(struct aob_graph *graph, aob_tex low, int32_t divisor)
{
    char defines[16];
    if (divisor == 1)
        return low;
    snprintf(defines, sizeof defines, "FACTOR=%d", (int)divisor);
    aob_tex full = aob_texture(graph, .name = "full", .format = AOB_R16F);
    aob_pass(graph, .name = "upsample", .shader = "upsample", .defines = defines,
             .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = "low", .tex = low}},
             .out = {{.name = "full", .tex = full}});
    return full;
}

/* The composite's cross of five pixels over `raw`, of full size: one pass with text "cross5" = common/cross5.glsl.
 * `raw` itself where it is off. */
static inline aob_tex aob_step_cross5(struct aob_graph *graph, aob_tex raw, int32_t on)
{
    if (!on)
        return raw;
    aob_tex crossed = aob_texture(graph, .name = "composite", .format = AOB_R16F);
    aob_pass(graph, .name = "composite", .shader = "cross5", .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = "raw", .tex = raw}}, .out = {{.name = "crossed", .tex = crossed}});
    return crossed;
}
#endif
