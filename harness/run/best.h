/* The best cases against a budget while a run goes on: of each scene, view, size, backend and target the most accurate one
 * so far that fits, beside the G-buffer and composite that are known so far. */
#ifndef AOB_RUN_BEST_H
#define AOB_RUN_BEST_H
#include <jansson.h>
#include "base/table.h"
#include "base/text.h"
#include "budget/budget.h"

enum { AOB_BEST_SHOWN = 3 };

struct aob_best {
    struct aob_ask *ask;                /* NULL: there is no budget, and nothing is kept */
    struct aob_table frames_by, places; /* of the frames and the entries */
    struct aob_best_frame *frames;
    struct aob_best_entry *entries; /* private, like the others above */
    size_t frame_count, frame_capacity, count, capacity;
    char **cases; /* what they are called, whose numbers candidates have */
    size_t case_count, case_capacity;
    /* What fits the last case's scene and view best so far, a line for each of its first targets; the others are empty. */
    struct aob_text lines[AOB_BEST_SHOWN];
};

/* The budget must outlive it; a zeroed one is none. */
void aob_best_init(struct aob_best *best, const struct aob_budget *budget);
void aob_best_finish(struct aob_best *best); /* of a zeroed one too */

/* `what` is the case as a plan prints it. */
void aob_best_take(struct aob_best *best, const json_t *record, const char *what);
#endif
