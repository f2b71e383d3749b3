/* Both sides of a block's rounds as arrays, process by process: what an estimate or its scatter is made from. */
#ifndef AOB_TIMING_SIDES_H
#define AOB_TIMING_SIDES_H
#include "estimate.h"
#include "rounds.h"

enum { AOB_SIDES_WHOLE = -1 }; /* in place of a pass */

/* Milliseconds of a frame of the slot, or of one of its passes, by one clock; NAN where that does not know the pass. */
double aob_sides_ms(const struct aob_round *round, size_t slot, int pass, enum aob_clock clock);

struct aob_sides_desc {
    size_t slot, unit; /* whose cost, and what it is measured in */
    int pass;          /* of the slot; AOB_SIDES_WHOLE: its frame */
};
struct aob_sides { /* of the rounds that have such a time by their clock; the processes that have one */
    double *cost, *fixed;
    struct aob_rounds *processes;
    size_t count; /* of processes */
};
void aob_sides_init(struct aob_sides *sides, const struct aob_round_list *rounds,
                    const struct aob_sides_desc *desc);
void aob_sides_finish(struct aob_sides *sides);
#endif
