#include "chart.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "base/memory.h"
#include "parts.h"
#include "reports/page/html.h"

#define STRIP 18.0 /* height of a strip below the ratios */

/* With one decimal at most: 12.0 is "12", and nothing is "-0". */
static void add_place(struct aob_text *page, const char *before, double place)
{
    long tenths = lround(place * 10);
    aob_text_add(page, tenths % 10 ? "%s%s%ld.%ld" : "%s%s%ld", before, tenths < 0 ? "-" : "",
                 labs(tenths) / 10, labs(tenths) % 10);
}

static bool is_beyond(const struct aob_trend_axis *axis, double ratio)
{
    return ratio < axis->low || ratio > axis->high;
}

static void widen(struct aob_trend_axis *axis, double ratio, const struct aob_trend_axis *bounds)
{
    if (!isfinite(ratio) || is_beyond(bounds, ratio))
        return;
    axis->low = fmin(axis->low, ratio);
    axis->high = fmax(axis->high, ratio);
}

struct aob_trend_axis aob_trend_axis(const struct aob_trend_series *series)
{
    struct aob_trend_axis axis = {INFINITY, -INFINITY}, all = {-INFINITY, INFINITY};
    if (!series->levels.count)
        return (struct aob_trend_axis){0, 1};
    for (size_t k = 0; k < series->levels.count; k++)
        widen(&axis, series->levels.values[k], &all);
    const struct aob_trend_axis bounds = {axis.low / 1.5, axis.high * 1.5};
    for (size_t i = 0; i < series->count; i++) {
        const struct aob_point *point = series->dots[i].point;
        if (series->dots[i].level == SIZE_MAX)
            continue;
        widen(&axis, point->ratio, &bounds);
        widen(&axis, point->low, &bounds);
        widen(&axis, point->high, &bounds);
    }
    double middle = (axis.low + axis.high) / 2;
    double half = fmax((axis.high - axis.low) * .55, middle * .01);
    return (struct aob_trend_axis){middle - half, middle + half};
}

double aob_trend_x(const struct aob_trend_calendar *calendar, size_t night)
{
    double first = calendar->days[0], span = calendar->days[calendar->count - 1] - first;
    double share = span > 0 ? (calendar->days[night] - first) / span : .5;
    return AOB_TREND_LEFT + 6 + (AOB_TREND_RIGHT - AOB_TREND_LEFT - 12) * fmin(fmax(share, 0), 1);
}

/* A stretch of the chart's height with what it spans. */
struct band {
    double top, bottom;
    struct aob_trend_axis axis;
};

static double place_in(const struct band *band, double value)
{
    double span = band->axis.high - band->axis.low;
    double share = span > 0 ? (value - band->axis.low) / span : .5;
    return band->bottom - (band->bottom - band->top) * fmin(fmax(share, 0), 1);
}

double aob_trend_y(const struct aob_trend_axis *axis, double ratio)
{
    return place_in(&(struct band){AOB_TREND_TOP, AOB_TREND_BOTTOM, *axis}, ratio);
}

size_t aob_trend_beyond(const struct aob_trend_series *series)
{
    struct aob_trend_axis axis = aob_trend_axis(series);
    size_t count = 0;
    for (size_t i = 0; i < series->count; i++)
        count += series->dots[i].level != SIZE_MAX && is_beyond(&axis, series->dots[i].point->ratio);
    return count;
}

/* The chart while it is drawn. */
struct chart {
    const struct aob_trend_series *series;
    struct aob_trend_axis axis;
    struct aob_text *page;
    double reach; /* how far a line goes beside the first and last night of a stretch */
};

static double x_of(const struct chart *chart, size_t dot)
{
    return aob_trend_x(chart->series->calendar, chart->series->dots[dot].night);
}

/* A path is written only where something is in it. */
static void add_path(struct chart *chart, const char *class_name, struct aob_text *d)
{
    if (d->size)
        aob_text_add(chart->page, "<path class=%s d=\"%s\"/>", class_name, d->data);
    aob_text_finish(d);
}

static void add_grid(struct chart *chart)
{
    static const double steps[] = {1, 2, 5, 10};
    double span = chart->axis.high - chart->axis.low, unit = pow(10, floor(log10(span / 4))), step = unit;
    struct aob_text grid = {0};
    for (size_t i = 0; i < AOB_COUNT(steps) && step < span / 4; i++)
        step = unit * steps[i];
    int decimals = (int)fmax(0, ceil(-log10(step) - 1e-9));
    for (double at = ceil(chart->axis.low / step) * step; at <= chart->axis.high; at += step) {
        double y = aob_trend_y(&chart->axis, at);
        add_place(&grid, "M50 ", y);
        aob_text_add(&grid, "H350");
        add_place(chart->page, "<text x=45 y=", y + 3.5);
        aob_text_add(chart->page, ">%.*f</text>", decimals, at);
    }
    add_path(chart, "g", &grid);
}

