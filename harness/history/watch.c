#include "watch.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/statistics.h"
#include "level.h"
#include "point.h"

/* A width beyond any shift; finite, as medians are taken of it. */
static const double unknown = 1e6;

/* The values of a line; the last one is tonight's. */
struct values {
    double *y, *weights, *halves; /* logarithms; 1 / width, bounded; half of the width as it is */
    size_t *at;                   /* places of their points */
    size_t n, start;              /* start: the first value since the restart */
    size_t judged;                /* so many values are no later than the verdict that restarted it */
};

/* k nights beside the level before them. */
struct tail {
    double before, shift, need; /* logarithms; need: what the shift must be beyond */
    bool stands_out;
};

static void values_finish(struct values *v)
{
    free(v->y);
    free(v->weights);
    free(v->halves);
    free(v->at);
}

static void weigh(struct values *v, const struct aob_point *points)
{
    double *widths = AOB_NEW_ARRAY(double, v->n);
    for (size_t i = 0; i < v->n; i++) {
        widths[i] = aob_point_width(&points[v->at[i]]);
        v->halves[i] = 0.5 * (isnan(widths[i]) ? unknown : widths[i]);
    }
    aob_point_weights(widths, v->n, v->weights);
    free(widths);
}

/* Place of the latest verdict before tonight that tells of a level; `none` if there is no such. */
static size_t decided_at(const struct aob_point *points, size_t earlier, size_t none)
{
    for (size_t i = earlier; i-- > 0;) {
        int verdict = points[i].verdict;
        bool decided = verdict == AOB_NIGHT_SLOWER || verdict == AOB_NIGHT_FASTER ||
                       verdict == AOB_NIGHT_MOVED || verdict == AOB_NIGHT_MACHINE;
        if (decided && points[i].since)
            return i;
    }
    return none;
}

/* The last point must have a value. */
static struct values values_of(const struct aob_point *points, size_t count)
{
    struct values v = {AOB_NEW_ARRAY(double, AOB_WATCH_LINE),
                       AOB_NEW_ARRAY(double, AOB_WATCH_LINE),
                       AOB_NEW_ARRAY(double, AOB_WATCH_LINE),
                       AOB_NEW_ARRAY(size_t, AOB_WATCH_LINE),
                       0,
                       0,
                       0};
    size_t decided = decided_at(points, count - 1, count), first = count;
    int64_t since = decided < count ? points[decided].since : INT64_MIN;
    for (size_t kept = 0; first > 0 && kept < AOB_WATCH_LINE;)
        kept += aob_point_is_timed(&points[--first]);
    for (size_t i = first; i < count; i++) {
        if (!aob_point_is_timed(&points[i]))
            continue;
        v.start += i + 1 < count && points[i].night < since;
        v.judged += decided < count && i <= decided;
        v.y[v.n] = log(points[i].ratio);
        v.at[v.n++] = i;
    }
    weigh(&v, points);
    return v;
}

/* Adds the distances of values [from, to) from their levels' medians. */
static size_t add_distances(const struct values *v, size_t from, size_t to, const struct aob_levels *levels,
                            double *distances, size_t count)
{
    for (size_t i = from, level = 0; i < to; i++) {
        while (level + 1 < levels->count && levels->starts[level + 1] <= i - from)
            level++;
        distances[count++] = fabs(v->y[i] - levels->values[level]);
    }
    return count;
}

/* The noise of the line, a third of what a shift must lie beyond; NAN: not known. `levels`: those from the restart to last night. */
static double noise_of(const struct values *v, const struct aob_levels *levels)
{
    size_t last = v->n - 1, count = 0;
    double *distances = AOB_NEW_ARRAY(double, v->n), noise = NAN;
    struct aob_levels old;
    aob_levels_fit(v->y, v->weights, v->start, &old);
    count = add_distances(v, 0, v->start, &old, distances, count);
    count = add_distances(v, v->start, last, levels, distances, count);
    size_t taken = old.count + levels->count;
    if (count >= taken + AOB_WATCH_KNOWN)
        noise = fmax(1.4826 * aob_median(distances, count), aob_quantile(distances, count, 0.95) / 3) *
                sqrt((double)count / (double)(count - taken));
    aob_levels_finish(&old);
    free(distances);
    return noise;
}

/* The largest distance from `before`, up or down, beyond which more than half of the weight of the last k values lies. */
static double shift_of(const struct values *v, size_t k, double before)
{
    const double *y = v->y + v->n - k, *weights = v->weights + v->n - k;
    double total = 0, shift = 0;
    for (size_t i = 0; i < k; i++)
        total += weights[i];
    for (size_t i = 0; i < k; i++) {
        double distance = y[i] - before, beyond = 0;
        for (size_t j = 0; j < k; j++)
            if (distance > 0 ? y[j] >= y[i] : y[j] <= y[i])
                beyond += weights[j];
        /* Sums of weights are not exact: within 1e-12 they are half. */
        if (beyond > total * (0.5 + 1e-12) && fabs(distance) > fabs(shift))
            shift = distance;
    }
    return shift;
}

