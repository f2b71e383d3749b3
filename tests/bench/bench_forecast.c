/* bench_forecast FILE SECONDS PRECISION TRIALS: whether the seconds that a short run foretells are those that it takes, on
 * recorded rounds. Each case by itself is timed anew by the scheduler's own rules, in processes that are drawn from the
 * recorded ones: to the precision (a share), TRIALS times, and for SECONDS, TRIALS times. A line "slot_N TOLD TOOK" each:
 * the median that the short runs foretell, of those that were not precise, and the median of what it took. NEVER stands for
 * more than LONG seconds of the latter, and for "inf" of the former; "nan" where most of the short runs were precise. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/memory.h"
#include "random.h"
#include "timing/forecast.h"
#include "timing/summary.h"
#include "timing/timing.h"

#define LONG  25.0 /* up to here all processes are of one length */
#define NEVER 1e9

struct replay {
    struct aob_round_list recorded;
    size_t *starts, processes; /* of each recorded process, and one behind the last */
    size_t slot;
    double precision;
    uint32_t random;
};

static void find_processes(struct replay *r)
{
    r->starts = AOB_NEW_ARRAY(size_t, r->recorded.count + 1);
    for (size_t i = 0; i < r->recorded.count; i++)
        if (i == 0 || r->recorded.items[i].process != r->recorded.items[i - 1].process)
            r->starts[r->processes++] = i;
    r->starts[r->processes] = r->recorded.count;
}

/* The fixed pass, the control, and the one case. */
static void copy_round(const struct replay *r, size_t at, const struct aob_process_desc *process,
                       struct aob_round_list *rounds)
{
    struct aob_round *round = AOB_PUSH(rounds->items, rounds->count, rounds->capacity);
    *round = r->recorded.items[at];
    round->process = process->index;
    round->slots[AOB_SLOT_CASES] = r->recorded.items[at].slots[r->slot];
    round->slot_count = AOB_SLOT_CASES + 1;
}

/* Successive rounds from a random place, as many as a process takes. */
static bool run(void *user, const struct aob_process_desc *process, struct aob_round_list *rounds,
                struct aob_error *error)
{
    struct replay *r = user;
    const struct aob_timing_desc desc = {
        .frame_count = 1, .seconds = process->seconds, .precision = r->precision};
    size_t chosen = random_below(&r->random, r->processes), first = rounds->count;
    size_t start = r->starts[chosen], length = r->starts[chosen + 1] - start;
    size_t at = random_below(&r->random, length);
    double measured_s = 0;
    (void)error;
    while (!aob_timing_is_over(&desc, rounds, first, measured_s)) {
        copy_round(r, start + at++ % length, process, rounds);
        measured_s += aob_round_seconds(&rounds->items[rounds->count - 1]);
    }
    return true;
}

static void on_lost(void *user, int index, const char *reason)
{
    (void)user;
    fprintf(stderr, "bench_forecast: process %d: %s\n", index, reason);
}

/* What was spent, and what is foretold: NAN where the precision is reached. */
static void measure(struct replay *r, double seconds, double *spent, double *foretold)
{
    const struct aob_processes_desc desc = {.case_count = 1,
                                            .seconds = seconds,
                                            .precision = r->precision,
                                            .run = run,
                                            .on_lost = on_lost,
                                            .user = r};
    struct aob_processes result;
    aob_processes_run(&desc, &result, NULL);
    *spent = result.measured_s;
    *foretold = aob_seconds_needed(&result.rounds, AOB_SLOT_CASES, &desc);
    aob_processes_finish(&result);
}

static void judge(struct replay *r, double seconds, size_t trials)
{
    double *told = AOB_NEW_ARRAY(double, trials), *took = AOB_NEW_ARRAY(double, trials), spent, foretold;
    size_t used = 0;
    for (size_t t = 0; t < trials; t++) {
        measure(r, LONG, &took[t], &foretold);
        if (!isnan(foretold))
            took[t] = NEVER;
        measure(r, seconds, &spent, &foretold);
        if (!isnan(foretold))
            told[used++] = fmin(foretold, NEVER);
    }
    printf("slot_%zu %.3g %.3g\n", r->slot, 2 * used >= trials ? aob_median(told, used) : NAN,
           aob_median(took, trials));
    free(told);
    free(took);
}

int main(int argc, char **argv)
{
    struct replay r = {.random = 1};
    struct aob_error error = {{0}};
    if (argc != 5 || !aob_rounds_read(argv[1], &r.recorded, &error)) {
        fprintf(stderr, "bench_forecast: %s\n", *error.text ? error.text : "FILE SECONDS PRECISION TRIALS");
        return 2;
    }
    find_processes(&r);
    r.precision = atof(argv[3]);
    size_t slots = r.recorded.items[0].slot_count;
    for (r.slot = AOB_SLOT_CASES; r.slot < slots; r.slot++)
        judge(&r, atof(argv[2]), strtoul(argv[4], NULL, 10));
    free(r.starts);
    aob_rounds_finish(&r.recorded);
    return 0;
}
