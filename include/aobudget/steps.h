/* aobudget/steps.h: steps that several techniques share, as inline helpers over technique.h. Their shaders
 * are in shaders/common/; a module includes them into a text of its own with the name said here. */
#ifndef AOBUDGET_STEPS_H
#define AOBUDGET_STEPS_H
#include "technique.h"

/* Row of a parameter table for the filter below: `field` is an int32_t of the values struct. */
#define AOB_PARAM_BLUR(T, field, taps)                                                                       \
    AOB_PARAM(T, field, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 0, .max = 33, .initial = taps, \
              .doc = "Taps of each axis of the edge-aware blur, odd; more smooths more; 0 is off.")

/* For check(): taps are 0 or odd. */
static inline bool aob_step_blur_check(int32_t taps, const char **why)
{
    *why = "blur: the number of taps must be odd, or 0";
    return taps == 0 || taps % 2 == 1;
}

/* Two passes of the separable cross-bilateral filter over visibility `raw` (text "blur" =
 * common/cross_bilateral.glsl, constant parameter `blur`). Returns the texture to output: a new one, `raw`
 * itself if taps is 0, id 0 on failure. */
static inline aob_tex aob_step_blur(struct aob_graph *graph, aob_tex raw, int32_t taps)
{
    if (!taps || !raw.id)
        return raw;
    aob_tex half = aob_texture(graph, .name = "blurred_x", .format = AOB_R16F);
    aob_tex full = aob_texture(graph, .name = "blurred", .format = AOB_R16F);
    bool ok = aob_pass(graph, .name = "blur_x", .shader = "blur", .defines = "AXIS=0",
                       .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = "raw", .tex = raw}},
                       .out = {{.name = "blurred", .tex = half}}) &&
              aob_pass(graph, .name = "blur_y", .shader = "blur", .defines = "AXIS=1",
                       .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = "raw", .tex = half}},
                       .out = {{.name = "blurred", .tex = full}});
    return ok ? full : (aob_tex){0};
}
#endif
