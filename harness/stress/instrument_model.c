#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/shelf.h"
#include "chance.h"
#include "instruments.h"
#include "profile/model.h"

/* Passes by lot, of a frame's order of size. */
enum { PASSES = 200 };

static struct aob_model_input draw_input(struct aob_chance *chance, int levels)
{
    struct aob_model_input input = {.operations = {.alu = aob_chance_log(chance, 1e5, 1e12),
                                                   .special = aob_chance_log(chance, 1e4, 1e11),
                                                   .image = aob_chance_log(chance, 1e4, 1e11)},
                                    .written = aob_chance_log(chance, 1e5, 1e9),
                                    .pixels = aob_chance_log(chance, 1e5, 1e8)};
    input.issue.least = (uint64_t)aob_chance_log(chance, 1e5, 1e10);
    input.issue.banked = input.issue.least * (1 + aob_chance_below(chance, 3));
    input.issue.most = input.issue.banked * (1 + aob_chance_below(chance, 3));
    for (int l = 0; l < levels; l++)
        for (int f = 0; f < AOB_FLIGHT_COUNT; f++)
            input.filled[l][f] = aob_chance_log(chance, 1e4, 1e11);
    return input;
}

typedef void ask_profile_fn(struct aob_trial *trial, const struct aob_profile *profile,
                            const struct aob_model_input *input);

static void ask_profile(struct aob_trial *trial, const struct aob_profile *profile, ask_profile_fn *ask)
{
    struct aob_chance chance = aob_chance_of(profile->name);
    for (int p = 0; profile->rates.clock > 0 && p < PASSES; p++) {
        struct aob_model_input input = draw_input(&chance, profile->level_count);
        ask(trial, profile, &input);
    }
}

static char made_name[] = "made";

/* One of round numbers, so that there is one wherever the program lies. */
static const struct aob_profile made = {.name = made_name,
                                        .level_count = 2,
                                        .levels = {{.name = "L1", .fill = 64, .ports = 100}, {.name = "L2"}},
                                        .rates = {.clock = 1,
                                                  .alu_clock = 2,
                                                  .lanes = 500,
                                                  .special = 0.25,
                                                  .texture_units = 200,
                                                  .tags = 4,
                                                  .point_64 = 2,
                                                  .rops = 10,
                                                  .memory = 100,
                                                  .launch = 5}};

/* It, and each that lies beside the program and has rates. */
static void ask_profiles(struct aob_trial *trial, ask_profile_fn *ask)
{
    struct aob_shelf_names names = {0};
    ask_profile(trial, &made, ask);
    aob_shelf_list(AOB_PROFILE_SHELF, &names, NULL);
    for (size_t i = 0; i < names.count; i++) {
        struct aob_profile profile = {0};
        if (!aob_profile_find(&profile, names.items[i], &trial->error))
            break;
        ask_profile(trial, &profile, ask);
        aob_profile_finish(&profile);
    }
    aob_shelf_names_finish(&names);
}

static void ask_clock(struct aob_trial *trial, const struct aob_profile *profile,
                      const struct aob_model_input *input)
{
    struct aob_model_time slow = aob_model_pass(profile, input);
    struct aob_profile twice = *profile; /* borrows its texts */
    twice.rates.clock *= 2;
    twice.rates.alu_clock *= 2;
    twice.rates.memory *= 2;
    twice.rates.launch /= 2;
    struct aob_model_time fast = aob_model_pass(&twice, input);
    double off =
        aob_worse(fabs(2 * fast.ms / slow.ms - 1), aob_worse(fabs(2 * fast.low_ms / slow.low_ms - 1),
                                                             fabs(2 * fast.high_ms / slow.high_ms - 1)));
    aob_trial_take(trial, off, NULL, "%s: %.6g ms at one clock, %.6g ms at twice it", profile->name, slow.ms,
                   fast.ms);
}

