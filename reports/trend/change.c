#include "change.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "fit.h"

/* Which of two verdicts on one change stands: what was decided before what was not. 0: it tells of none. */
static int rank_of(int64_t verdict)
{
    static const int ranks[AOB_NIGHT_VERDICTS] = {
        [AOB_NIGHT_SLOWER] = 3, [AOB_NIGHT_FASTER] = 3, [AOB_NIGHT_MACHINE] = 2, [AOB_NIGHT_OPEN] = 1,
        [AOB_NIGHT_MOVED] = 1,  [AOB_NIGHT_BROKEN] = 1, [AOB_NIGHT_CHANGED] = 1,
    };
    return verdict >= 0 && verdict < AOB_NIGHT_VERDICTS ? ranks[verdict] : 0;
}

static double level_before(const struct aob_trend_series *series, size_t dot)
{
    while (dot-- > 0)
        if (series->dots[dot].level != SIZE_MAX)
            return series->levels.values[series->dots[dot].level];
    return NAN;
}

static void tell(struct aob_trend_change *change, size_t told)
{
    int64_t verdict = change->series->dots[told].point->verdict;
    if (change->told != SIZE_MAX && rank_of(verdict) < rank_of((int64_t)change->verdict))
        return;
    change->told = told;
    change->verdict = (enum aob_night_verdict)verdict;
}

/* The series' change of cost that began nearest to that dot; NULL: none began near it so far. */
static struct aob_trend_change *find_change(struct aob_trend_changes *changes, size_t first, size_t since)
{
    struct aob_trend_change *found = NULL;
    size_t least = AOB_TREND_NEAR + 1;
    for (size_t i = first; i < changes->count; i++) {
        struct aob_trend_change *change = &changes->items[i];
        size_t off = change->since > since ? change->since - since : since - change->since;
        if (off >= least || !isfinite(change->before))
            continue;
        found = change;
        least = off;
    }
    return found;
}

static bool is_of_cost(int64_t verdict)
{
    return verdict == AOB_NIGHT_OPEN || rank_of(verdict) > rank_of(AOB_NIGHT_OPEN);
}

/* The change that the verdict on a dot tells of; NULL: none that is known. Another image is what a border of that very night is
 * about, unless that was judged. */
static struct aob_trend_change *find_told(struct aob_trend_changes *changes, size_t first, size_t since,
                                          int64_t verdict)
{
    struct aob_trend_change *found = find_change(changes, first, since);
    if (is_of_cost(verdict) || !found)
        return found;
    return verdict == AOB_NIGHT_MOVED && found->since == since && found->told == SIZE_MAX ? found : NULL;
}

/* A verdict on the cost is a change of its own where no level shows it; any other is one in any case. */
static void add_told(struct aob_trend_changes *changes, const struct aob_trend_series *series, size_t first,
                     size_t told)
{
    const struct aob_point *point = series->dots[told].point;
    bool of_cost = is_of_cost(point->verdict);
    size_t since = of_cost ? aob_trend_since(series, told) : told;
    if (!rank_of(point->verdict))
        return;
    struct aob_trend_change *change = find_told(changes, first, since, point->verdict);
    if (!change) {
        change = AOB_PUSH(changes->items, changes->count, changes->capacity);
        *change = (struct aob_trend_change){series, since, SIZE_MAX, AOB_NIGHT_NONE, NAN, NAN};
        if (of_cost) {
            change->before = level_before(series, since);
            change->after = point->ratio;
        }
    }
    tell(change, told);
}

static void find_in(struct aob_trend_changes *changes, const struct aob_trend_series *series)
{
    const struct aob_levels *levels = &series->levels;
    size_t first = changes->count;
    for (size_t k = 1; k < levels->count; k++)
        *AOB_PUSH(changes->items, changes->count, changes->capacity) = (struct aob_trend_change){
            series, levels->starts[k], SIZE_MAX, AOB_NIGHT_NONE, levels->values[k - 1], levels->values[k]};
    for (size_t i = 0; i < series->count; i++)
        add_told(changes, series, first, i);
}

static double day_of(const struct aob_trend_change *change)
{
    return floor(change->series->calendar->days[change->series->dots[change->since].night]);
}

static double size_of(const struct aob_trend_change *change)
{
    double size = fabs(log(change->after / change->before));
    return change->verdict == AOB_NIGHT_BROKEN ? INFINITY : isfinite(size) ? size : -1;
}

static int greater_first(double a, double b)
{
    return (a < b) - (a > b);
}

static int compare(const void *a, const void *b)
{
    const struct aob_trend_change *p = a, *q = b;
    int order = greater_first(day_of(p), day_of(q));
    if (!order)
        order = greater_first(size_of(p), size_of(q));
    if (!order)
        order = (p->series > q->series) - (p->series < q->series);
    return order ? order : (p->since > q->since) - (p->since < q->since);
}

void aob_trend_changes_find(const struct aob_trend_model *model, struct aob_trend_changes *changes)
{
    for (size_t i = 0; i < model->count; i++)
        find_in(changes, &model->series[i]);
    if (changes->count)
        qsort(changes->items, changes->count, sizeof *changes->items, compare);
}
