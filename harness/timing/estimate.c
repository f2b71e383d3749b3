#include "estimate.h"
#include <math.h>

/* The 97.5 % quantile of Student's t, within 1 % of it from 3 degrees of freedom on (Cornish and Fisher's expansion). */
static double student(size_t freedom)
{
    const double z = 1.959964, n = (double)freedom;
    if (freedom == 1)
        return 12.7062;
    if (freedom == 2)
        return 4.30265;
    return z + (z * z * z + z) / (4 * n) + (5 * z * z * z * z * z + 16 * z * z * z + 3 * z) / (96 * n * n);
}

/* A stand-in: Student's interval of the processes' medians. */
struct aob_ratio aob_estimate_ratio(const struct aob_rounds *processes, size_t process_count)
{
    double sum = 0, squares = 0, n = (double)process_count;
    for (size_t p = 0; p < process_count; p++) {
        struct aob_ratio own = aob_paired_ratio(processes[p].cost, processes[p].fixed, processes[p].count);
        sum += log(own.ratio);
    }
    for (size_t p = 0; p < process_count; p++) {
        struct aob_ratio own = aob_paired_ratio(processes[p].cost, processes[p].fixed, processes[p].count);
        squares += (log(own.ratio) - sum / n) * (log(own.ratio) - sum / n);
    }
    struct aob_ratio ratio = {.ratio = exp(sum / n), .bounded = process_count >= 2};
    double half = ratio.bounded ? student(process_count - 1) * sqrt(squares / (n - 1) / n) : 0;
    ratio.low = ratio.ratio * exp(-half);
    ratio.high = ratio.ratio * exp(half);
    return ratio;
}
