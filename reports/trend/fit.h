/* The levels of a series for its chart. */
#ifndef AOB_REPORTS_TREND_FIT_H
#define AOB_REPORTS_TREND_FIT_H
#include "model.h"

/* The dot where the change began that the dot's verdict tells of: that of `since`, or itself where there is none. */
size_t aob_trend_since(const struct aob_trend_series *series, size_t dot);

/* A border of levels is what a verdict tells of if it is at most so many dots off: levels are fitted anew each night, so it
 * may lie elsewhere than when the verdict was given. */
#define AOB_TREND_NEAR 2

/* Fills the dots' levels and `levels` of a series that has its dots, by aob_levels_fit. What was decided stands: where a
 * decided verdict says that a level began, and no border is near, one is set. Only nights that ran count, and no outliers. */
void aob_trend_fit(struct aob_trend_series *series);
#endif
