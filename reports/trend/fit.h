/* The levels of a series for its chart. */
#ifndef AOB_REPORTS_TREND_FIT_H
#define AOB_REPORTS_TREND_FIT_H
#include "model.h"

/* The dot where the change began that the dot's verdict tells of: that of `since`, or itself where there is none. */
size_t aob_trend_since(const struct aob_trend_series *series, size_t dot);

/* Fills the dots' levels and `levels` of a series that has its dots. What was decided stands: a level begins where a decided
 * verdict says that one began, and aob_levels_fit cuts what lies between. Only nights that ran count, and no outliers. */
void aob_trend_fit(struct aob_trend_series *series);
#endif
