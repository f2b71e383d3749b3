/* Statistics of paired times. All arrays are left alone; n >= 1. */
#ifndef AOB_BASE_STATISTICS_H
#define AOB_BASE_STATISTICS_H
#include <stdbool.h>
#include <stddef.h>

double aob_median(const double *x, size_t n);

/* The q-quantile (0..1), linear between order statistics. */
double aob_quantile(const double *x, size_t n, double q);

/* Exact sign-test interval of the median, at least 95 %: [x_(k), x_(n+1-k)] with the largest k for which
 * P(Bin(n, 1/2) < k) <= 2.5 %. False (and the whole range) for n < 6, where no such interval exists. */
bool aob_median_interval(const double *x, size_t n, double *low, double *high);

/* Ratio of two costs from paired rounds: exp of the median of ln(a_i/b_i), with the interval above carried
 * through. The pairing removes what both sides of a round share (drift, load). */
struct aob_ratio {
    double ratio, low, high;
    bool bounded; /* low and high are a 95 % interval */
};
struct aob_ratio aob_paired_ratio(const double *a, const double *b, size_t n);
#endif
