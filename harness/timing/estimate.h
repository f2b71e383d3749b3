/* The ratio of a cost to the fixed pass, from the rounds of several processes. */
#ifndef AOB_TIMING_ESTIMATE_H
#define AOB_TIMING_ESTIMATE_H
#include <stddef.h>
#include "base/statistics.h"

/* One process' paired rounds: ms a frame of the case and of the fixed pass. */
struct aob_rounds {
    const double *cost, *fixed;
    size_t count;
};
struct aob_ratio aob_estimate_ratio(const struct aob_rounds *processes, size_t process_count);
#endif
