/* The trend page of a nightly history: which series changed, by how much, since when; then a chart of each series. One HTML
 * file that needs nothing from elsewhere, drawn from structs alone. Everything from a history is escaped, and the same
 * structs give the same bytes. Threads: one a page. */
#ifndef AOB_REPORTS_TREND_TREND_H
#define AOB_REPORTS_TREND_TREND_H
#include <stdbool.h>
#include "base/error.h"
#include "history/line.h"
#include "history/night.h"

/* All is borrowed. A history without a night, and a line without a point, are drawn as such. A point of a night that
 * `nights` lacks is left out. */
struct aob_trend_desc {
    const struct aob_lines *lines;
    const struct aob_nights *nights; /* in the order of their ids; a line's chart spans those of its config */
    const char *out;                 /* the folder, which is there: index.html is written into it */
    const char *title;               /* the heading; NULL: "Trend" */
};

/* False after a line if the page cannot be written. */
bool aob_trend_write(const struct aob_trend_desc *desc, struct aob_error *error);
#endif
