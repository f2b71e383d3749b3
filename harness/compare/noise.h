/* What a machine's noise is made of. Costs are logarithms of a ratio in each round
 * (of the fixed pass to itself, or of a case to the fixed pass), which scatter about a level in each process, and the
 * levels scatter about the truth. */
#ifndef AOB_COMPARE_NOISE_H
#define AOB_COMPARE_NOISE_H
#include <stddef.h>
#include "timing/estimate.h"

struct aob_noise {
    double within; /* sd of a round about its process' median, as 1.4826 x the median absolute deviation */
    double
        between; /* sd of the processes' levels, without what rounds bring into their medians; 0 where that is all */
    double lag;     /* correlation of a round with the next one of its process */
    double raw_lag; /* the same of the first cost alone, before the ratio is taken: what pairing removes */
    size_t processes, rounds; /* rounds: of all */
};

/* At least two processes of at least two rounds each; of fewer all sds are NAN. Only processes of eight rounds and more tell
 * a correlation; NAN where there is none, or nothing varies. */
struct aob_noise aob_noise_of(const struct aob_rounds *processes, size_t count);
#endif
