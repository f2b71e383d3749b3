#include "series.h"
#include <inttypes.h>
#include <math.h>
#include <string.h>
#include "chart.h"
#include "parts.h"
#include "reports/page/html.h"

/* A case that did not run says so in the place of its ratio. */
static void add_now(struct aob_text *page, const struct aob_trend_series *series)
{
    const struct aob_point *point = series->dots[series->count - 1].point;
    bool current = series->dots[series->count - 1].night + 1 == series->calendar->count;
    char day[11];
    aob_trend_day(day, aob_trend_dot_date(series, series->count - 1));
    if (current)
        aob_text_add(page, "now ");
    else
        aob_trend_escaped(page, "last on ", day, ": ");
    if (isfinite(point->ratio))
        aob_text_add(page, "<b>%.3f</b>", point->ratio);
    else {
        aob_trend_escaped(page, "<b>", point->status && *point->status ? point->status : "no ratio", "</b>");
        if (point->reason && *point->reason)
            aob_trend_escaped(page, ", ", point->reason, "");
    }
    if (isfinite(point->low) && isfinite(point->high))
        aob_text_add(page, " [%.3f, %.3f]", point->low, point->high);
}

static void add_level(struct aob_text *page, const struct aob_trend_series *series)
{
    const struct aob_levels *levels = &series->levels;
    char percent[32], day[11];
    if (levels->count < 2)
        return;
    aob_trend_percent(percent, levels->values[levels->count - 1] / levels->values[levels->count - 2]);
    aob_trend_day(day, aob_trend_dot_date(series, levels->starts[levels->count - 1]));
    aob_text_add(page, " \u00b7 %s", percent);
    aob_trend_escaped(page, " since ", day, "");
}

static void add_rest(struct aob_text *page, const struct aob_trend_series *series)
{
    const struct aob_point *point = series->dots[series->count - 1].point;
    size_t beyond = aob_trend_beyond(series), latest = 0, images = aob_trend_images(series, &latest);
    char day[11];
    if (isfinite(point->band_rmse))
        aob_text_add(page, " \u00b7 error in band %.4f", point->band_rmse);
    if (isfinite(point->memory_bytes))
        aob_text_add(page, " \u00b7 %.2f MiB", point->memory_bytes / 1048576);
    if (images) {
        aob_trend_day(day, aob_trend_dot_date(series, latest));
        aob_text_add(page, " \u00b7 another image %zu time%s, ", images, images > 1 ? "s" : "");
        aob_trend_escaped(page, "last on ", day, "");
    }
    if (beyond)
        aob_text_add(page, " \u00b7 %zu night%s beyond the scale", beyond, beyond > 1 ? "s" : "");
}

/* What the marks of the chart say, for those who cannot point at them. */
static void add_told(struct aob_text *page, const struct aob_trend_series *series)
{
    size_t count = 0;
    for (size_t i = 0; i < series->count; i++)
        count += *aob_trend_word(series->dots[i].point->verdict)->mark != 0;
    if (!count)
        return;
    aob_text_add(page, "<details><summary>%zu night%s told of</summary><ul>", count, count > 1 ? "s" : "");
    for (size_t i = series->count; i-- > 0;) {
        const struct aob_point *point = series->dots[i].point;
        char day[11];
        if (!*aob_trend_word(point->verdict)->mark)
            continue;
        aob_trend_day(day, aob_trend_dot_date(series, i));
        aob_trend_escaped(page, "<li>", day, " ");
        aob_trend_chip(page, point->verdict, NULL);
        aob_trend_escaped(page, " ", point->said, "</li>");
    }
    aob_text_add(page, "</ul></details>");
}

void aob_trend_series(struct aob_text *page, const struct aob_trend_series *series)
{
    aob_text_add(page, "<figure class=series id=l%" PRId64 ">", series->line->id);
    aob_text_add(page, "<p class=name><a href=#l%" PRId64 ">", series->line->id);
    aob_trend_escaped(page, "", series->line->text, "</a></p>");
    if (series->count) {
        aob_trend_chart(page, series);
        aob_text_add(page, "<figcaption>");
        add_now(page, series);
        add_level(page, series);
        add_rest(page, series);
        add_told(page, series);
        aob_text_add(page, "</figcaption>");
    } else
        aob_text_add(page, "<p class=missing>No night of it is left.</p>");
    aob_text_add(page, "</figure>\n");
}