void aob_ask_model_clock(struct aob_trial *trial)
{
    ask_profiles(trial, ask_clock);
}

/* The largest of three shares of time that more work saved. */
static double saved(const struct aob_model_time *less, const struct aob_model_time *more)
{
    return aob_over(aob_worse((less->ms - more->ms) / less->ms,
                              aob_worse((less->low_ms - more->low_ms) / less->low_ms,
                                        (less->high_ms - more->high_ms) / less->high_ms)));
}

static void ask_work(struct aob_trial *trial, const struct aob_profile *profile,
                     const struct aob_model_input *input)
{
    struct aob_model_time before = aob_model_pass(profile, input);
    for (int what = 0; what < 7; what++) {
        struct aob_model_input more = *input;
        double *numbers[] = {&more.operations.alu, &more.operations.special, &more.written,
                             &more.pixels,         &more.filled[0][0],       &more.filled[0][1]};
        if (what < 6)
            *numbers[what] *= 1.5;
        else {
            more.issue.least += more.issue.least / 2;
            more.issue.banked += more.issue.banked / 2;
            more.issue.most += more.issue.most / 2;
        }
        struct aob_model_time after = aob_model_pass(profile, &more);
        aob_trial_take(trial, saved(&before, &after), NULL,
                       "%s: kind of work %d: %.6g ms, %.6g ms with more of it", profile->name, what,
                       before.ms, after.ms);
    }
}

void aob_ask_model_work(struct aob_trial *trial)
{
    ask_profiles(trial, ask_work);
}

static void ask_resources(struct aob_trial *trial, const struct aob_profile *profile,
                          const struct aob_model_input *input)
{
    struct aob_model_time m = aob_model_pass(profile, input);
    double least = 0, sum = 0;
    for (int r = 0; r < AOB_RESOURCE_COUNT; r++) {
        least = aob_worse(least, m.resources[r]);
        sum += m.resources[r];
    }
    double under = aob_worse(least + m.launch_ms - m.ms, m.ms - sum - m.launch_ms);
    double outside = aob_worse(m.low_ms - m.ms, m.ms - m.high_ms);
    aob_trial_take(trial, aob_over(aob_worse(under, outside) / m.ms), NULL,
                   "%s: %.6g ms in %.6g .. %.6g, the longest resource %.6g, all %.6g", profile->name, m.ms,
                   m.low_ms, m.high_ms, least, sum);
}

void aob_ask_model_resources(struct aob_trial *trial)
{
    ask_profiles(trial, ask_resources);
}

/* The same pass with nothing left open: all of its bands at their lower ends, or at their upper ones. */
static struct aob_model_input at_end(const struct aob_model_input *input, bool upper)
{
    struct aob_model_input end = *input;
    uint64_t issued = upper ? input->issue.most : input->issue.least;
    end.issue = (struct aob_issue){issued, issued, issued};
    for (int l = 0; l < AOB_PROFILE_MAX_LEVEL; l++) {
        const double *f = input->filled[l];
        end.filled[l][0] = end.filled[l][1] = upper ? fmax(f[0], f[1]) : fmin(f[0], f[1]);
    }
    return end;
}

static void ask_ends(struct aob_trial *trial, const struct aob_profile *profile,
                     const struct aob_model_input *input)
{
    struct aob_model_time m = aob_model_pass(profile, input);
    struct aob_model_input least = at_end(input, false), most = at_end(input, true);
    double low = aob_model_pass(profile, &least).low_ms, high = aob_model_pass(profile, &most).high_ms;
    aob_trial_take(trial, aob_worse(fabs(m.low_ms / low - 1), fabs(m.high_ms / high - 1)), NULL,
                   "%s: %.6g .. %.6g ms, the ends are %.6g and %.6g", profile->name, m.low_ms, m.high_ms, low,
                   high);
}

void aob_ask_model_ends(struct aob_trial *trial)
{
    ask_profiles(trial, ask_ends);
}
