#include "statistics.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "memory.h"

static int compare(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double *sorted(const double *x, size_t n)
{
    double *copy = AOB_NEW_ARRAY(double, n);
    memcpy(copy, x, n * sizeof *x);
    qsort(copy, n, sizeof *x, compare);
    return copy;
}

double aob_quantile(const double *x, size_t n, double q)
{
    double *s = sorted(x, n), at = q * (double)(n - 1);
    size_t i = (size_t)at, next = i + 1 < n ? i + 1 : i;
    double value = s[i] + (s[next] - s[i]) * (at - (double)i);
    free(s);
    return value;
}

double aob_median(const double *x, size_t n)
{
    return aob_quantile(x, n, 0.5);
}

/* P(Bin(n, 1/2) = k). */
static double binomial(size_t n, size_t k)
{
    return exp(lgamma((double)n + 1) - lgamma((double)k + 1) - lgamma((double)(n - k) + 1) -
               (double)n * log(2.0));
}

bool aob_median_interval(const double *x, size_t n, double *low, double *high)
{
    size_t k = 0; /* P(Bin < k) = P(Bin <= k - 1) */
    for (double tail = binomial(n, 0); k < n / 2 && tail <= 0.025; tail += binomial(n, k))
        k++;
    double *s = sorted(x, n);
    size_t first = k ? k - 1 : 0;
    *low = s[first];
    *high = s[n - 1 - first];
    free(s);
    return k > 0;
}

struct aob_ratio aob_paired_ratio(const double *a, const double *b, size_t n)
{
    struct aob_ratio result;
    double *logs = AOB_NEW_ARRAY(double, n);
    for (size_t i = 0; i < n; i++)
        logs[i] = log(a[i] / b[i]);
    result.bounded = aob_median_interval(logs, n, &result.low, &result.high);
    result.ratio = exp(aob_median(logs, n));
    result.low = exp(result.low);
    result.high = exp(result.high);
    free(logs);
    return result;
}

struct aob_ratio aob_quotient(const struct aob_ratio *b, const struct aob_ratio *a)
{
    struct aob_ratio q = {.ratio = b->ratio / a->ratio, .bounded = a->bounded && b->bounded};
    double down = hypot(log(b->ratio / b->low), log(a->high / a->ratio));
    double up = hypot(log(b->high / b->ratio), log(a->ratio / a->low));
    q.low = q.bounded ? q.ratio * exp(-down) : 0;
    q.high = q.bounded ? q.ratio * exp(up) : INFINITY;
    return q;
}

/* P(|T| < t): the finite sums for whole degrees of freedom (Abramowitz and Stegun, 26.7.3 and 26.7.4). */
static double within(double t, size_t freedom)
{
    double angle = atan(t / sqrt((double)freedom)), cosine = cos(angle), term = 1, sum = 0;
    bool odd = freedom % 2;
    if (freedom == 1)
        return 2 / M_PI * angle;
    if (odd)
        term = cosine;
    for (size_t k = odd ? 3 : 2; k <= freedom; k += 2) {
        sum += term;
        term *= cosine * cosine * (double)(k - 1) / (double)k;
    }
    return odd ? 2 / M_PI * (angle + sin(angle) * sum) : sin(angle) * sum;
}

double aob_student_tail(double t, size_t freedom)
{
    return 1 - within(t, freedom);
}

double aob_student(double alpha, size_t freedom)
{
    double low = 0, high = 2;
    while (within(high, freedom) < 1 - alpha && high < 1e12)
        high *= 2;
    for (int i = 0; i < 100; i++) {
        double middle = 0.5 * (low + high);
        if (within(middle, freedom) < 1 - alpha)
            low = middle;
        else
            high = middle;
    }
    return high;
}
