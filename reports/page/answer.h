/* What the cases of a run answer to a budget: of each scene, view, size, backend and target which case to take, and over
 * all scenes and views of one target which setting. Errors against two targets never stand beside each other. */
#ifndef AOB_REPORTS_PAGE_ANSWER_H
#define AOB_REPORTS_PAGE_ANSWER_H
#include "ask.h"
#include "budget/choice.h"
#include "rows.h"

/* Cases by what came of them. */
struct aob_answer_cases {
    size_t ok, unsupported, invalid, failed;
    size_t missing; /* planned, and not in the journal */
};

/* What all questions of one run, backend and size share: the time that there is. */
struct aob_answer_frame {
    const struct aob_row *first;
    struct aob_interval cost; /* of G-buffer and composite; at NAN: not known (aob_ask_take_frame) */
    double ms;                /* for ambient occlusion; 0 or less: nothing is left */
    size_t places;            /* scenes and views that have cases there, good or not */
};

/* One scene and view there. */
struct aob_answer_place {
    const struct aob_row *first;
    size_t frame; /* its place among the answer's */
    struct aob_answer_cases cases;
    size_t candidates; /* good cases that may be chosen, whatever is known of them */
    size_t questions;  /* answered, one a target; 0: no candidate has an error that is asked for */
};

/* One scene and view at one size on one backend, against one target. Candidates are the good cases that may be chosen.
 * Only they make a view, with or without a cost: a good `none` or `deferred` asks nothing. */
struct aob_answer_view {
    const struct aob_row *first; /* of its candidates: says scene, view, backend and size */
    size_t target;               /* its place among the rows' */
    size_t place, whole;         /* their places among the answer's */
    double ms;                   /* of its frame */
    struct aob_candidate
        *list; /* costs are those that are judged; `of` is the row's place, `view` a number in its whole */
    size_t count, capacity;
    size_t *nones; /* places of the rows of `none` there, which have an error against the target too */
    size_t none_count, none_capacity;
    size_t unknown; /* candidates whose judged cost is not known, which the list lacks */
    struct aob_choice choice;
    size_t *front; /* places in the list, by rising cost */
    size_t front_count;
};

/* All scenes and views of one size, backend and target. */
struct aob_answer_whole {
    const struct aob_row *first;
    size_t target;
    size_t frame; /* its place among the answer's */
    double ms;    /* of that */
    size_t views; /* that have candidates against the target, of the frame's places */
    struct aob_candidate
        *list; /* one a setting that all of them have; `of` is the row of the view that costs it most */
    size_t count;
    struct aob_choice choice;
};

struct aob_answer { /* zero it first */
    const struct aob_rows *rows;
    struct aob_ask ask;
    struct aob_answer_cases cases; /* of what is asked; the missing ones are those of the whole run */
    struct aob_answer_frame *frames;
    size_t frame_count, frame_capacity;
    struct aob_answer_place *places;
    size_t place_count, place_capacity;
    struct aob_answer_view *views;
    size_t view_count, view_capacity;
    struct aob_answer_whole *wholes;
    size_t whole_count, whole_capacity;
};

/* In the order of the rows, which must outlive the answer. */
void aob_answer_make(struct aob_answer *answer, const struct aob_rows *rows, const struct aob_ask *ask);
void aob_answer_finish(struct aob_answer *answer);

/* The row of `none` that a row of the view is set beside: with the same run options. NULL: the view has
 * none. */
const struct aob_row *aob_answer_none(const struct aob_answer *answer, const struct aob_answer_view *view,
                                      const struct aob_row *row);

/* Whether every view has a case that fits, and every whole a setting that does. */
bool aob_answer_fits(const struct aob_answer *answer);

/* Whether every scene and view has a good case that may be chosen. One that has none is not known to fit. */
bool aob_answer_is_known(const struct aob_answer *answer);

/* Whether all cases that are asked for are there and good. A run that does not say how many were planned may lack some. */
bool aob_answer_is_whole(const struct aob_answer *answer);
#endif