/* Half the width of the interval of the last k values together, if they err independently. */
static double half_of(const struct values *v, size_t k)
{
    double sum = 0;
    for (size_t i = v->n - k; i < v->n; i++)
        sum += 1 / (v->halves[i] * v->halves[i]);
    return 1 / sqrt(sum);
}

/* How far a shift must lie away by what is known of errors; `m` values make the level before. */
static double error_of(const struct values *v, size_t k, size_t m, double noise)
{
    double half = half_of(v, k), widest = 0;
    double share = k == 1 ? 1 + M_PI / 2 / (double)m : M_PI / 2 * (1 / (double)k + 1 / (double)m);
    for (size_t i = v->start; i + k < v->n; i++)
        widest = fmax(widest, v->halves[i]);
    return isnan(noise) ? half + widest : fmax(half, 3 * noise * sqrt(share));
}

/* `first` begins the level before. */
static struct tail tail_of(const struct values *v, size_t first, size_t k, double noise, double least)
{
    size_t end = v->n - k, m = end - first;
    struct tail tail = {.before = aob_level_value(v->y + first, v->weights + first, m)};
    double tonight = v->y[v->n - 1] - tail.before;
    tail.shift = shift_of(v, k, tail.before);
    tail.need = fmax(log1p(least), error_of(v, k, m, noise));
    tail.stands_out = fabs(tail.shift) > tail.need && fabs(tonight - tail.shift) < fabs(tonight) &&
                      (k == 1 || (!isnan(noise) && m >= AOB_WATCH_KNOWN));
    return tail;
}

/* Where the last level begins that is older than the nights that are set beside it: a younger one is what is asked about. */
static size_t level_before(const struct values *v, const struct aob_levels *levels)
{
    size_t level = levels->count - 1;
    while (level && v->start + levels->starts[level] + AOB_WATCH_NIGHTS >= v->n)
        level--;
    return v->start + levels->starts[level];
}

/* How many of the last `most` values are of the new level, if the others lie about `before`. */
static size_t nights_since(const struct values *v, size_t most, double before)
{
    double best = INFINITY;
    size_t nights = 1;
    for (size_t k = 1; k <= most; k++) {
        size_t start = v->n - k;
        double cost = 0, after = aob_level_value(v->y + start, v->weights + start, k);
        for (size_t i = v->n - most; i < v->n; i++)
            cost += v->weights[i] * fabs(v->y[i] - (i < start ? before : after));
        if (cost < best) {
            best = cost;
            nights = k;
        }
    }
    return nights;
}

/* At least one value lies between the restart and tonight. */
static void watch_values(const struct values *v, double least, struct aob_watch *watch)
{
    size_t last = v->n - 1, most = last - v->start < AOB_WATCH_NIGHTS ? last - v->start : AOB_WATCH_NIGHTS;
    most = v->n - v->judged < most ? v->n - v->judged : most;
    struct tail tails[AOB_WATCH_NIGHTS + 1] = {{0}}, *told = tails + 1;
    struct aob_levels levels;
    aob_levels_fit(v->y + v->start, v->weights + v->start, last - v->start, &levels);
    double noise = noise_of(v, &levels), shift, beyond = 0;
    size_t first = level_before(v, &levels);
    for (size_t k = 1; k <= most; k++) {
        tails[k] = tail_of(v, first, k, noise, least);
        if (tails[k].stands_out && fabs(tails[k].shift) / tails[k].need > beyond) {
            beyond = fabs(tails[k].shift) / tails[k].need;
            told = tails + k;
        }
    }
    shift = told->shift;
    if (told->stands_out) {
        size_t nights = nights_since(v, most, told->before);
        watch->suspect = true;
        watch->since = v->at[v->n - nights];
        told = tails[nights].stands_out ? tails + nights : told;
        size_t k = (size_t)(told - tails), end = v->n - k;
        shift = aob_level_value(v->y + end, v->weights + end, k) - told->before;
    }
    watch->level = v->at[first];
    watch->before = exp(told->before);
    watch->shift = exp(shift);
    watch->least = expm1(told->need);
    aob_levels_finish(&levels);
}

void aob_watch_line(const struct aob_point *points, size_t count, double least, struct aob_watch *watch)
{
    *watch = (struct aob_watch){false, count ? count - 1 : 0, 0, NAN, NAN, NAN};
    if (count == 0 || !aob_point_is_timed(&points[count - 1]))
        return;
    struct values v = values_of(points, count);
    if (v.start + 1 < v.n)
        watch_values(&v, least, watch);
    values_finish(&v);
}

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double aob_watch_level(const double *p, size_t count, double q)
{
    double *sorted = AOB_NEW_ARRAY(double, count + 1);
    size_t tested = 0, found = 1;
    for (size_t i = 0; i < count; i++)
        if (!isnan(p[i]))
            sorted[tested++] = p[i];
    qsort(sorted, tested, sizeof *sorted, compare);
    for (size_t i = 0; i < tested; i++)
        if (sorted[i] <= q * (double)(i + 1) / (double)tested)
            found = i + 1;
    free(sorted);
    return tested ? q * (double)found / (double)tested : q;
}
