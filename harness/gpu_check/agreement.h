/* How an image of a device agrees with that of the software drivers, and how far it may differ.
 *
 * The tolerances (docs/decisions/0029-tolerances-of-gpu-check.md): Vulkan lets a device err by 2^-11 in sin and cos, and by
 * units of the last place in roots and quotients. A tap then falls on the next texel now and then, which changes single
 * pixels visibly, but not all in one direction, and hardly the error against the truth. The software drivers do the same
 * operations in the same order; they get what another processor's contraction of products and sums may do.
 *
 * A tap changes every output by about the same part of its range, so all are judged in parts of that: their scale. It is 1
 * of a share (visibility, that after bounces, specular), whose values lie in 0..1, and 2 of a bent normal, whose components
 * lie in -1..1. The scale of light is what the surfaces of the view would receive if they were open, over pi, the mean over
 * pixels and channels: a visibility of 1 is made into that. Two outputs answer more than a visibility does and get more of a GPU: specular,
 * as a lobe may be narrow, and light, as a surface that faces it receives several times the mean. */
#ifndef AOB_GPU_CHECK_AGREEMENT_H
#define AOB_GPU_CHECK_AGREEMENT_H
#include <aobudget/technique.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "scene/light.h"

struct aob_agreement_desc {
    enum aob_output output;
    int width, height;
    const float *image, *expected; /* aob_output_components floats a pixel */
    const float *truth;            /* the same; NULL: not known */
    const float *depth;            /* sky where >= sky_depth: such pixels do not count */
    float sky_depth;
    const float *normal;           /* four floats a pixel, view space; of light only, like the next */
    const struct aob_light *light; /* view space */
};
struct aob_agreement { /* figures in the output's own unit, over all its components */
    enum aob_output output;
    double scale;
    size_t pixels;        /* that count */
    double visible_share; /* of those, that differ by more than scale/255 in a component: a step of 8 bits */
    double bias;          /* of image less expected, in the component where it is farthest from 0; */
    int component;        /* that one */
    double rms, max;      /* of the same; NAN and INFINITY where the image holds such */
    double rmse, expected_rmse; /* against the truth; NAN where that is not known */
};
void aob_agreement_measure(const struct aob_agreement_desc *desc, struct aob_agreement *agreement);

/* False with a line that names the figure and its tolerance. `software`: the device is a software driver. */
bool aob_agreement_judge(const struct aob_agreement *agreement, bool software, struct aob_error *error);
#endif
