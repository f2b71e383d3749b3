#include "sides.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"

double aob_sides_ms(const struct aob_round *round, size_t slot, int pass, enum aob_clock clock)
{
    const struct aob_slot *s = &round->slots[slot];
    return pass == AOB_SIDES_WHOLE ? aob_slot_ms(s, clock) : aob_slot_pass_ms(s, (size_t)pass, clock);
}

void aob_sides_init(struct aob_sides *sides, const struct aob_round_list *rounds,
                    const struct aob_sides_desc *desc)
{
    size_t kept = 0;
    int process = -1;
    *sides = (struct aob_sides){.cost = AOB_NEW_ARRAY(double, rounds->count),
                                .fixed = AOB_NEW_ARRAY(double, rounds->count),
                                .processes = AOB_NEW_ARRAY(struct aob_rounds, rounds->count)};
    for (size_t r = 0; r < rounds->count; r++) {
        const struct aob_round *round = &rounds->items[r];
        sides->cost[kept] = aob_sides_ms(round, desc->slot, desc->pass, round->clock);
        sides->fixed[kept] = aob_sides_ms(round, desc->unit, AOB_SIDES_WHOLE, round->clock);
        if (isnan(
                sides->cost
                    [kept])) /* the clock does not know this pass: it is short, or one of many in a submit */
            continue;
        if (round->process != process)
            sides->processes[sides->count++] =
                (struct aob_rounds){&sides->cost[kept], &sides->fixed[kept], 0};
        process = round->process;
        sides->processes[sides->count - 1].count++;
        kept++;
    }
}

void aob_sides_finish(struct aob_sides *sides)
{
    free(sides->cost);
    free(sides->fixed);
    free(sides->processes);
    *sides = (struct aob_sides){0};
}
