#include "ssim.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "filter.h"

enum { RADIUS = 5, MOMENTS = 5 };

/* Means of a, b, aa, bb and ab in one window. */
static double similarity(const double m[MOMENTS])
{
    const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    double aa = m[0] * m[0], bb = m[1] * m[1], ab = m[0] * m[1];
    return (2 * ab + c1) * (2 * (m[4] - ab) + c2) / ((aa + bb + c1) * (m[2] - aa + (m[3] - bb) + c2));
}

struct work {
    double *a, *b;
    double *column, *rows; /* rows: MOMENTS times the width */
    double sum;
    size_t count;
};

static void add_row(const struct aob_score_desc *desc, const struct aob_kernel *gauss, int y, struct work *w)
{
    const double *const pairs[MOMENTS][2] = {
        {w->a, NULL}, {w->b, NULL}, {w->a, w->a}, {w->b, w->b}, {w->a, w->b}};
    size_t width = (size_t)desc->width;
    for (size_t k = 0; k < MOMENTS; k++) {
        const struct aob_planes planes = {pairs[k][0], pairs[k][1], desc->width, desc->height};
        aob_filter_down(&planes, gauss, y, w->column);
        aob_filter_across(w->column, gauss, desc->width, w->rows + k * width);
    }
    for (size_t x = RADIUS; x + RADIUS < width; x++) {
        if (aob_score_is_sky(desc, (size_t)y * width + x))
            continue;
        double moments[MOMENTS];
        for (size_t k = 0; k < MOMENTS; k++)
            moments[k] = w->rows[k * width + x];
        w->sum += similarity(moments);
        w->count++;
    }
}

double aob_ssim(const struct aob_score_desc *desc)
{
    size_t width = (size_t)desc->width;
    struct aob_kernel gauss = aob_kernel_gauss(RADIUS, 1.5);
    struct work work = {.a = aob_filter_plane(desc, desc->image),
                        .b = aob_filter_plane(desc, desc->truth),
                        .column = AOB_NEW_ARRAY(double, width + 2 * AOB_KERNEL_RADIUS_MAX),
                        .rows = AOB_NEW_ARRAY(double, MOMENTS *width)};
    for (int y = RADIUS; y + RADIUS < desc->height; y++)
        add_row(desc, &gauss, y, &work);
    free(work.a);
    free(work.b);
    free(work.column);
    free(work.rows);
    return work.count ? work.sum / (double)work.count : NAN;
}
