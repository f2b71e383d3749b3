/* What the cases of a run answer to a budget: of each scene, view, size, backend and target which case to take, and over
 * all scenes and views of one target which setting. Errors against two targets never stand beside each other. */
#ifndef AOB_REPORTS_PAGE_ANSWER_H
#define AOB_REPORTS_PAGE_ANSWER_H
#include "budget/budget.h"
#include "budget/choice.h"
#include "costs.h"
#include "rows.h"

struct aob_ask {
    double ms;           /* for ambient occlusion */
    double error;        /* that will do; INFINITY: any */
    const char *profile; /* that modelled times are judged on; NULL: times measured here are judged */
    const char *scene;   /* NULL: all */
    double radius;       /* of the targets, scene units; NAN: all */
    int width, height;   /* 0: all */
};

/* What a budget asks of all scenes and targets; its texts belong to the budget. */
struct aob_ask aob_ask_of(const struct aob_budget *budget);

/* The dearest G-buffer and composite that the rows have of what is asked: its point and ends are the largest of all cases of
 * the module `deferred`. Not known: none was measured or modelled. */
struct aob_interval aob_ask_frame(const struct aob_ask *ask, const struct aob_rows *rows);

/* Takes that off what the budget's frame leaves: by the upper end, or the point where there is no interval. */
void aob_ask_take_frame(struct aob_ask *ask, const struct aob_budget *budget,
                        const struct aob_interval *frame);

/* Of a record: whether its case is good and of the scene and size that are asked for; whether it may be chosen, which
 * `none` (the floor of a cost) and `deferred` (G-buffer and composite) may not; and the cost that is judged. */
bool aob_ask_has(const struct aob_ask *ask, const json_t *record);
bool aob_ask_may_choose(const json_t *record);
struct aob_interval aob_ask_cost(const struct aob_ask *ask, const json_t *record);

/* One scene and view at one size on one backend, against one target. Candidates are the good cases that may be chosen. */
struct aob_answer_view {
    const struct aob_row *first; /* of its rows: says scene, view, backend and size */
    size_t target;               /* its place among the rows' */
    size_t whole;                /* its place among the answer's wholes */
    struct aob_candidate
        *list; /* costs are those that are judged; `of` is the row's place, `view` a number in its whole */
    size_t count, capacity;
    size_t *nones; /* places of the rows of `none` there */
    size_t none_count, none_capacity;
    size_t unknown; /* cases whose judged cost is not known */
    struct aob_choice choice;
    size_t *front; /* places in the list, by rising cost */
    size_t front_count;
};

/* All scenes and views of one size, backend and target. */
struct aob_answer_whole {
    const struct aob_row *first;
    size_t target;
    size_t views; /* that it has */
    struct aob_candidate
        *list; /* one a setting that all of them have; `of` is the row of the view that costs it most */
    size_t count;
    struct aob_choice choice;
};

struct aob_answer { /* zero it first */
    const struct aob_rows *rows;
    struct aob_ask ask;
    struct aob_answer_view *views;
    size_t view_count, view_capacity;
    struct aob_answer_whole *wholes;
    size_t whole_count, whole_capacity;
};

/* In the order of the rows, which must outlive the answer. */
void aob_answer_make(struct aob_answer *answer, const struct aob_rows *rows, const struct aob_ask *ask);
void aob_answer_finish(struct aob_answer *answer);

/* The row of `none` that a row of the view is set beside: with the same run options if there is one, else the first. NULL:
 * the view has none. */
const struct aob_row *aob_answer_none(const struct aob_answer *answer, const struct aob_answer_view *view,
                                      const struct aob_row *row);

/* Whether every view has a case that fits, and every whole a setting that does. */
bool aob_answer_fits(const struct aob_answer *answer);
#endif
