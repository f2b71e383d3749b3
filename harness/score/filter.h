/* Separable filters of an image, one row at a time. An image repeats its outermost pixels beyond its edges. Sums are
 * doubles, in a fixed order. */
#ifndef AOB_SCORE_FILTER_H
#define AOB_SCORE_FILTER_H
#include "score.h"

enum { AOB_KERNEL_RADIUS_MAX = 10 };
struct aob_kernel { /* weight[radius + i] is that of the pixel i to the right, or below */
    int radius;
    double weight[2 * AOB_KERNEL_RADIUS_MAX + 1];
};
/* A Gaussian whose weights add up to 1; sigma in pixels. */
struct aob_kernel aob_kernel_gauss(int radius, double sigma);

/* Returns a copy of the image with 1 in the sky of desc, whatever the image holds there; free() it. */
double *aob_filter_plane(const struct aob_score_desc *desc, const float *image);

/* One plane, or the product of two. */
struct aob_planes {
    const double *a, *b; /* b NULL: a alone */
    int width, height;
};
/* Filters row y down, into a column sum for each pixel. `column` holds width + 2 * AOB_KERNEL_RADIUS_MAX doubles;
 * pixel 0 is the one at AOB_KERNEL_RADIUS_MAX, and the function fills in what is beyond the edges. */
void aob_filter_down(const struct aob_planes *planes, const struct aob_kernel *kernel, int y, double *column);

/* Then filters the same row across; `row` holds width doubles. */
void aob_filter_across(const double *column, const struct aob_kernel *kernel, int width, double *row);
#endif
