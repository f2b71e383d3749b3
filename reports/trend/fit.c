#include "fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "history/point.h"

static bool is_fitted(const struct aob_point *point)
{
    return aob_point_is_timed(point) && point->verdict != AOB_NIGHT_OUTLIER;
}

static bool is_decided(int64_t verdict)
{
    return verdict == AOB_NIGHT_SLOWER || verdict == AOB_NIGHT_FASTER || verdict == AOB_NIGHT_MACHINE;
}

size_t aob_trend_since(const struct aob_trend_series *series, size_t dot)
{
    size_t night = aob_trend_calendar_place(series->calendar, series->dots[dot].point->since);
    for (size_t i = 0; night != SIZE_MAX && i < dot; i++)
        if (series->dots[i].night >= night)
            return i;
    return dot;
}

/* A stretch of dots while it is fitted. */
struct stretch {
    double *values, *weights; /* logarithms of ratios; 1 / width */
    size_t *places, n;        /* of their dots */
};

static void append_levels(struct aob_levels *all, const struct aob_levels *some, const size_t *places)
{
    size_t count = all->count + some->count;
    all->starts = aob_realloc(all->starts, count, sizeof *all->starts);
    all->values = aob_realloc(all->values, count, sizeof *all->values);
    for (size_t k = 0; k < some->count; k++) {
        all->starts[all->count + k] = places[some->starts[k]];
        all->values[all->count + k] = exp(some->values[k]);
    }
    all->count = count;
}

static void fit_stretch(struct aob_trend_series *series, struct stretch *stretch)
{
    struct aob_levels levels;
    if (!stretch->n)
        return;
    aob_levels_fit(stretch->values, stretch->weights, stretch->n, &levels);
    append_levels(&series->levels, &levels, stretch->places);
    aob_levels_finish(&levels);
    stretch->n = 0;
}

/* Of each dot of the series, so that a stretch weighs its dots as the whole does; free() it. */
static double *weights_of(const struct aob_trend_series *series)
{
    double *widths = AOB_NEW_ARRAY(double, series->count), *weights = AOB_NEW_ARRAY(double, series->count);
    for (size_t i = 0; i < series->count; i++)
        widths[i] = aob_point_width(series->dots[i].point);
    aob_point_weights(widths, series->count, weights);
    free(widths);
    return weights;
}

static void add_dot(struct stretch *stretch, const struct aob_trend_series *series, size_t dot, double weight)
{
    stretch->values[stretch->n] = log(series->dots[dot].point->ratio);
    stretch->weights[stretch->n] = weight;
    stretch->places[stretch->n++] = dot;
}

static void place_dots(struct aob_trend_series *series)
{
    const struct aob_levels *levels = &series->levels;
    for (size_t i = 0, k = 0; levels->count && i < series->count; i++) {
        while (k + 1 < levels->count && levels->starts[k + 1] <= i)
            k++;
        if (aob_point_is_timed(series->dots[i].point))
            series->dots[i].level = k;
    }
}

/* Fits anew; a level begins at each dot that `begins`. */
static void fit_between(struct aob_trend_series *series, const bool *begins)
{
    struct stretch stretch = {AOB_NEW_ARRAY(double, series->count), AOB_NEW_ARRAY(double, series->count),
                              AOB_NEW_ARRAY(size_t, series->count), 0};
    double *weights = weights_of(series);
    aob_levels_finish(&series->levels);
    for (size_t i = 0; i < series->count; i++) {
        if (begins[i])
            fit_stretch(series, &stretch);
        if (is_fitted(series->dots[i].point))
            add_dot(&stretch, series, i, weights[i]);
    }
    fit_stretch(series, &stretch);
    free(weights);
    free(stretch.values);
    free(stretch.weights);
    free(stretch.places);
}

static bool is_near_border(const struct aob_levels *levels, size_t dot)
{
    for (size_t k = 1; k < levels->count; k++)
        if (levels->starts[k] <= dot + AOB_TREND_NEAR && dot <= levels->starts[k] + AOB_TREND_NEAR)
            return true;
    return false;
}

void aob_trend_fit(struct aob_trend_series *series)
{
    bool *begins = AOB_NEW_ARRAY(bool, series->count), any = false;
    fit_between(series, begins);
    for (size_t i = 0; i < series->count; i++) {
        const struct aob_point *point = series->dots[i].point;
        size_t since = aob_trend_since(series, i);
        if (!is_decided(point->verdict) || !point->since || is_near_border(&series->levels, since))
            continue;
        begins[since] = any = true;
    }
    if (any)
        fit_between(series, begins);
    place_dots(series);
    free(begins);
}