/* Intervals as bars, ratios as dots, which are lines of no length with round ends; arrows for those beyond the axis. */
static void add_dots(struct chart *chart)
{
    struct aob_text bars = {0}, dots = {0}, arrows = {0};
    for (size_t i = 0; i < chart->series->count; i++) {
        const struct aob_point *point = chart->series->dots[i].point;
        if (chart->series->dots[i].level == SIZE_MAX)
            continue;
        double x = x_of(chart, i), y = aob_trend_y(&chart->axis, point->ratio);
        if (isfinite(point->low) && isfinite(point->high)) {
            add_place(&bars, "M", x);
            add_place(&bars, " ", aob_trend_y(&chart->axis, point->low));
            add_place(&bars, "V", aob_trend_y(&chart->axis, point->high));
        }
        bool beyond = is_beyond(&chart->axis, point->ratio);
        struct aob_text *path = beyond ? &arrows : &dots;
        add_place(path, "M", x);
        add_place(path, " ", y);
        aob_text_add(path, !beyond ? "h0" : point->ratio > chart->axis.high ? "l-3 6h6z" : "l-3-6h6z");
    }
    add_path(chart, "i", &bars);
    add_path(chart, "d", &dots);
    add_path(chart, "a", &arrows);
}

/* Whether the line of the dot before goes on to this one: no night between them is missing. */
static bool goes_on(const struct aob_trend_series *series, size_t dot)
{
    return dot > 0 && series->dots[dot].night == series->dots[dot - 1].night + 1;
}

typedef double value_of_dot(const struct aob_trend_series *series, size_t dot);

/* A step line of the dots' values, which changes half way between two nights; it breaks where there is no value, and where a
 * night is missing. */
static void add_steps(struct chart *chart, value_of_dot *value_of, const struct band *band,
                      const char *class_name)
{
    const struct aob_trend_series *series = chart->series;
    struct aob_text line = {0};
    double last = NAN;
    for (size_t i = 0; i <= series->count; i++) {
        double value = i < series->count ? value_of(series, i) : NAN;
        bool on = isfinite(last) && isfinite(value) && goes_on(series, i);
        if (on && value != last)
            add_place(&line, "H", (x_of(chart, i - 1) + x_of(chart, i)) / 2);
        else if (isfinite(last) && !on)
            add_place(&line, "H", x_of(chart, i - 1) + chart->reach);
        if (isfinite(value) && !on) {
            add_place(&line, "M", x_of(chart, i) - chart->reach);
            add_place(&line, " ", place_in(band, value));
        } else if (on && value != last)
            add_place(&line, "V", place_in(band, value));
        last = value;
    }
    add_path(chart, class_name, &line);
}

static double level_of(const struct aob_trend_series *series, size_t dot)
{
    size_t level = series->dots[dot].level;
    return level == SIZE_MAX ? NAN : series->levels.values[level];
}

static double error_of(const struct aob_trend_series *series, size_t dot)
{
    return series->dots[dot].point->band_rmse;
}

static double memory_of(const struct aob_trend_series *series, size_t dot)
{
    return series->dots[dot].point->memory_bytes;
}

/* The name of a strip at its left; `row`: how many strips are above it. */
static void add_name(struct chart *chart, size_t row, const char *name)
{
    aob_text_add(chart->page, "<text x=45 y=%.0f>%s</text>", AOB_TREND_BOTTOM + STRIP * (double)row + 18,
                 name);
}

/* A strip of its own axis, from the least to the greatest value; nothing, and false, where no dot has a value. */
static bool add_strip(struct chart *chart, size_t row, value_of_dot *value_of, const char *name)
{
    double top = AOB_TREND_BOTTOM + STRIP * (double)row + 9;
    struct band band = {top, top + STRIP - 7, {INFINITY, -INFINITY}};
    for (size_t i = 0; i < chart->series->count; i++) {
        double value = value_of(chart->series, i);
        if (isfinite(value))
            band.axis = (struct aob_trend_axis){fmin(band.axis.low, value), fmax(band.axis.high, value)};
    }
    if (band.axis.low > band.axis.high)
        return false;
    add_name(chart, row, name);
    add_steps(chart, value_of, &band, "s");
    return true;
}

/* Whether a dot has another image than the latest one before it that has one. */
static bool is_other_image(const struct aob_trend_series *series, size_t dot)
{
    const char *image = series->dots[dot].point->image;
    for (size_t i = dot; *image && i-- > 0;)
        if (*series->dots[i].point->image)
            return strcmp(series->dots[i].point->image, image) != 0;
    return false;
}

