#include "estimate.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"

#define Z 1.959964

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

static double deviation_of_medians(const struct logs *logs)
{
    double n = (double)logs->processes, mean = 0, sum = 0;
    for (size_t p = 0; p < logs->processes; p++)
        mean += logs->medians[p] / n;
    for (size_t p = 0; p < logs->processes; p++)
        sum += (logs->medians[p] - mean) * (logs->medians[p] - mean);
    return sqrt(sum / (n - 1));
}

/* pi/2 is the variance of a median in that of a mean, of many normal values. */
double aob_scatter_of_median(double sigma, double rounds)
{
    return sigma * sqrt(M_PI / 2 / rounds);
}

static bool scatter_of(const struct logs *logs, const struct aob_rounds *processes,
                       struct aob_scatter *scatter)
{
    if (logs->processes < 2 || logs->count <= logs->processes)
        return false;
    scatter->round = deviation(logs, processes);
    scatter->medians = deviation_of_medians(logs);
    scatter->explained = aob_scatter_of_median(scatter->round, 1 / logs->inverse);
    return true;
}

bool aob_estimate_scatter(const struct aob_rounds *processes, size_t process_count,
                          struct aob_scatter *scatter)
{
    struct logs logs;
    logs_init(&logs, processes, process_count);
    bool ok = scatter_of(&logs, processes, scatter);
    logs_finish(&logs);
    return ok;
}

double aob_scatter_between(const struct aob_scatter *scatter)
{
    double s = scatter->medians, w = scatter->explained;
    return sqrt(fmax(0, s * s - w * w));
}

double aob_scatter_half_width(const struct aob_scatter *scatter, double equal, size_t process_count)
{
    double s = scatter->medians, w = scatter->explained;
    double share = s > w ? aob_scatter_between(scatter) / s : 0;
    double t = share > 0 ? (aob_student(0.05, process_count - 1) - Z) * share : 0;
    return fmax(s, w) / sqrt(equal) * (Z + t);
}

struct aob_ratio aob_estimate_ratio(const struct aob_rounds *processes, size_t process_count)
{
    struct logs logs;
    struct aob_scatter scatter;
    if (process_count == 1)
        return aob_paired_ratio(processes->cost, processes->fixed, processes->count);
    logs_init(&logs, processes, process_count);
    double middle = aob_median(logs.all, logs.count);
    struct aob_ratio ratio = {.ratio = exp(middle), .low = 0, .high = INFINITY};
    if (scatter_of(&logs, processes, &scatter)) {
        double equal = (double)logs.count * (double)logs.count / logs.squares;
        double h = aob_scatter_half_width(&scatter, equal, process_count);
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
