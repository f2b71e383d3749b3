/* The error of an image of visibility against a reference. All images are width x height floats, row 0 at the top. No
 * score counts sky pixels. */
#ifndef AOB_SCORE_SCORE_H
#define AOB_SCORE_SCORE_H
#include <stddef.h>
#include "base/error.h"
#include "store/metric.h"

struct aob_score_desc {
    int width, height;
    const float *image, *truth;
    const float *truth_se; /* standard error of each pixel of the truth; NULL: exact */
    const float *depth;    /* scene units along the view axis; sky where >= sky_depth */
    float sky_depth;
    double radius;      /* scene units; INFINITY allowed: every pixel is then a border pixel */
    double pixel_scale; /* sy of the projection: scene units a pixel covers, at depth 1 if perspective */
    int perspective;
};
#define AOB_BAND_LIMIT 0.995

/* Whether pixel i, counted from the top left, is sky. A depth that is NaN counts as sky. */
bool aob_score_is_sky(const struct aob_score_desc *desc, size_t i);

/* False with a line if the image holds a value, over a surface, that is not finite or lies outside [0, 1]. */
bool aob_score_judge(const struct aob_score_desc *desc, struct aob_error *error);

/* Sets the metrics that are sums over pixels. Those of flip.h, ssim.h and split.h are NAN, and so is one whose class
 * has no pixel. */
void aob_score(const struct aob_score_desc *desc, struct aob_metrics *metrics);

/* Finds a technique that draws nothing: its image spans at most 0.002, where the truth, and `claim`, the technique's own
 * definition (NULL: not known), span more than 0.05. A span is that of the pixels between the quantiles 0.01 and 0.99.
 * Then it returns false, with a line that gives the value. */
bool aob_score_judge_drawn(const struct aob_score_desc *desc, const float *claim, struct aob_error *error);
#endif