size_t aob_trend_images(const struct aob_trend_series *series, size_t *latest)
{
    size_t count = 0;
    for (size_t i = 0; i < series->count; i++)
        if (is_other_image(series, i)) {
            *latest = i;
            count++;
        }
    return count;
}

/* A tick for each image that is another than the one before. */
static bool add_images(struct chart *chart, size_t row)
{
    struct aob_text ticks = {0};
    bool known = false;
    for (size_t i = 0; i < chart->series->count; i++) {
        known = known || *chart->series->dots[i].point->image;
        if (!is_other_image(chart->series, i))
            continue;
        add_place(&ticks, "M", x_of(chart, i));
        add_place(&ticks, " ", AOB_TREND_BOTTOM + STRIP * (double)row + 9);
        aob_text_add(&ticks, "v11");
    }
    if (known)
        add_name(chart, row, "image");
    add_path(chart, "c", &ticks);
    return known;
}

static void add_marks(struct chart *chart)
{
    const struct aob_trend_series *series = chart->series;
    for (size_t i = 0; i < series->count; i++) {
        const struct aob_point *point = series->dots[i].point;
        const struct aob_trend_word *word = aob_trend_word(point->verdict);
        char day[11];
        if (!*word->mark)
            continue;
        aob_trend_day(day, aob_trend_dot_date(series, i));
        aob_text_add(chart->page, "<g class=\"m %s\"><title>", word->mark);
        aob_trend_escaped(chart->page, "", day, ": ");
        aob_trend_escaped(chart->page, word->word, point->said && *point->said ? ". " : "", "");
        aob_trend_escaped(chart->page, "", point->said, "</title>");
        aob_text_add(chart->page, "<use href=#m-%s", word->mark);
        add_place(chart->page, " x=", x_of(chart, i));
        double y =
            series->dots[i].level == SIZE_MAX ? AOB_TREND_BOTTOM : aob_trend_y(&chart->axis, point->ratio);
        add_place(chart->page, " y=", y);
        aob_text_add(chart->page, " /></g>");
    }
}

/* The first and the last night's date below the chart. */
static void add_days(struct chart *chart, double y)
{
    const struct aob_trend_calendar *calendar = chart->series->calendar;
    char day[11];
    aob_trend_day(day, calendar->nights[0]->date);
    aob_text_add(chart->page, "<text x=%s y=%.0f class=%s>", calendar->count > 1 ? "50" : "200", y,
                 calendar->count > 1 ? "l" : "o");
    aob_trend_escaped(chart->page, "", day, "</text>");
    if (calendar->count < 2)
        return;
    aob_trend_day(day, calendar->nights[calendar->count - 1]->date);
    aob_text_add(chart->page, "<text x=350 y=%.0f>", y);
    aob_trend_escaped(chart->page, "", day, "</text>");
}

void aob_trend_ticks(struct aob_text *page, const struct aob_trend_calendar *calendar)
{
    aob_text_add(page, "<svg width=0 height=0 class=marks aria-hidden=true><defs><path id=t%zu d=\"",
                 calendar->index);
    for (size_t i = 0; i < calendar->count; i++) {
        add_place(page, "M", aob_trend_x(calendar, i));
        aob_text_add(page, " 108v4");
    }
    aob_text_add(page, "\"/></defs></svg>\n");
}

static void add_ratios(struct chart *chart)
{
    const struct band ratios = {AOB_TREND_TOP, AOB_TREND_BOTTOM, chart->axis};
    aob_text_add(chart->page, "<path class=f d=\"M50 8V108H350\"/><use href=#t%zu class=f />",
                 chart->series->calendar->index);
    if (!chart->series->levels.count) {
        aob_text_add(chart->page, "<text x=200 y=60 class=o>no ratio in any night</text>");
        return;
    }
    add_grid(chart);
    add_steps(chart, level_of, &ratios, "v");
    add_dots(chart);
}

void aob_trend_chart(struct aob_text *page, const struct aob_trend_series *series)
{
    struct aob_text body = {0};
    double share = (AOB_TREND_RIGHT - AOB_TREND_LEFT) / 2 / (double)(series->calendar->count + 1);
    struct chart chart = {series, aob_trend_axis(series), &body, fmin(fmax(share, 1), 6)};
    size_t rows = 0;
    add_ratios(&chart);
    rows += add_strip(&chart, rows, error_of, "error");
    rows += add_strip(&chart, rows, memory_of, "memory");
    rows += add_images(&chart, rows);
    add_marks(&chart);
    double height = AOB_TREND_BOTTOM + STRIP * (double)rows + 22;
    add_days(&chart, height - 4);
    aob_text_add(
        page,
        "<svg class=t viewBox=\"0 0 360 %.0f\" role=img aria-label=\"ratio to the fixed pass by night\">",
        height);
    aob_text_add_bytes(page, body.data, body.size);
    aob_text_add(page, "</svg>");
    aob_text_finish(&body);
}
