#include "tune.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "final.h"
#include "shape.h"
#include "stage.h"

/* That of the command line, with the weighting of the config's target of that radius where it has one; else the config's only one. */
static bool choose_target(const struct aob_tune_desc *desc, struct aob_tune *tune, struct aob_error *error)
{
    struct aob_config *config = &tune->look.config;
    struct aob_target own[AOB_CONFIG_MAX_TARGETS];
    const size_t count = config->target_count;
    if (!desc->target && count != 1)
        return aob_fail(error,
                        count ? "%s: it has %zu targets, and a fit is to one: choose it with --target R"
                              : "%s: it has no target: write `target: {radius: R}` into it, or give "
                                "--target R",
                        config->path, count);
    if (count)
        memcpy(own, config->targets, count * sizeof *own);
    if (desc->target) {
        config->target_count = 0;
        if (!aob_config_add_targets(config, desc->target, "cosine", error))
            return aob_fail_in(error, "--target");
        if (config->target_count != 1)
            return aob_fail(error, "--target: a fit is to one radius, and '%s' are %zu", desc->target,
                            config->target_count);
    }
    tune->target = config->targets[0];
    for (size_t i = 0; i < count; i++)
        if (own[i].radius == tune->target.radius)
            tune->target.uniform = own[i].uniform;
    config->targets[0] = tune->target;
    return true;
}

static bool judge_plan(const struct aob_tune *tune, struct aob_error *error)
{
    const struct aob_plan *plan = &tune->look.plan;
    if (strcmp(tune->backend, "null") == 0)
        return aob_fail(error, "the backend null draws nothing: see aobudget list backends");
    for (size_t i = 0; i < plan->case_count; i++)
        if (plan->cases[i].technique != tune->technique)
            return aob_fail(error, "%s has two builds of '%s', and a fit is of one: leave one out",
                            tune->look.config.path, tune->technique->name);
    return true;
}

static void name_views(struct aob_tune *tune, const bool *held)
{
    const struct aob_plan *plan = &tune->look.plan;
    tune->view_count = plan->scene_count;
    tune->views = AOB_NEW_ARRAY(struct aob_tune_shown, plan->scene_count);
    for (size_t v = 0; v < plan->scene_count; v++) {
        struct aob_text text = {0};
        aob_text_add(&text, "%s/%s", plan->scenes[v].name, plan->scenes[v].view);
        tune->views[v] = (struct aob_tune_shown){text.data, held[v]};
    }
}

/* What is wrong with what was asked for is known before anything is traced. */
static bool look(const struct aob_tune_desc *desc, struct aob_tune *tune, struct aob_error *error)
{
    struct aob_sweep *sweep = &tune->look;
    bool *held = NULL, ok = aob_tune_shape_read(desc, &sweep->config, &held, error) &&
                            choose_target(desc, tune, error) &&
                            aob_sweep_expand(sweep, desc->dispatch, error);
    if (ok) {
        const struct aob_case *first = &sweep->plan.cases[0];
        struct aob_tune_setting whole = {.value_count = 0};
        tune->technique = first->technique;
        tune->backend = first->backend;
        tune->width = first->width;
        tune->height = first->height;
        tune->spp = sweep->config.spp;
        name_views(tune, held);
        ok = judge_plan(tune, error) && aob_tune_stage_axes(desc, first, &whole, error);
    }
    free(held);
    return ok && aob_tune_settings_create(&(struct aob_settings_desc){.config = &sweep->config,
                                                                      .technique = tune->technique,
                                                                      .params = desc->params,
                                                                      .view_count = tune->view_count},
                                          &tune->settings, &tune->setting_count, error);
}

/* Its dearest view counts. A side that is not timed at all is free where there is no budget. */
static struct aob_candidate candidate_of(const struct aob_tune *tune, size_t at, enum aob_tune_side side)
{
    const struct aob_tune_setting *setting = &tune->settings[at];
    struct aob_candidate worst = {.of = at, .setting = at};
    for (size_t v = 0; v < tune->view_count; v++) {
        const struct aob_tune_figures *f = &setting->figures[v][side];
        worst.ms = fmax(worst.ms, f->ms);
        worst.low = fmax(worst.low, f->low);
        worst.high = fmax(worst.high, f->high);
    }
    return worst;
}

