/* Levels of a line of nightly figures: where it shifted. A line is taken to be constant between shifts, with errors that may
 * have heavy tails, so it is fitted by absolute distances: the weighted L1 Potts functional,
 *
 *     gamma J + sum of w_i |y_i - mu(i)|,
 *
 * J the number of levels and mu(i) the weighted median of the level that i lies in (Friedrich, Kempe, Liebscher and Winkler,
 * Complexity penalized M-estimation: fast computation, J. Comput. Graph. Statist. 17, 2008, with the absolute value). gamma is
 * chosen by an information criterion: of all ways to cut the line into levels the one is taken whose
 *
 *     beta J + ln(S + D),   D = sum of w_i |y_i - mu(i)|,   beta = 4 ln(n) / n,   S = AOB_LEVEL_FLOOR n
 *
 * is least. With Laplace's distribution of unknown width Schwarz' criterion has this form, with ln(n) / n for the place and
 * the value of a level (Yao, Statistics and Probability Letters 6, 1988, for normal errors); asv, which has watched benchmarks
 * so for years, takes four times that, and so does this. Since ln is concave, what is least here is also least for the
 * functional with gamma = beta (S + D) of itself. S is what D would be if the values erred by nothing but what their own
 * intervals say; without it two values would always be two levels that fit exactly.
 *
 * The result is exact, and the same on every call: the least D for each J is found by dynamic programming over the ends of
 * levels (Bellman's recursion, as in the same paper). Time and memory grow as n^2: 2000 values take half a second
 * and 16 MB. Pure functions. */
#ifndef AOB_HISTORY_LEVEL_H
#define AOB_HISTORY_LEVEL_H
#include <stddef.h>

/* The mean of w |y - mu| if w is 1 / (width of y's 95 % interval) and y errs as a normal distribution with that interval does:
 * sqrt(2/pi) sigma / (2 x 1.96 sigma). */
#define AOB_LEVEL_FLOOR 0.2

struct aob_levels {
    size_t *starts; /* place of each level's first value; starts[0] is 0 */
    double *values; /* weighted median of each level */
    size_t count;
};

/* The levels of n finite values (logarithms of ratios) in their order. A weight is 1 over the width of the value's 95 %
 * interval, finite and above 0, so values and widths in other units have the same levels. n = 0: none.
 * aob_levels_finish frees. */
void aob_levels_fit(const double *values, const double *weights, size_t n, struct aob_levels *levels);
void aob_levels_finish(struct aob_levels *levels); /* leaves it empty */

/* The weighted median of n >= 1 values: half of the weight lies to each side; the middle of the two values between which that
 * holds exactly. */
double aob_level_value(const double *values, const double *weights, size_t n);
#endif
