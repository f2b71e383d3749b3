#include "summary.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "estimate.h"

enum { WHOLE = -1 }; /* in place of a pass */

static double cost(const struct aob_round *round, size_t slot, int pass, enum aob_clock clock)
{
    const struct aob_slot *s = &round->slots[slot];
    return pass == WHOLE ? aob_slot_ms(s, clock) : aob_slot_pass_ms(s, (size_t)pass, clock);
}

/* Both sides of the rounds from `first` on, each by its clock; free() the first. `unit`: the slot of the other side. */
static double *pair(const struct aob_round_list *rounds, size_t first, size_t slot, int pass, size_t unit,
                    double **fixed)
{
    size_t count = rounds->count - first;
    double *costs = AOB_NEW_ARRAY(double, 2 * count);
    *fixed = costs + count;
    for (size_t i = 0; i < count; i++) {
        const struct aob_round *round = &rounds->items[first + i];
        costs[i] = cost(round, slot, pass, round->clock);
        (*fixed)[i] = cost(round, unit, WHOLE, round->clock);
    }
    return costs;
}

static bool begins_process(const struct aob_round_list *rounds, size_t r)
{
    return r == 0 || rounds->items[r].process != rounds->items[r - 1].process;
}

static struct aob_ratio ratio_of(const struct aob_round_list *rounds, size_t slot, int pass, size_t unit)
{
    size_t used = 0, kept = 0;
    int process = -1;
    double *fixed, *costs = pair(rounds, 0, slot, pass, unit, &fixed);
    struct aob_rounds *processes = AOB_NEW_ARRAY(struct aob_rounds, rounds->count);
    for (size_t r = 0; r < rounds->count; r++) {
        if (isnan(costs[r])) /* the clock does not know this pass: it is short, or one of many in a submit */
            continue;
        costs[kept] = costs[r];
        fixed[kept] = fixed[r];
        if (rounds->items[r].process != process)
            processes[used++] = (struct aob_rounds){costs + kept, fixed + kept, 0};
        process = rounds->items[r].process;
        processes[used - 1].count++;
        kept++;
    }
    struct aob_ratio ratio = {.ratio = NAN, .high = INFINITY};
    if (used)
        ratio = aob_estimate_ratio(processes, used);
    free(processes);
    free(costs);
    return ratio;
}

struct aob_ratio aob_rounds_ratio(const struct aob_round_list *rounds, size_t slot)
{
    return ratio_of(rounds, slot, WHOLE, AOB_SLOT_FIXED);
}

struct aob_ratio aob_rounds_quotient(const struct aob_round_list *rounds, size_t slot, size_t unit)
{
    return ratio_of(rounds, slot, WHOLE, unit);
}

struct aob_ratio aob_rounds_own_ratio(const struct aob_round_list *rounds, size_t first, size_t slot)
{
    double *fixed, *costs = pair(rounds, first, slot, WHOLE, AOB_SLOT_FIXED, &fixed);
    struct aob_ratio ratio = aob_paired_ratio(costs, fixed, rounds->count - first);
    free(costs);
    return ratio;
}

static double median_ms(const struct aob_round_list *rounds, size_t slot, int pass, enum aob_clock clock)
{
    double *ms = AOB_NEW_ARRAY(double, rounds->count);
    size_t used = 0;
    for (size_t r = 0; r < rounds->count; r++) {
        double value = cost(&rounds->items[r], slot, pass, clock);
        bool counts = clock != AOB_CLOCK_WALL || aob_slot_is_clean(&rounds->items[r].slots[slot]);
        if (counts && !isnan(value))
            ms[used++] = value;
    }
    double median = used ? aob_median(ms, used) : NAN;
    free(ms);
    return median;
}

static struct aob_times times_of(const struct aob_round_list *rounds, size_t slot, int pass)
{
    struct aob_times times;
    for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++)
        times.ms[clock] = median_ms(rounds, slot, pass, (enum aob_clock)clock);
    return times;
}

void aob_summarise(const struct aob_round_list *rounds, size_t slot, struct aob_summary *summary)
{
    *summary = (struct aob_summary){.whole = times_of(rounds, slot, WHOLE),
                                    .to_fixed = ratio_of(rounds, slot, WHOLE, AOB_SLOT_FIXED),
                                    .pass_count = rounds->items[0].slots[slot].pass_count,
                                    .rounds = rounds->count,
                                    .frames = rounds->items[0].slots[slot].frames};
    for (size_t r = 0; r < rounds->count; r++) {
        summary->processes += begins_process(rounds, r);
        summary->clean_rounds += aob_slot_is_clean(&rounds->items[r].slots[slot]);
    }
    for (size_t p = 0; p < summary->pass_count; p++) {
        summary->passes[p] = times_of(rounds, slot, (int)p);
        summary->pass_to_fixed[p] = ratio_of(rounds, slot, (int)p, AOB_SLOT_FIXED);
    }
}
