#include "choice.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include "base/memory.h"

enum aob_fit aob_candidate_fit(const struct aob_candidate *candidate, double budget_ms)
{
    if (!(candidate->ms <= budget_ms))
        return AOB_FIT_OVER;
    return candidate->high <= budget_ms ? AOB_FIT_WHOLE : AOB_FIT_POINT;
}

const char *aob_fit_name(enum aob_fit fit)
{
    static const char *const names[AOB_FIT_COUNT] = {"over", "point", "fits"};
    return names[fit];
}

static bool is_more_accurate(const struct aob_candidate *a, const struct aob_candidate *b)
{
    return a->error != b->error ? a->error < b->error : a->ms < b->ms;
}

static bool is_cheaper(const struct aob_candidate *a, const struct aob_candidate *b)
{
    return a->ms != b->ms ? a->ms < b->ms : a->error < b->error;
}

/* By the end that decides whether a case fits. */
static bool is_nearer(const struct aob_candidate *a, const struct aob_candidate *b)
{
    return a->high != b->high ? a->high < b->high : is_cheaper(a, b);
}

/* The place of the better one of the best so far and the next of the list. */
static size_t better(const struct aob_candidate *list, size_t best, size_t next,
                     bool (*is_better)(const struct aob_candidate *, const struct aob_candidate *))
{
    return best == AOB_NO_CANDIDATE || is_better(&list[next], &list[best]) ? next : best;
}

void aob_choice_make(struct aob_choice *choice, const struct aob_candidate *list, size_t count,
                     double budget_ms, double error)
{
    *choice = (struct aob_choice){AOB_NO_CANDIDATE, AOB_NO_CANDIDATE, AOB_NO_CANDIDATE, AOB_NO_CANDIDATE};
    for (size_t i = 0; i < count; i++) {
        enum aob_fit fit = aob_candidate_fit(&list[i], budget_ms);
        if (fit == AOB_FIT_WHOLE)
            choice->accurate = better(list, choice->accurate, i, is_more_accurate);
        if (fit == AOB_FIT_POINT)
            choice->hopeful = better(list, choice->hopeful, i, is_more_accurate);
        if (list[i].error <= error)
            choice->cheap = better(list, choice->cheap, i, is_cheaper);
        choice->least = better(list, choice->least, i, is_nearer);
    }
    bool settled = choice->hopeful != AOB_NO_CANDIDATE && choice->accurate != AOB_NO_CANDIDATE &&
                   list[choice->accurate].error <= list[choice->hopeful].error;
    if (settled)
        choice->hopeful = AOB_NO_CANDIDATE;
}

/* A candidate with its place, since qsort moves equal ones. */
struct placed {
    const struct aob_candidate *candidate;
    size_t place;
};

static int by_place(const struct placed *a, const struct placed *b)
{
    return (a->place > b->place) - (a->place < b->place);
}

static int by_cost(const void *a, const void *b)
{
    const struct placed *p = a, *q = b;
    if (is_cheaper(p->candidate, q->candidate))
        return -1;
    return is_cheaper(q->candidate, p->candidate) ? 1 : by_place(p, q);
}

static int by_setting(const void *a, const void *b)
{
    const struct placed *p = a, *q = b;
    if (p->candidate->setting != q->candidate->setting)
        return p->candidate->setting < q->candidate->setting ? -1 : 1;
    if (p->candidate->view != q->candidate->view)
        return p->candidate->view < q->candidate->view ? -1 : 1;
    return by_place(p, q);
}

/* free() it. */
static struct placed *sorted(const struct aob_candidate *list, size_t count,
                             int (*compare)(const void *, const void *))
{
    struct placed *order = AOB_NEW_ARRAY(struct placed, count + 1);
    for (size_t i = 0; i < count; i++)
        order[i] = (struct placed){&list[i], i};
    qsort(order, count, sizeof *order, compare);
    return order;
}

size_t aob_front_find(const struct aob_candidate *list, size_t count, size_t *front)
{
    struct placed *order = sorted(list, count, by_cost);
    double best = INFINITY;
    size_t used = 0;
    for (size_t i = 0; i < count; i++) {
        if (order[i].candidate->error >= best)
            continue;
        best = order[i].candidate->error;
        front[used++] = order[i].place;
    }
    free(order);
    return used;
}

static void take_worse(struct aob_candidate *worst, const struct aob_candidate *next)
{
    if (next->ms > worst->ms) {
        worst->ms = next->ms;
        worst->view = next->view;
        worst->of = next->of;
    }
    worst->low = fmax(worst->low, next->low);
    worst->high = fmax(worst->high, next->high);
    worst->error = fmax(worst->error, next->error);
}

size_t aob_worst_find(const struct aob_candidate *list, size_t count, size_t views,
                      struct aob_candidate *worst)
{
    struct placed *order = sorted(list, count, by_setting);
    size_t used = 0;
    for (size_t i = 0; i < count;) {
        const struct aob_candidate *first = order[i].candidate;
        struct aob_candidate whole = *first;
        size_t seen = 1;
        for (i++; i < count && order[i].candidate->setting == first->setting; i++) {
            seen += order[i].candidate->view != order[i - 1].candidate->view;
            take_worse(&whole, order[i].candidate);
        }
        if (seen == views)
            worst[used++] = whole;
    }
    free(order);
    return used;
}
