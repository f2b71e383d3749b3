/* What frames cost before anything of them is timed: it decides which cases share a block's rounds. */
#ifndef AOB_TIMING_PROBE_H
#define AOB_TIMING_PROBE_H
#include "timing.h"

/* Milliseconds of a frame of each case by the clock. Of the desc it takes the frames, the clock and the source. Drivers have
 * compiled the frames already. Where clocks rise under load, the frames run in turn until they have been a load for
 * AOB_PROBE_LOAD_MS, and their last turn counts: an idle device would make each of them dear. False with a line if a
 * frame fails, or a clock stands still (standing.h). */
enum { AOB_PROBE_LOAD_MS = 300 };
bool aob_probe_costs(const struct aob_timing_desc *desc, double cost_ms[AOB_BLOCK_MAX],
                     struct aob_error *error);
#endif
