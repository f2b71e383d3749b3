/* How an image of a device agrees with that of the software drivers, and how far it may differ.
 *
 * The tolerances (docs/decisions/0029-tolerances-of-gpu-check.md): Vulkan lets a device err by 2^-11 in sin and cos, and by
 * units of the last place in roots and quotients. A tap then falls on the next texel now and then, which changes single
 * pixels visibly, but not all in one direction, and hardly the error against the truth. The software drivers do the same
 * operations in the same order; they get what another processor's contraction of products and sums may do. */
#ifndef AOB_GPU_CHECK_AGREEMENT_H
#define AOB_GPU_CHECK_AGREEMENT_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_agreement_desc {
    int width, height;
    const float *image, *expected; /* visibility */
    const float *truth;            /* NULL: not known */
    const float *depth;            /* sky where >= sky_depth: such pixels do not count */
    float sky_depth;
};
struct aob_agreement {
    size_t pixels;              /* that count */
    double visible_share;       /* of those, that differ by more than 1/255: one step of an 8-bit image */
    double bias, rms, max;      /* of image less expected; NAN and INFINITY where the image holds such */
    double rmse, expected_rmse; /* against the truth; NAN where that is not known */
};
void aob_agreement_measure(const struct aob_agreement_desc *desc, struct aob_agreement *agreement);

/* False with a line that names the figure and its tolerance. `software`: the device is a software driver. */
bool aob_agreement_judge(const struct aob_agreement *agreement, bool software, struct aob_error *error);
#endif
