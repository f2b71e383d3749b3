#include "trial.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "timing/sides.h"
#include "timing/summary.h"
#include "timing/timing.h"

static struct aob_trial_time time_of(const struct aob_round_list *rounds, size_t slot, int pass)
{
    struct aob_trial_time time = {NAN, NAN, NAN};
    double *ms = AOB_NEW_ARRAY(double, rounds->count);
    size_t used = 0;
    for (size_t r = 0; r < rounds->count; r++) {
        ms[used] = aob_sides_ms(&rounds->items[r], slot, pass, rounds->items[r].clock);
        used += isnan(ms[used]) ? 0 : 1;
    }
    if (used)
        time.ms = aob_median(ms, used);
    if (used && !aob_median_interval(ms, used, &time.low, &time.high))
        time.low = time.high = NAN;
    free(ms);
    return time;
}

/* Of one round: NAN where the clock did not see each pass. */
static double share_of(const struct aob_round *round)
{
    double sum = 0;
    for (size_t p = 0; p < round->slots[AOB_SLOT_CASES].pass_count; p++)
        sum += aob_sides_ms(round, AOB_SLOT_CASES, (int)p, round->clock);
    return sum / aob_sides_ms(round, AOB_SLOT_CASES, AOB_SIDES_WHOLE, round->clock);
}

static double median_share(const struct aob_round_list *rounds)
{
    double *shares = AOB_NEW_ARRAY(double, rounds->count), median = NAN;
    size_t used = 0;
    for (size_t r = 0; r < rounds->count; r++) {
        shares[used] = share_of(&rounds->items[r]);
        used += isnan(shares[used]) ? 0 : 1;
    }
    if (used)
        median = aob_median(shares, used);
    free(shares);
    return median;
}

static void summarise(const struct aob_round_list *rounds, struct aob_trial *trial)
{
    const struct aob_slot *slot = &rounds->items[0].slots[AOB_SLOT_CASES];
    *trial = (struct aob_trial){.rounds = rounds->count,
                                .frames = slot->frames,
                                .whole = time_of(rounds, AOB_SLOT_CASES, AOB_SIDES_WHOLE),
                                .fixed = time_of(rounds, AOB_SLOT_FIXED, AOB_SIDES_WHOLE),
                                .passes_share = median_share(rounds),
                                .to_fixed = aob_rounds_ratio(rounds, AOB_SLOT_CASES),
                                .control = aob_rounds_ratio(rounds, AOB_SLOT_CONTROL)};
    for (size_t p = 0; p < slot->pass_count; p++)
        trial->passes[p] = time_of(rounds, AOB_SLOT_CASES, (int)p);
}

bool aob_trial_run(const struct aob_trial_desc *desc, struct aob_trial *trial, struct aob_error *error)
{
    struct aob_round_list rounds = {0};
    bool ok = aob_timing_run(&(struct aob_timing_desc){.fixed = desc->fixed,
                                                       .frames = &desc->frame,
                                                       .frame_count = 1,
                                                       .seconds = desc->seconds,
                                                       .precision = desc->precision,
                                                       .seed = 1,
                                                       .clock = desc->clock},
                             &rounds, error);
    if (ok)
        summarise(&rounds, trial);
    aob_rounds_finish(&rounds);
    return ok;
}
