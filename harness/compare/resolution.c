#include "resolution.h"
#include <math.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"
#include "timing/forecast.h"
#include "timing/sides.h"

const double aob_resolution_steps[AOB_RESOLUTION_STEPS] = {0.01, 0.02, 0.03, 0.05, 0.10};

static struct aob_noise noise_of(const struct aob_round_list *rounds, size_t slot)
{
    struct aob_sides sides;
    aob_sides_init(&sides, rounds, &(struct aob_sides_desc){slot, AOB_SLOT_FIXED, AOB_SIDES_WHOLE});
    struct aob_noise noise = aob_noise_of(sides.processes, sides.count);
    aob_sides_finish(&sides);
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

struct aob_resolution aob_resolution_of(const struct aob_round_list *rounds, double default_s)
{
    struct aob_forecast forecast;
    struct aob_resolution r = {.control = noise_of(rounds, AOB_SLOT_CONTROL),
                               .cost = noise_of(rounds, AOB_SLOT_CASES),
                               .clean = clean_share(rounds),
                               .recommended = NAN};
    bool known = aob_forecast_init(&forecast, rounds, AOB_SLOT_CASES, 0);
    r.round_s = forecast.round_s;
    for (int i = 0; i < AOB_RESOLUTION_STEPS; i++) {
        r.seconds[i] = known ? aob_forecast_seconds(&forecast, aob_resolution_steps[i]) : INFINITY;
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
        if (isinf(r->seconds[i]))
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
                                               aob_json_number(isinf(r->seconds[i]) ? NAN : r->seconds[i])));
    return json_pack("{s:o, s:o, s:i, s:i, s:f, s:f, s:o, s:o}", "control", noise_to_json(&r->control),
                     "cost", noise_to_json(&r->cost), "processes", (int)r->cost.processes, "rounds",
                     (int)r->cost.rounds, "clean", r->clean, "round_seconds", r->round_s, "resolution", steps,
                     "recommended", aob_json_number(r->recommended));
}
