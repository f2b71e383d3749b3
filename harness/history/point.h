/* What a point says of its cost. Pure functions. */
#ifndef AOB_HISTORY_POINT_H
#define AOB_HISTORY_POINT_H
#include "line.h"

/* Whether it has a cost: its status is "ok", and its ratio finite and above 0. */
bool aob_point_is_timed(const struct aob_point *point);

/* The width of its interval, ln(high / low), and never less than .001, as no clock knows a ratio better. NAN: it has none. */
double aob_point_width(const struct aob_point *point);

/* The weight of each of n points in a fit of levels (level.h) from their widths: 1 / width, where a width counts as at least half
 * and at most four times the median one, so that no point outweighs many. A NAN counts as most. */
void aob_point_weights(const double *widths, size_t n, double *weights);
#endif
