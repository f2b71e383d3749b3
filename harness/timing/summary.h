/* What the rounds of a block's processes say of one slot: the figures of a record. The same rounds give the same figures,
 * whether they were just measured or read from a file. */
#ifndef AOB_TIMING_SUMMARY_H
#define AOB_TIMING_SUMMARY_H
#include "base/statistics.h"
#include "rounds.h"

/* Milliseconds a frame: the median over all rounds, but over clean ones (aob_slot_is_clean) by the wall clock, which a
 * busy machine stretches. NAN where there is no such round or the device has no such clock. */
struct aob_times {
    double ms[AOB_CLOCK_COUNT];
};
struct aob_summary {
    struct aob_times whole, passes[AOB_MAX_PASS];
    struct aob_ratio to_fixed, pass_to_fixed[AOB_MAX_PASS]; /* by the rounds' clock (estimate.h) */
    size_t pass_count;
    size_t rounds, clean_rounds;
    int processes;
    int frames; /* a slot, in the first process */
};
/* `rounds` holds at least one. */
void aob_summarise(const struct aob_round_list *rounds, size_t slot, struct aob_summary *summary);

/* The slot's cost in fixed passes, over the processes of the list (estimate.h). */
struct aob_ratio aob_rounds_ratio(const struct aob_round_list *rounds, size_t slot);

/* The cost of a slot in units of another one, taken in each round, over all processes. */
struct aob_ratio aob_rounds_quotient(const struct aob_round_list *rounds, size_t slot, size_t unit);
#endif
