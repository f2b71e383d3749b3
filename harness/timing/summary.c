#include "summary.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "estimate.h"
#include "sides.h"

static bool begins_process(const struct aob_round_list *rounds, size_t r)
{
    return r == 0 || rounds->items[r].process != rounds->items[r - 1].process;
}

static struct aob_ratio ratio_of(const struct aob_round_list *rounds, size_t slot, int pass, size_t unit)
{
    struct aob_sides sides;
    struct aob_ratio ratio = {.ratio = NAN, .high = INFINITY};
    aob_sides_init(&sides, rounds, &(struct aob_sides_desc){slot, unit, pass});
    if (sides.count)
        ratio = aob_estimate_ratio(sides.processes, sides.count);
    aob_sides_finish(&sides);
    return ratio;
}

struct aob_ratio aob_rounds_ratio(const struct aob_round_list *rounds, size_t slot)
{
    return ratio_of(rounds, slot, AOB_SIDES_WHOLE, AOB_SLOT_FIXED);
}

struct aob_ratio aob_rounds_quotient(const struct aob_round_list *rounds, size_t slot, size_t unit)
{
    return ratio_of(rounds, slot, AOB_SIDES_WHOLE, unit);
}

static double median_ms(const struct aob_round_list *rounds, size_t slot, int pass, enum aob_clock clock)
{
    double *ms = AOB_NEW_ARRAY(double, rounds->count);
    size_t used = 0;
    for (size_t r = 0; r < rounds->count; r++) {
        double value = aob_sides_ms(&rounds->items[r], slot, pass, clock);
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
    *summary = (struct aob_summary){.whole = times_of(rounds, slot, AOB_SIDES_WHOLE),
                                    .to_fixed = ratio_of(rounds, slot, AOB_SIDES_WHOLE, AOB_SLOT_FIXED),
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
