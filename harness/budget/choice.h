/* Which case to take for a budget of milliseconds. Pure functions over candidates: a candidate is one case with what it
 * costs and how far it is from the truth. The caller says by which clock or model costs are, and lets only such stand
 * beside each other as answer one question: one scene, view, size, backend and target. */
#ifndef AOB_BUDGET_CHOICE_H
#define AOB_BUDGET_CHOICE_H
#include <stddef.h>

struct aob_candidate {
    size_t of;      /* the caller's number of the case; not looked at */
    size_t view;    /* which of the caller's scenes and views it is of; looked at by aob_worst_find only */
    size_t setting; /* which technique with which values; the same number in every view */
    double ms, low, high; /* of a frame, and the interval or band of it; no interval: 0 and INFINITY */
    double error;         /* less is better; 0 or more */
};

/* An interval that reaches over the budget may hide an overrun, so such a case does not count as one that fits. */
enum aob_fit {
    AOB_FIT_OVER,  /* the point lies over the budget */
    AOB_FIT_POINT, /* the point lies within it, the upper end over it */
    AOB_FIT_WHOLE, /* the upper end lies within it */
    AOB_FIT_COUNT
};
enum aob_fit aob_candidate_fit(const struct aob_candidate *candidate, double budget_ms);
const char *aob_fit_name(enum aob_fit fit); /* "over", "point", "fits" */

#define AOB_NO_CANDIDATE ((size_t)-1)

/* Places in the list; AOB_NO_CANDIDATE: there is none. Of equal errors the cheaper case is taken, of equal costs the more
 * accurate one, and of both equal the first of the list. */
struct aob_choice {
    size_t accurate; /* the most accurate of those that fit */
    size_t hopeful;  /* the most accurate of those whose point alone fits, if it is more accurate than that */
    size_t cheap;    /* the cheapest of those whose error is at most `error`, whether or not it fits */
    size_t
        least; /* the one of the lowest upper end, and of equal ones the cheapest: what is nearest to fitting */
};

/* `error` INFINITY: any error will do. */
void aob_choice_make(struct aob_choice *choice, const struct aob_candidate *list, size_t count,
                     double budget_ms, double error);

/* The Pareto set by points: what no other candidate beats in one of cost and error without losing in the other. Of equal
 * ones the first of the list. Fills `front`, which has room for `count`, with places by rising cost, and returns how
 * many. */
size_t aob_front_find(const struct aob_candidate *list, size_t count, size_t *front);

/* One candidate for each setting that answers every one of `views` views, numbered from 0: its largest cost, ends of
 * intervals and error, each over all of them. So the worst view fits if and only if the candidate does. Its `of` and `view` are
 * those of the one whose point costs most, the first of several. In the order in which the settings' numbers rise; `worst` has room
 * for `count`. Returns how many. */
size_t aob_worst_find(const struct aob_candidate *list, size_t count, size_t views,
                      struct aob_candidate *worst);
#endif
