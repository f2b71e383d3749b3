#include "final.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "plan/block.h"
#include "run/measurement.h"
#include "technique/param.h"

/* A measurement while it goes on. */
struct final {
    const struct aob_tune_desc *desc;
    const struct aob_tune_final_desc *wish;
    struct aob_tune *tune;
    struct aob_sweep sweep;
    struct aob_measurement measurement;
};

/* Whether the case has what the entry says, and the table's values for the rest. Two sides may be one case, where a fit moves nothing. */
static bool is_of(const struct aob_case *c, const struct aob_technique_choice *entry)
{
    double values[AOB_MAX_PARAM];
    const struct aob_technique_info *technique = c->technique;
    aob_param_defaults(technique->params, technique->param_count, c->scene->metre, values);
    for (size_t i = 0; i < entry->axis_count; i++) {
        const struct aob_param *param =
            aob_param_find(technique->params, technique->param_count, entry->axes[i].name);
        if (!param ||
            !aob_param_parse(param, entry->axes[i].values[0].text, &values[param - technique->params], NULL))
            return false;
    }
    for (size_t i = 0; i < technique->param_count; i++)
        if ((float)values[i] != (float)c->params[i])
            return false;
    return true;
}

static void keep(struct aob_tune_figures *figures, const json_t *record)
{
    const json_t *time = json_object_get(record, "time");
    const char *reason = json_string_value(json_object_get(record, "reason")),
               *status = json_string_value(json_object_get(record, "status"));
    double ref = aob_json_to_number(json_object_get(time, "ref_ms"));
    const json_t *error = json_array_get(json_object_get(record, "errors"), 0);
    figures->error = aob_json_to_number(json_object_get(error, "band_rmse"));
    figures->ratio = aob_json_to_number(json_object_get(time, "ratio_to_ref"));
    figures->ms = figures->ratio * ref;
    figures->low = aob_json_to_number(json_object_get(time, "ci_low")) * ref;
    figures->high = aob_json_to_number(json_object_get(time, "ci_high")) * ref;
    if (strcmp(status, "ok") != 0)
        aob_line_print(figures->reason, sizeof figures->reason, "%s: %s", status,
                       reason ? reason : "no reason given");
}

static void put(struct final *final, const struct aob_case *c, const json_t *record, const char *reason)
{
    size_t view = (size_t)(c->scene - final->sweep.plan.scenes);
    for (size_t s = 0; s < final->tune->setting_count; s++)
        for (int side = 0; side < AOB_TUNE_SIDES; side++) {
            struct aob_tune_setting *setting = &final->tune->settings[s];
            struct aob_tune_figures *figures = &setting->figures[view][side];
            struct aob_technique_choice entry;
            aob_tune_setting_entry(setting, final->tune->technique, (enum aob_tune_side)side,
                                   final->tune->target.radius, &entry);
            if (final->wish->sides[side] && !setting->dear && is_of(c, &entry)) {
                if (record)
                    keep(figures, record);
                else
                    aob_line_print(figures->reason, sizeof figures->reason, "%s", reason);
            }
            aob_technique_choice_finish(&entry);
        }
}

static void take(void *user, size_t index, json_t *record)
{
    struct final *final = user;
    put(final, &final->sweep.plan.cases[index], record, NULL);
}

static void clear(const struct final *final)
{
    for (size_t s = 0; s < final->tune->setting_count; s++)
        for (size_t v = 0; v < final->tune->view_count; v++)
            for (int side = 0; side < AOB_TUNE_SIDES; side++)
                final->tune->settings[s].figures[v][side] =
                    (struct aob_tune_figures){NAN, NAN, NAN, NAN, NAN, ""};
}

static void say_work(void *user, size_t index, const char *work)
{
    const struct final *final = user;
    struct aob_text text = {0};
    aob_text_add(&text, "%s: ", work);
    aob_case_describe(&final->sweep.plan, &final->sweep.plan.cases[index], &text);
    if (final->desc->on_work)
        final->desc->on_work(final->desc->user, text.data);
    aob_text_finish(&text);
}

static void measure_blocks(struct final *final)
{
    struct aob_measurement *m = &final->measurement;
    const struct aob_plan *plan = &final->sweep.plan;
    size_t indices[AOB_BLOCK_MAX];
    bool *wanted = AOB_NEW_ARRAY(bool, plan->case_count);
    for (size_t i = 0; i < plan->case_count; i++) {
        size_t view = (size_t)(plan->cases[i].scene - plan->scenes);
        wanted[i] = final->wish->held_out || !final->tune->views[view].held_out;
        if (m->states[i].stage == AOB_REFUSED)
            put(final, &plan->cases[i], NULL, m->states[i].reason);
        wanted[i] = wanted[i] && m->states[i].stage == AOB_PENDING;
    }
    for (size_t at = 0; at < plan->case_count;) {
        size_t used = aob_plan_next_block(plan, wanted, &at, indices);
        if (used)
            say_work(final, indices[0], final->wish->error ? "measuring" : "timing");
        if (used)
            aob_measurement_block(m, indices, used);
    }
    free(wanted);
}

static bool measure(struct final *final, struct aob_error *error)
{
    struct aob_measurement *m = &final->measurement;
    if (!aob_measurement_init(m, final->desc->dispatch, &final->sweep.plan, error))
        return false;
    m->shaders = final->desc->folder;
    m->on_work = say_work;
    m->on_record = take;
    m->user = final;
    aob_measurement_layout(m);
    clear(final);
    measure_blocks(final);
    return true;
}

bool aob_tune_final_measure(const struct aob_tune_desc *desc, struct aob_tune *tune,
                            const struct aob_tune_final_desc *wish, struct aob_error *error)
{
    struct final final = {.desc = desc, .tune = tune, .wish = wish};
    const struct aob_tune_shape shape = {.settings = tune->settings,
                                         .count = tune->setting_count,
                                         .sides = {wish->sides[0], wish->sides[1]},
                                         .divisor = 1,
                                         .spp = INT_MAX,
                                         .time = true,
                                         .error = wish->error};
    bool ok = aob_tune_shape_expand(desc, tune, &shape, &final.sweep, error) && measure(&final, error);
    aob_measurement_finish(&final.measurement);
    aob_sweep_finish(&final.sweep);
    return ok;
}
