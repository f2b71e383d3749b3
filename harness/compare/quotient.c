#include "quotient.h"
#include <math.h>

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

double aob_compare_alpha(size_t comparisons)
{
    return AOB_COMPARE_ALPHA / (double)(comparisons ? comparisons : 1);
}

struct aob_ratio aob_widen(const struct aob_ratio *ratio, size_t processes, double alpha)
{
    if (!ratio->bounded || processes < 2)
        return (struct aob_ratio){ratio->ratio, 0, INFINITY, false};
    double factor = aob_student(alpha, processes - 1) / aob_student(0.05, processes - 1);
    return (struct aob_ratio){ratio->ratio, ratio->ratio * pow(ratio->low / ratio->ratio, factor),
                              ratio->ratio * pow(ratio->high / ratio->ratio, factor), true};
}
