#include "estimate.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"

#define Z 1.959964

/* Student's 97.5 % quantile. Beyond the table it nears the normal one as 2.43/f, within .002. */
static double student(size_t degrees)
{
    static const double t[] = {INFINITY, 12.7062, 4.3027, 3.1824, 2.7764, 2.5706, 2.4469,
                               2.3646,   2.3060,  2.2622, 2.2281, 2.2010, 2.1788};
    return degrees < AOB_COUNT(t) ? t[degrees]
                                  : Z + 2.43 / (double)degrees + 2.0 / (double)(degrees * degrees);
}

/* ln(cost/fixed) of all rounds, process by process; each process's median. */
struct logs {
    double *all, *medians;
    size_t count, processes;
    double inverse; /* mean over processes of 1/rounds */
    double squares; /* sum over processes of rounds squared */
};

static void logs_init(struct logs *logs, const struct aob_rounds *processes, size_t count)
{
    *logs = (struct logs){.processes = count};
    for (size_t p = 0; p < count; p++)
        logs->count += processes[p].count;
    logs->all = AOB_NEW_ARRAY(double, logs->count);
    logs->medians = AOB_NEW_ARRAY(double, count);
    double *next = logs->all;
    for (size_t p = 0; p < count; p++) {
        size_t rounds = processes[p].count;
        for (size_t r = 0; r < rounds; r++)
            next[r] = log(processes[p].cost[r] / processes[p].fixed[r]);
        logs->medians[p] = aob_median(next, rounds);
        logs->inverse += 1 / (double)(rounds * count);
        logs->squares += (double)(rounds * rounds);
        next += rounds;
    }
}

static void logs_finish(struct logs *logs)
{
    free(logs->all);
    free(logs->medians);
}

/* The median distance of a round from its process's median, as a standard deviation. A median lies nearer to its own
 * rounds than the truth does; N/(N - P) makes up for it. */
static double deviation(const struct logs *logs, const struct aob_rounds *processes)
{
    double *distance = AOB_NEW_ARRAY(double, logs->count);
    size_t i = 0;
    for (size_t p = 0; p < logs->processes; p++)
        for (size_t r = 0; r < processes[p].count; r++, i++)
            distance[i] = fabs(logs->all[i] - logs->medians[p]);
    double n = (double)logs->count, sigma = 1.4826 * aob_median(distance, logs->count);
    free(distance);
    return sigma * sqrt(n / (n - (double)logs->processes));
}

static double variance_of_medians(const struct logs *logs)
{
    double n = (double)logs->processes, mean = 0, sum = 0;
    for (size_t p = 0; p < logs->processes; p++)
        mean += logs->medians[p] / n;
    for (size_t p = 0; p < logs->processes; p++)
        sum += (logs->medians[p] - mean) * (logs->medians[p] - mean);
    return sum / (n - 1);
}

static double half_width(const struct logs *logs, const struct aob_rounds *processes)
{
    double sigma = 1.2533 * deviation(logs, processes);
    double w2 = sigma * sigma * logs->inverse, s2 = variance_of_medians(logs);
    double share = s2 > w2 ? sqrt(1 - w2 / s2) : 0;
    double t = share > 0 ? (student(logs->processes - 1) - Z) * share : 0;
    double equal = (double)logs->count * (double)logs->count / logs->squares;
    return sqrt(fmax(s2, w2) / equal) * (Z + t);
}

struct aob_ratio aob_estimate_ratio(const struct aob_rounds *processes, size_t process_count)
{
    struct logs logs;
    if (process_count == 1)
        return aob_paired_ratio(processes->cost, processes->fixed, processes->count);
    logs_init(&logs, processes, process_count);
    double middle = aob_median(logs.all, logs.count);
    struct aob_ratio ratio = {.ratio = exp(middle), .low = 0, .high = INFINITY};
    if (logs.count > logs.processes) {
        double h = half_width(&logs, processes);
        ratio.low = exp(middle - h);
        ratio.high = exp(middle + h);
        ratio.bounded = true;
    }
    logs_finish(&logs);
    return ratio;
}

double aob_estimate_half_width(const struct aob_ratio *ratio)
{
    return ratio->bounded ? fmax(ratio->high / ratio->ratio, ratio->ratio / ratio->low) - 1 : INFINITY;
}
