/* The ratio of two costs from several processes. Rounds of one process share what that process was dealt: addresses,
 * page colours, the threads' places. So a process's own interval tells too little, and processes are what is sampled.
 * docs/decisions/0024 has the study that this rule comes from. Threads: pure functions. */
#ifndef AOB_TIMING_ESTIMATE_H
#define AOB_TIMING_ESTIMATE_H
#include <stddef.h>
#include "base/statistics.h"

/* Paired rounds of one process: milliseconds a frame, positive. */
struct aob_rounds {
    const double *cost, *fixed; /* of what is measured, and of what it is measured against */
    size_t count;               /* >= 1 */
};

/* The estimate is exp of the median of all processes' ln(cost/fixed). Its interval has the half-width, on the log scale,
 *
 *     h = sqrt(max(s^2, w^2) / P) * (z + (t - z) sqrt(1 - w^2/s^2))
 *
 * P: processes; (sum n)^2 / sum n^2 of them where they have n rounds each, since the median follows those that have
 * most. s^2: variance of the processes' medians. w^2: what rounds alone would make of it, pi/2 sigma^2 times
 * the mean of 1/rounds, with sigma = 1.4826 times the median distance of a round from its process's median. z = 1.96;
 * t: Student's, P - 1 degrees of freedom. The square root is the share of s that rounds do not explain; it counts as 0
 * where s < w. So three processes that agree as well as their rounds allow have a normal interval, and three that differ
 * a wide one.
 *
 * A single process has the sign-test interval of its rounds, which is too narrow where processes differ. `bounded` is
 * false with fewer than two processes and fewer than 6 rounds, or where no process has two rounds. */
struct aob_ratio aob_estimate_ratio(const struct aob_rounds *processes, size_t process_count);

/* What the formula is made of, as standard deviations of ln(cost/fixed). */
struct aob_scatter {
    double round;     /* sigma */
    double medians;   /* s */
    double explained; /* w */
};
/* Of two processes at least, one of which has two rounds or more; false otherwise. */
bool aob_estimate_scatter(const struct aob_rounds *processes, size_t process_count,
                          struct aob_scatter *scatter);

/* Standard deviation of the processes' levels, which more rounds do not lessen: sqrt(s^2 - w^2); 0 where rounds are all. */
double aob_scatter_between(const struct aob_scatter *scatter);

/* w for processes of `rounds` each: the standard deviation of a median of rounds that scatter by `sigma`. */
double aob_scatter_of_median(double sigma, double rounds);

/* h. `equal`: P of the root; `process_count`: that of Student's degrees of freedom, >= 2. */
double aob_scatter_half_width(const struct aob_scatter *scatter, double equal, size_t process_count);

/* Half of the interval's width, as a share of the ratio: 0.03 is 3 %. INFINITY where it is not bounded. */
double aob_estimate_half_width(const struct aob_ratio *ratio);
#endif
