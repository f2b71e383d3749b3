#include "resolution.h"
#include <math.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"
#include "timing/processes.h"
#include "timing/timing.h"

const double aob_resolution_steps[AOB_RESOLUTION_STEPS] = {0.01, 0.02, 0.03, 0.05, 0.10};

/* Costs of a slot and of the fixed pass by the rounds' clock, process by process. */
struct sides {
    double *cost, *fixed;
    struct aob_rounds *processes;
    size_t count;
};

static void sides_init(struct sides *sides, const struct aob_round_list *rounds, size_t slot)
{
    *sides = (struct sides){.cost = AOB_NEW_ARRAY(double, rounds->count),
                            .fixed = AOB_NEW_ARRAY(double, rounds->count),
                            .processes = AOB_NEW_ARRAY(struct aob_rounds, rounds->count)};
    for (size_t r = 0; r < rounds->count; r++) {
        const struct aob_round *round = &rounds->items[r];
        sides->cost[r] = aob_slot_ms(&round->slots[slot], round->clock);
        sides->fixed[r] = aob_slot_ms(&round->slots[AOB_SLOT_FIXED], round->clock);
        if (r == 0 || round->process != round[-1].process)
            sides->processes[sides->count++] = (struct aob_rounds){&sides->cost[r], &sides->fixed[r], 0};
        sides->processes[sides->count - 1].count++;
    }
}

static void sides_finish(struct sides *sides)
{
    free(sides->cost);
    free(sides->fixed);
    free(sides->processes);
}

static struct aob_noise noise_of(const struct aob_round_list *rounds, size_t slot)
{
    struct sides sides;
    sides_init(&sides, rounds, slot);
    struct aob_noise noise = aob_noise_of(sides.processes, sides.count);
    sides_finish(&sides);
    return noise;
}

static double clean_share(const struct aob_round_list *rounds)
{
    double clean = 0, all = 0;
    for (size_t r = 0; r < rounds->count; r++)
        for (size_t s = 0; s < rounds->items[r].slot_count; s++, all++)
            clean += aob_slot_is_clean(&rounds->items[r].slots[s]);
    return clean / all;
}

static double seconds_of(const struct aob_round_list *rounds)
{
    double seconds = 0;
    for (size_t r = 0; r < rounds->count; r++)
        seconds += aob_round_seconds(&rounds->items[r]);
    return seconds;
}

/* What the interval would be after so many seconds. */
static double width_after(const struct aob_resolution *r, double seconds)
{
    const struct aob_processes_desc desc = {.seconds = seconds};
    double slice = aob_process_describe(&desc, 0).seconds;
    size_t processes = (size_t)fmax(AOB_PROCESSES_LEAST, floor(seconds / slice * (1 + 1e-9)));
    return aob_noise_width(&r->cost, processes, fmax(AOB_ROUNDS_LEAST, slice / r->round_s));
}

static double seconds_until(const struct aob_resolution *r, double share)
{
    double low = AOB_PROCESSES_LEAST * AOB_ROUNDS_LEAST * r->round_s, high = 1e6;
    if (!(width_after(r, high) <= log1p(share)))
        return NAN;
    for (int i = 0; i < 100 && width_after(r, low) > log1p(share); i++) {
        double middle = sqrt(low * high);
        if (width_after(r, middle) <= log1p(share))
            high = middle;
        else
            low = middle;
        if (high / low < 1 + 1e-9)
            low = high;
    }
    return low;
}

struct aob_resolution aob_resolution_of(const struct aob_round_list *rounds, double default_s)
{
    struct aob_resolution r = {.control = noise_of(rounds, AOB_SLOT_CONTROL),
                               .cost = noise_of(rounds, AOB_SLOT_CASES),
                               .clean = clean_share(rounds),
                               .round_s = seconds_of(rounds) / (double)rounds->count,
                               .recommended = NAN};
    for (int i = 0; i < AOB_RESOLUTION_STEPS; i++) {
        r.seconds[i] = seconds_until(&r, aob_resolution_steps[i]);
        if (isnan(r.recommended) && r.seconds[i] <= default_s)
            r.recommended = aob_resolution_steps[i];
    }
    return r;
}

static void print_noise(const char *what, const struct aob_noise *noise, struct aob_text *out)
{
    aob_text_add_line(out, "%-26s %8.2f %% %10.2f %% %12.2f %12.2f", what, 100 * noise->within,
                      100 * noise->between, noise->lag, noise->raw_lag);
}

void aob_resolution_print(const struct aob_resolution *r, struct aob_text *out)
{
    aob_text_add_line(out, "%zu rounds of %.3f s in %zu processes; %.0f %% of the slots were undisturbed",
                      r->cost.rounds, r->round_s, r->cost.processes, 100 * r->clean);
    aob_text_add_line(out, "%-26s %10s %12s %12s %12s", "sd of the log of a ratio", "in a round",
                      "of processes", "next round", "unpaired");
    print_noise("fixed pass to itself", &r->control, out);
    print_noise("the case to the fixed pass", &r->cost, out);
    aob_text_add_line(out,
                      "precision of a case: seconds of timing it; a difference of twice as much is resolved "
                      "by compare");
    for (int i = 0; i < AOB_RESOLUTION_STEPS; i++)
        if (isnan(r->seconds[i]))
            aob_text_add_line(out, "  %3g %%: not in 1e6 s", 100 * aob_resolution_steps[i]);
        else
            aob_text_add_line(out, "  %3g %%: %.3g s", 100 * aob_resolution_steps[i], r->seconds[i]);
    if (isnan(r->recommended))
        aob_text_add_line(out, "recommended: none is reached in the default time; give measure more seconds");
    else
        aob_text_add_line(out, "recommended: precision: %g%%", 100 * r->recommended);
}

static json_t *noise_to_json(const struct aob_noise *noise)
{
    return json_pack("{s:o, s:o, s:o, s:o}", "within", aob_json_number(noise->within), "between",
                     aob_json_number(noise->between), "lag", aob_json_number(noise->lag), "unpaired_lag",
                     aob_json_number(noise->raw_lag));
}

json_t *aob_resolution_to_json(const struct aob_resolution *r)
{
    json_t *steps = json_array();
    for (int i = 0; i < AOB_RESOLUTION_STEPS; i++)
        json_array_append_new(steps, json_pack("{s:f, s:o}", "precision", aob_resolution_steps[i], "seconds",
                                               aob_json_number(r->seconds[i])));
    return json_pack("{s:o, s:o, s:i, s:i, s:f, s:f, s:o, s:o}", "control", noise_to_json(&r->control),
                     "cost", noise_to_json(&r->cost), "processes", (int)r->cost.processes, "rounds",
                     (int)r->cost.rounds, "clean", r->clean, "round_seconds", r->round_s, "resolution", steps,
                     "recommended", aob_json_number(r->recommended));
}
