#include "point.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/statistics.h"

static const double narrowest = 1e-3, least_share = 0.5, most_share = 4;

bool aob_point_is_timed(const struct aob_point *point)
{
    return point->status && strcmp(point->status, "ok") == 0 && isfinite(point->ratio) && point->ratio > 0;
}

double aob_point_width(const struct aob_point *point)
{
    bool known = isfinite(point->high) && point->low > 0 && point->high >= point->low;
    return known ? fmax(log(point->high / point->low), narrowest) : NAN;
}

void aob_point_weights(const double *widths, size_t n, double *weights)
{
    double *known = AOB_NEW_ARRAY(double, n + 1);
    size_t count = 0;
    for (size_t i = 0; i < n; i++)
        if (!isnan(widths[i]))
            known[count++] = widths[i];
    double usual = count ? aob_median(known, count) : narrowest;
    for (size_t i = 0; i < n; i++) {
        double width = isnan(widths[i]) ? INFINITY : widths[i];
        weights[i] = 1 / fmin(fmax(width, least_share * usual), most_share * usual);
    }
    free(known);
}