static void leave_out_dear(const struct aob_tune_desc *desc, struct aob_tune *tune)
{
    tune->unfitted = true;
    tune->cheapest_ms = INFINITY;
    for (size_t s = 0; s < tune->setting_count; s++) {
        const struct aob_candidate cost = candidate_of(tune, s, AOB_TUNE_DEFAULT);
        tune->settings[s].dear = aob_candidate_fit(&cost, desc->budget_ms) != AOB_FIT_WHOLE;
        tune->unfitted = tune->unfitted && tune->settings[s].dear;
        tune->cheapest_ms = fmin(tune->cheapest_ms, cost.high);
    }
}

static bool fail_reason(const struct aob_tune *tune, struct aob_error *error)
{
    for (size_t s = 0; s < tune->setting_count; s++)
        for (size_t v = 0; v < tune->view_count; v++)
            for (int side = 0; side < AOB_TUNE_SIDES; side++)
                if (*tune->settings[s].figures[v][side].reason)
                    return aob_fail(error, "%s on %s: %s", tune->technique->name, tune->views[v].name,
                                    tune->settings[s].figures[v][side].reason);
    return aob_fail(error, "%s: nothing was measured of it", tune->technique->name);
}

static bool is_timed(const struct aob_tune *tune)
{
    for (size_t s = 0; s < tune->setting_count; s++)
        if (candidate_of(tune, s, AOB_TUNE_DEFAULT).high > 0)
            return true;
    return false;
}

static bool choose_affordable(const struct aob_tune_desc *desc, struct aob_tune *tune,
                              struct aob_error *error)
{
    const struct aob_tune_final_desc times = {.sides = {[AOB_TUNE_DEFAULT] = true}};
    if (isinf(desc->budget_ms))
        return true;
    if (!aob_tune_final_measure(desc, tune, &times, error))
        return false;
    leave_out_dear(desc, tune);
    return is_timed(tune) || fail_reason(tune, error);
}

static bool fit(const struct aob_tune_desc *desc, struct aob_tune *tune, struct aob_error *error)
{
    for (size_t s = 0; s < tune->setting_count; s++)
        if (!tune->settings[s].dear &&
            (!aob_tune_stage_run(desc, tune, AOB_TUNE_SMALL, &tune->settings[s], error) ||
             !aob_tune_stage_run(desc, tune, AOB_TUNE_FULL, &tune->settings[s], error)))
            return false;
    return true;
}

static bool choose(const struct aob_tune_desc *desc, struct aob_tune *tune, struct aob_error *error)
{
    struct aob_candidate list[AOB_TUNE_MAX_SETTINGS];
    struct aob_choice choice;
    size_t count = 0;
    for (size_t s = 0; s < tune->setting_count; s++) {
        struct aob_candidate candidate = candidate_of(tune, s, AOB_TUNE_FITTED);
        candidate.error =
            aob_tune_setting_mean(&tune->settings[s], tune->views, tune->view_count, false, AOB_TUNE_FITTED);
        if (!isnan(candidate.error) && !tune->settings[s].dear)
            list[count++] = candidate;
    }
    if (!count)
        return fail_reason(tune, error);
    aob_choice_make(&choice, list, count, desc->budget_ms, INFINITY);
    tune->chosen = choice.accurate == AOB_NO_CANDIDATE ? AOB_NO_CANDIDATE : list[choice.accurate].of;
    tune->cheapest_ms = list[choice.least].high;
    return true;
}

bool aob_tune_run(const struct aob_tune_desc *desc, struct aob_tune *tune, struct aob_error *error)
{
    const struct aob_tune_final_desc both = {.sides = {true, true}, .error = true, .held_out = true};
    *tune = (struct aob_tune){.chosen = AOB_NO_CANDIDATE};
    if (!look(desc, tune, error) || !choose_affordable(desc, tune, error))
        return false;
    if (tune->unfitted)
        return true;
    return fit(desc, tune, error) && aob_tune_final_measure(desc, tune, &both, error) &&
           choose(desc, tune, error);
}

void aob_tune_finish(struct aob_tune *tune)
{
    for (size_t v = 0; v < tune->view_count; v++)
        free(tune->views[v].name);
    free(tune->views);
    aob_tune_settings_destroy(tune->settings, tune->setting_count);
    aob_sweep_finish(&tune->look);
    *tune = (struct aob_tune){.chosen = AOB_NO_CANDIDATE};
}
