/* Flicker: how much the error of a technique changes from frame to frame at one point of a surface. What the truth itself
 * changes is no flicker, and neither is what the technique is wrong by all the time.
 *
 * A point of a frame is compared with where it was in the frame before, which its velocity says, bilinearly over the four
 * pixels about that place. It counts only if each of them that has a weight is within the view and shows the same surface:
 * the point's earlier place lies within half a pixel's width of the plane of what that pixel shows, and the normals are within
 * 25 degrees. So what comes into view, what a moving thing uncovers, and edges do not count; a part of a pixel below 1/1000
 * has no weight. With e = technique - truth, p a pixel, q its earlier place and w the four weights,
 *
 *   flicker^2 = mean over points and frames of (e_t(p) - e_t-1(q))^2 - SE_t(p)^2 - sum of w^2 SE_t-1^2
 *
 * and at least 0: the truths are estimates of independent noise, and their standard errors say how much of the change is
 * theirs. */
#ifndef AOB_SCORE_FLICKER_H
#define AOB_SCORE_FLICKER_H
#include <stddef.h>
#include "gbuffer/gbuffer.h"
#include "scene/affine.h"

struct aob_flicker_frame {
    const struct aob_gbuffer *gbuffer; /* of both frames the same projection and guard band */
    const float *image, *truth;        /* of the view, which is the G-buffer without its guard band */
    const float *se;                   /* of the truth; NULL: it is exact */
};
struct aob_flicker_desc {
    struct aob_flicker_frame now, before;
    struct aob_affine then; /* from the view space of `now` into that of `before`, of what stands still */
    bool same_noise;        /* the truths have the same noise: nothing of the change is theirs */
};

/* Sums over the points of some pairs of frames; zeros to begin with. */
struct aob_flicker {
    double change, truth_change, noise; /* squares: of the error, of the truth, and what of each is noise */
    size_t compared, surfaces;          /* points that count; points that a surface shows in */
};
void aob_flicker_add(struct aob_flicker *sum, const struct aob_flicker_desc *desc);

/* RMS values less the noise, 0 or more; NAN if no point was compared. */
double aob_flicker_value(const struct aob_flicker *sum);
double
aob_flicker_truth_change(const struct aob_flicker *sum); /* for scale: how much the truth changes itself */

/* The share of the points that were compared; NAN if there is none. */
double aob_flicker_compared(const struct aob_flicker *sum);
#endif
