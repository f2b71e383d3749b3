#include "quotient.h"
#include <math.h>

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

double aob_ratio_p(const struct aob_ratio *ratio, size_t processes)
{
    if (!ratio->bounded || processes < 2)
        return NAN;
    double off = fabs(log(ratio->ratio));
    double half = log(ratio->ratio > 1 ? ratio->ratio / ratio->low : ratio->high / ratio->ratio);
    if (!(off > 0))
        return 1;
    return aob_student_tail(off / half * aob_student(0.05, processes - 1), processes - 1);
}

double aob_lasting_half_width(const struct aob_ratio *ratio, double alpha)
{
    enum { MANY = 1000 }; /* degrees of freedom, within .2 % of the normal quantile down to alpha 1e-4 */
    if (!ratio->bounded)
        return INFINITY;
    double half = fmax(log(ratio->high / ratio->ratio), log(ratio->ratio / ratio->low));
    return half * aob_student(alpha, MANY) / aob_student(0.05, MANY);
}
