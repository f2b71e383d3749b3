/* Statistics of paired times. No function changes its arrays; n >= 1. */
#ifndef AOB_BASE_STATISTICS_H
#define AOB_BASE_STATISTICS_H
#include <stdbool.h>
#include <stddef.h>

double aob_median(const double *x, size_t n);

/* The q-quantile, q in 0..1, which is linear between order statistics. */
double aob_quantile(const double *x, size_t n, double q);

/* Exact sign-test interval of the median, at least 95 %: [x_(k), x_(n+1-k)] with the largest k for which P(Bin(n,
 * 1/2) < k) <= 2.5 %. Returns false, with the whole range, for n < 6, where no such interval exists. */
bool aob_median_interval(const double *x, size_t n, double *low, double *high);

/* The two-sided quantile of Student's t: the |t| that is exceeded with probability `alpha`, 0 < alpha < 1. freedom >=
 * 1. */
double aob_student(double alpha, size_t freedom);

/* P(|T| > t), t >= 0 or infinite: what aob_student is the inverse of. */
double aob_student_tail(double t, size_t freedom);

/* The ratio of two costs from paired rounds is exp of the median of ln(a_i/b_i); its interval is the one above,
 * carried through exp. The pairing removes what both sides of a round share (drift, load). */
struct aob_ratio {
    double ratio, low, high;
    bool bounded; /* low and high are a 95 % interval */
};
struct aob_ratio aob_paired_ratio(const double *a, const double *b, size_t n);

/* b / a of two independent estimates with intervals of one level, which need not lie evenly about them. With l, u the
 * distances to the ends of each: the quotient's distances are sqrt(l_b^2 + u_a^2) and sqrt(u_b^2 + l_a^2). (Zou and
 * Donner, Construction of confidence limits about effect measures, Statistics in Medicine 27, 2008, equation 6.) */
struct aob_ratio aob_quotient(const struct aob_ratio *b, const struct aob_ratio *a);
#endif
