/* How long a block would be timed until a case's interval is as narrow as is wanted: the interval of estimate.h, foretold for
 * the number and length of processes that processes.h makes of the seconds. Threads: pure functions.
 *
 * Of S seconds a case a process gets a slice, in which n rounds fit, or fewer where it ends by itself at a check point
 * (timing.h); P processes fit into S. Their medians have s^2 = between^2 + w^2 with w^2 = pi/2 sigma^2 / n, as far as a few
 * processes tell sigma and `between`. So it says what half of all runs would reach. Where processes differ more than their
 * rounds do, three of them know their scatter within a factor of 3 only, and one forecast is as good as that. */
#ifndef AOB_TIMING_FORECAST_H
#define AOB_TIMING_FORECAST_H
#include <stddef.h>
#include "estimate.h"
#include "processes.h"

struct aob_forecast {
    double within,
        between; /* sd of the case's rounds about their process's level, and of the levels, as logarithms */
    double noisiest; /* the largest `within` of the block's cases: a process ends when all are narrow */
    double round_s;  /* wall time of a round, a case */
    int least;       /* processes, as in aob_processes_desc; 0: AOB_PROCESSES_LEAST */
};

/* What the rounds of a block say of one of its slots. False of fewer than two processes, or of one round each. */
bool aob_forecast_init(struct aob_forecast *forecast, const struct aob_round_list *rounds, size_t slot,
                       int least);

/* The seconds a case, spent, until the case's interval reaches `precision` (a share) to each side in a run that asks for
 * that; INFINITY where a hundred processes of 1e6 s in all do not. */
double aob_forecast_seconds(const struct aob_forecast *forecast, double precision);

/* The same of a case that has been timed as `asked` says: NAN where it is that precise, or nothing can be foretold. */
double aob_seconds_needed(const struct aob_round_list *rounds, size_t slot,
                          const struct aob_processes_desc *asked);
#endif
