#include "noise.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "quotient.h"

enum { ROUNDS_LEAST = 2, PROCESSES_LEAST = 2, LAG_LEAST = 8 };

static size_t count_rounds(const struct aob_rounds *processes, size_t count)
{
    size_t rounds = 0;
    for (size_t p = 0; p < count; p++)
        rounds += processes[p].count;
    return rounds;
}

static double *log_ratios(const struct aob_rounds *process)
{
    double *logs = AOB_NEW_ARRAY(double, process->count);
    for (size_t i = 0; i < process->count; i++)
        logs[i] = log(process->cost[i] / process->fixed[i]);
    return logs;
}

/* Sums for a correlation of neighbours, over all processes. */
struct lag {
    double products, squares;
};

/* A few rounds lie on both sides of their own mean, whatever their order. */
static void add_lag(struct lag *lag, const double *x, size_t count)
{
    double mean = 0;
    if (count < LAG_LEAST)
        return;
    for (size_t i = 0; i < count; i++)
        mean += x[i] / (double)count;
    for (size_t i = 0; i < count; i++) {
        lag->squares += (x[i] - mean) * (x[i] - mean);
        lag->products += i ? (x[i] - mean) * (x[i - 1] - mean) : 0;
    }
}

static double lag_of(const struct lag *lag)
{
    return lag->squares > 0 ? lag->products / lag->squares : NAN;
}

static double variance(const double *x, size_t count)
{
    double mean = 0, sum = 0;
    for (size_t i = 0; i < count; i++)
        mean += x[i] / (double)count;
    for (size_t i = 0; i < count; i++)
        sum += (x[i] - mean) * (x[i] - mean);
    return sum / (double)(count - 1);
}

struct aob_noise aob_noise_of(const struct aob_rounds *processes, size_t count)
{
    struct aob_noise noise = {NAN, NAN, NAN, NAN, count, count_rounds(processes, count)};
    struct lag paired = {0}, raw = {0};
    size_t used = 0;
    for (size_t p = 0; p < count; p++)
        if (processes[p].count < ROUNDS_LEAST)
            return noise;
    if (count < PROCESSES_LEAST)
        return noise;
    double *levels = AOB_NEW_ARRAY(double, count), *away = AOB_NEW_ARRAY(double, noise.rounds);
    for (size_t p = 0; p < count; p++) {
        double *logs = log_ratios(&processes[p]);
        levels[p] = aob_median(logs, processes[p].count);
        for (size_t i = 0; i < processes[p].count; i++)
            away[used++] = fabs(logs[i] - levels[p]);
        add_lag(&paired, logs, processes[p].count);
        add_lag(&raw, processes[p].cost, processes[p].count);
        free(logs);
    }
    /* A median lies nearer to its own rounds than the truth does (timing/estimate.h). */
    noise.within = 1.4826 * aob_median(away, used) *
                   sqrt((double)noise.rounds / (double)(noise.rounds - noise.processes));
    double mean_rounds = (double)noise.rounds / (double)count;
    noise.between =
        sqrt(fmax(0, variance(levels, count) - M_PI / 2 * noise.within * noise.within / mean_rounds));
    noise.lag = lag_of(&paired);
    noise.raw_lag = lag_of(&raw);
    free(levels);
    free(away);
    return noise;
}

double aob_noise_width(const struct aob_noise *noise, size_t processes, double rounds)
{
    const double z = 1.959964;
    double own = noise->between * noise->between,
           s2 = own + M_PI / 2 * noise->within * noise->within / rounds;
    double t = s2 > 0 ? (aob_student(0.05, processes - 1) - z) * sqrt(own / s2) : 0;
    return sqrt(s2 / (double)processes) * (z + t);
}
