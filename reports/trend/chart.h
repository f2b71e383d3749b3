/* The chart of one series as inline SVG: nights by their dates against the ratio to the fixed pass, and below strips of
 * error in band, memory and images. */
#ifndef AOB_REPORTS_TREND_CHART_H
#define AOB_REPORTS_TREND_CHART_H
#include "base/text.h"
#include "model.h"

/* Where the ratios stand, in units of the chart, which is 360 wide: y grows downwards. */
#define AOB_TREND_LEFT   50.0
#define AOB_TREND_RIGHT  350.0
#define AOB_TREND_TOP    8.0
#define AOB_TREND_BOTTOM 108.0

struct aob_trend_axis {
    double low, high; /* ratios at the bottom and at the top */
};

/* From the least to the greatest ratio, level and end of an interval, and a twentieth of that span more at each side, but at
 * least 2 % of the middle. What lies more than a half beyond the levels does not widen it. 0 and 1 without a level. */
struct aob_trend_axis aob_trend_axis(const struct aob_trend_series *series);

/* Places of a night and of a ratio; a ratio beyond the axis stands at its end. */
double aob_trend_x(const struct aob_trend_calendar *calendar, size_t night);
double aob_trend_y(const struct aob_trend_axis *axis, double ratio);

/* How many dots lie beyond the axis; they are drawn as arrows at its ends. */
size_t aob_trend_beyond(const struct aob_trend_series *series);

/* How many dots have another image than the one before them that has one; *latest is the last of them. */
size_t aob_trend_images(const struct aob_trend_series *series, size_t *latest);

/* A tick for each night of a calendar, which the charts of its series use by name: once a page, in front of them. */
void aob_trend_ticks(struct aob_text *page, const struct aob_trend_calendar *calendar);

/* Adds the chart of a series that has a dot. aob_trend_open and aob_trend_ticks stand in front of it. */
void aob_trend_chart(struct aob_text *page, const struct aob_trend_series *series);
#endif
