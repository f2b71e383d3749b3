/* The part of the trend page that is one series: its name, its chart, its figures now, and the nights that were told of. */
#ifndef AOB_REPORTS_TREND_SERIES_H
#define AOB_REPORTS_TREND_SERIES_H
#include "base/text.h"
#include "model.h"

/* Its anchor is "l" and the line's id. */
void aob_trend_series(struct aob_text *page, const struct aob_trend_series *series);
#endif
