/* Intervals of a comparison, at a stricter level than the 95 % of a record. All work on logarithms, where a cost that is halved lies as far away as one that is doubled. */
#ifndef AOB_COMPARE_QUOTIENT_H
#define AOB_COMPARE_QUOTIENT_H
#include <stddef.h>
#include "base/statistics.h"

/* The level of a table of `comparisons` cases: whatever they are, one of its intervals misses the truth with a
 * probability of AOB_COMPARE_ALPHA at most (Bonferroni). */
#define AOB_COMPARE_ALPHA 0.01
double aob_compare_alpha(size_t comparisons);

/* An interval of 95 % over `processes` at the level 1 - alpha: its ends move away from the ratio in proportion to
 * Student's quantiles with processes - 1 degrees of freedom. Unbounded for fewer than two processes. */
struct aob_ratio aob_widen(const struct aob_ratio *ratio, size_t processes, double alpha);

/* The p-value of "both cost the same": the alpha at which the interval that aob_widen makes ends at 1, two-sided. 1 where the
 * ratio is 1; NAN for what is unbounded, or fewer than two processes. */
double aob_ratio_p(const struct aob_ratio *ratio, size_t processes);

/* The half-width that an interval of 95 % would have at the level 1 - alpha, as a logarithm to its wider side, if what
 * it is made of were known from many processes: the normal quantile in place of Student's. What it owes to few processes
 * at 95 % is still in it, so it is an upper bound. INFINITY where it is not bounded. */
double aob_lasting_half_width(const struct aob_ratio *ratio, double alpha);
#endif
