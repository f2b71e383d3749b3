/* bench_compare ROUNDS.jsonl.zst A B PRECISION PROCESSES TRIALS: how often the rule of `aobudget compare` gives each verdict
 * on the cases of those places (0, 1) in recorded rounds. Each trial draws so many of the recorded processes, without replacement, as one
 * comparison would have measured. A line "VERDICT COUNT" each, and "load SHARE": what the device's threads used of the
 * processors that the wall clock left them. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/machine.h"
#include "base/memory.h"
#include "compare/quotient.h"
#include "compare/verdict.h"
#include "random.h"
#include "timing/summary.h"

struct recorded {
    struct aob_round_list rounds;
    size_t *starts;         /* of each process, and one behind the last */
    size_t processes, a, b; /* a, b: slots */
    double precision;
};

static void find_processes(struct recorded *r)
{
    r->starts = AOB_NEW_ARRAY(size_t, r->rounds.count + 1);
    for (size_t i = 0; i < r->rounds.count; i++)
        if (i == 0 || r->rounds.items[i].process != r->rounds.items[i - 1].process)
            r->starts[r->processes++] = i;
    r->starts[r->processes] = r->rounds.count;
}

/* The first `wanted` of `order` become another random choice. */
static void draw(size_t *order, size_t count, size_t wanted, uint32_t *seed)
{
    for (size_t i = 0; i < wanted; i++) {
        size_t j = i + random_below(seed, count - i), moved = order[i];
        order[i] = order[j];
        order[j] = moved;
    }
}

static enum aob_verdict judge(const struct recorded *r, const size_t *order, size_t wanted)
{
    struct aob_round_list some = {0};
    for (size_t p = 0; p < wanted; p++)
        for (size_t i = r->starts[order[p]]; i < r->starts[order[p] + 1]; i++)
            *AOB_PUSH(some.items, some.count, some.capacity) = r->rounds.items[i];
    struct aob_ratio cost = aob_rounds_quotient(&some, r->b, r->a);
    const struct aob_comparison comparison = {.cost = aob_widen(&cost, wanted, aob_compare_alpha(1)),
                                              .control = aob_rounds_ratio(&some, AOB_SLOT_CONTROL),
                                              .resolution = r->precision,
                                              .rounds = some.count,
                                              .processes = wanted};
    enum aob_verdict verdict = aob_judge(&comparison).verdict;
    aob_rounds_finish(&some);
    return verdict;
}

/* Processor time over wall time of the fixed pass, a thread: 1 where nothing else runs. */
static double load_of(const struct aob_round_list *rounds)
{
    double cpu = 0, wall = 0;
    for (size_t r = 0; r < rounds->count; r++) {
        const struct aob_slot *slot = &rounds->items[r].slots[AOB_SLOT_FIXED];
        cpu += (double)slot->whole.ns[AOB_CLOCK_CPU];
        wall += (double)slot->whole.ns[AOB_CLOCK_WALL];
    }
    return cpu / wall / aob_machine_cores();
}

static bool read_arguments(struct recorded *r, char **argv, struct aob_error *error)
{
    r->a = AOB_SLOT_CASES + (size_t)atol(argv[2]);
    r->b = AOB_SLOT_CASES + (size_t)atol(argv[3]);
    r->precision = atof(argv[4]);
    if (!aob_rounds_read(argv[1], &r->rounds, error))
        return false;
    find_processes(r);
    size_t slots = r->rounds.items[0].slot_count, wanted = (size_t)atol(argv[5]);
    return (r->a < slots && r->b < slots && wanted <= r->processes) ||
           aob_fail(error, "%s: %zu cases in %zu processes are recorded", argv[1], slots - AOB_SLOT_CASES,
                    r->processes);
}

int main(int argc, char **argv)
{
    struct recorded r = {0};
    struct aob_error error = {{0}};
    if (argc != 7 || !read_arguments(&r, argv, &error))
        return printf("usage: bench_compare ROUNDS A B PRECISION PROCESSES TRIALS; %s\n", error.text), 2;
    size_t wanted = (size_t)atol(argv[5]), trials = (size_t)atol(argv[6]), counts[AOB_VERDICT_COUNT] = {0};
    size_t *order = AOB_NEW_ARRAY(size_t, r.processes);
    uint32_t seed = 1;
    for (size_t p = 0; p < r.processes; p++)
        order[p] = p;
    for (size_t t = 0; t < trials; t++) {
        draw(order, r.processes, wanted, &seed);
        counts[judge(&r, order, wanted)]++;
    }
    for (int v = 0; v < AOB_VERDICT_COUNT; v++)
        printf("%s %zu\n", aob_verdict_names[v], counts[v]);
    printf("load %.3f\n", load_of(&r.rounds));
    free(order);
    free(r.starts);
    aob_rounds_finish(&r.rounds);
    return 0;
}
