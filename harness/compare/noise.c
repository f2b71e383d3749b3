#include "noise.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"

enum { ROUNDS_LEAST = 2, LAG_LEAST = 8 };

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

struct aob_noise aob_noise_of(const struct aob_rounds *processes, size_t count)
{
    struct aob_noise noise = {NAN, NAN, NAN, NAN, count, count_rounds(processes, count)};
    struct aob_scatter scatter;
    struct lag paired = {0}, raw = {0};
    for (size_t p = 0; p < count; p++)
        if (processes[p].count < ROUNDS_LEAST)
            return noise;
    if (!aob_estimate_scatter(processes, count, &scatter))
        return noise;
    noise.within = scatter.round;
    noise.between = aob_scatter_between(&scatter);
    for (size_t p = 0; p < count; p++) {
        double *logs = log_ratios(&processes[p]);
        add_lag(&paired, logs, processes[p].count);
        add_lag(&raw, processes[p].cost, processes[p].count);
        free(logs);
    }
    noise.lag = lag_of(&paired);
    noise.raw_lag = lag_of(&raw);
    return noise;
}
