#include "budget/budget.h"
#include <math.h>
#include <string.h>
#include "base/json.h"
#include "base/text.h"
#include "budget_table.h"
#include "command.h"
#include "reports/page/answer_text.h"

struct options {
    struct aob_common common;
    const char *ms, *scene, *profile, *target, *error, *budget;
};

#define TEXT(name, value, field, help)                                                                       \
    {                                                                                                        \
        name, value, help, AOB_FLAG_TEXT, offsetof(struct options, field)                                    \
    }
static const struct aob_flag flags[] = {
    TEXT("ms", "X", ms, "milliseconds for ambient occlusion (the budget's)"),
    TEXT("budget", "NAME|FILE", budget,
         "a frame's budget: slice, resolution, device (that of the run's config)"),
    TEXT("scene", "S", scene, "only this scene"),
    TEXT("profile", "P", profile, "judge by time modelled on this device, not by what was measured"),
    TEXT("target", "R", target, "only the target of this radius, in scene units, or inf"),
    TEXT("error", "E", error, "name the cheapest case of this error, 0 .. 1, or less as well"),
    {0},
};

/* What the command works with. */
struct asking {
    const struct options *options;
    struct aob_budget budget; /* zero without one */
    struct aob_rows rows;
    struct aob_ask ask;
    struct aob_interval frame; /* G-buffer and composite */
};

static bool read_number(const char *flag, const char *text, double low, double high, double *value,
                        struct aob_error *error)
{
    double number;
    if (!text)
        return true;
    if (!aob_parse_double(text, &number) || !(number >= low && number <= high))
        return aob_fail(error, "--%s: '%s' is not a number from %g to %g", flag, text, low, high);
    *value = number;
    return true;
}

/* The one that is named, else that of the run's config. */
static bool read_budget(struct asking *asking, struct aob_error *error)
{
    if (asking->options->budget)
        return aob_budget_find(&asking->budget, asking->options->budget, error);
    aob_budget_from_json(&asking->budget, json_object_get(asking->rows.runs[0].info, "budget"));
    return true;
}

/* The budget first, then the flags, which stand in place of its words. */
static bool read_ask(struct asking *asking, struct aob_error *error)
{
    const struct options *o = asking->options;
    struct aob_ask *ask = &asking->ask;
    if (!read_budget(asking, error))
        return false;
    *ask = asking->budget.name ? aob_ask_of(&asking->budget)
                               : (struct aob_ask){.ms = NAN, .error = INFINITY, .radius = NAN};
    ask->scene = o->scene;
    if (o->profile)
        ask->profile = o->profile;
    asking->frame = aob_ask_frame(ask, &asking->rows);
    if (asking->budget.name)
        aob_ask_take_frame(ask, &asking->budget, &asking->frame);
    if (!read_number("ms", o->ms, 1e-6, 1e6, &ask->ms, error) ||
        !read_number("error", o->error, 0, 1, &ask->error, error) ||
        !read_number("target", o->target, 1e-6, INFINITY, &ask->radius, error))
        return false;
    return isfinite(ask->ms) ||
           aob_fail(error, "budget: say how much time there is, as --ms 2 or --budget NAME");
}

/* Whether some good row has what is asked for. */
static bool any_row(const struct asking *asking, bool (*has)(const struct aob_ask *, const struct aob_row *))
{
    bool any = false;
    for (size_t i = 0; i < asking->rows.count && !any; i++)
        any = aob_row_is_ok(&asking->rows.list[i]) && has(&asking->ask, &asking->rows.list[i]);
    return any;
}

static bool has_scene(const struct aob_ask *ask, const struct aob_row *row)
{
    return !ask->scene || strcmp(ask->scene, row->scene) == 0;
}

static bool has_size(const struct aob_ask *ask, const struct aob_row *row)
{
    return !ask->width || (ask->width == row->width && ask->height == row->height);
}

static bool has_cost(const struct aob_ask *ask, const struct aob_row *row)
{
    struct aob_interval cost =
        ask->profile ? aob_costs_modelled(row->json, ask->profile) : aob_costs_measured(row->json);
    return isfinite(cost.at);
}

static bool fail_cost(const struct asking *asking, const char *folder, struct aob_error *error)
{
    const char *profile = asking->ask.profile;
    if (!profile)
        return aob_fail(error, "%s: no case was timed: run it with measure: {time: true}, or give --profile",
                        folder);
    return aob_fail(
        error,
        "%s: no case has a time modelled on '%s': put measure: {cache: [%s]} into its config and run "
        "it again; the profile needs rates",
        folder, profile, profile);
}

static bool fail_target(const struct asking *asking, const char *folder, struct aob_error *error)
{
    struct aob_text known = {0};
    for (size_t i = 0; i < asking->rows.target_count; i++)
        aob_text_add(&known, "%s%g", i ? ", " : "", asking->rows.targets[i].radius);
    aob_fail(error, "%s: no case of these has an error against the target %g; the radii are %s", folder,
             asking->ask.radius, known.data ? known.data : "none");
    aob_text_finish(&known);
    return false;
}

/* Why nothing can be answered, of the flag that is to blame. */
static bool judge(const struct asking *asking, const struct aob_answer *answer, struct aob_error *error)
{
    const char *folder = asking->rows.runs[0].folder;
    const struct aob_ask *ask = &asking->ask;
    if (!any_row(asking, has_scene))
        return aob_fail(error, "%s: no good case of %s%s", folder, ask->scene ? "the scene " : "any scene",
                        ask->scene ? ask->scene : "");
    if (!any_row(asking, has_size))
        return aob_fail(error, "%s: no good case of %dx%d, which the budget '%s' is about", folder,
                        ask->width, ask->height, asking->budget.name);
    if (!any_row(asking, has_cost))
        return fail_cost(asking, folder, error);
    if (!asking->rows.target_count)
        return aob_fail(error, "%s: no case has an error: run it with measure: {error: true}", folder);
    return answer->view_count || fail_target(asking, folder, error);
}

static void print_budget(const struct asking *asking, struct aob_text *out)
{
    struct aob_text frame = {0};
    aob_text_add_line(out, "%s: %s (%s)", asking->budget.name, asking->budget.title, asking->budget.source);
    if (asking->options->ms) /* the slice itself, whatever the frame is */
        return;
    aob_answer_print_frame(&asking->ask, &asking->budget, &asking->frame, &frame);
    aob_text_add_line(out, "%s", frame.data);
    aob_text_finish(&frame);
}

static bool write_answer(struct asking *asking, const struct aob_answer *answer, struct aob_text *out,
                         struct aob_error *error)
{
    const struct aob_common *common = &asking->options->common;
    if (aob_common_speaks(common)) {
        if (asking->budget.name)
            print_budget(asking, out);
        aob_budget_table_print(answer, out);
    }
    if (!common->json)
        return true;
    json_t *document = aob_budget_answer_to_json(answer);
    json_object_set_new(document, "run", aob_json_text(asking->rows.runs[0].folder));
    json_object_set_new(document, "frame_ms", aob_interval_to_json(&asking->frame));
    json_object_set_new(document, "budget",
                        asking->budget.name ? aob_budget_to_json(&asking->budget) : json_null());
    bool ok = aob_json_write(document, common->json, error);
    json_decref(document);
    return ok;
}

/* A plan that is not known may be incomplete. */
static bool is_whole(const struct aob_rows *rows)
{
    size_t ok = 0;
    for (size_t i = 0; i < rows->count; i++)
        ok += aob_row_is_ok(&rows->list[i]);
    return rows->runs[0].planned && ok >= rows->runs[0].planned;
}

static enum aob_exit answer_all(struct asking *asking, struct aob_text *out, struct aob_error *error)
{
    struct aob_answer answer;
    aob_answer_make(&answer, &asking->rows, &asking->ask);
    bool ok = judge(asking, &answer, error) && write_answer(asking, &answer, out, error);
    enum aob_exit code = !ok                         ? AOB_EXIT_USAGE
                         : !aob_answer_fits(&answer) ? AOB_EXIT_BAD
                         : !is_whole(&asking->rows)  ? AOB_EXIT_PART
                                                     : AOB_EXIT_OK;
    aob_answer_finish(&answer);
    return code;
}

/* What an answer needs, and rows to be one. Most of a record is something else, and parsing it would take most of the
 * time. */
static const char *const needed[] = {
    "key",
    "scene",
    "view",
    "technique",
    "module",
    "params",
    "options",
    "metre",
    "backend",
    "width",
    "height",
    "status",
    "reference_radius",
    "errors.target",
    "errors.reference",
    "errors.rmse",
    "errors.band_rmse",
    "error.target",
    "error.reference",
    "error.rmse",
    "error.band_rmse",
    "time.clock",
    "time.cpu_ms",
    "time.wall_ms",
    "time.device_ms",
    "time.ratio_to_ref",
    "time.ci_low",
    "time.ci_high",
    "time.passes.name",
    "time.passes.cpu_ms",
    "time.passes.wall_ms",
    "time.passes.device_ms",
    "cache.*.modelled.frame.ms",
    "cache.*.modelled.frame.low_ms",
    "cache.*.modelled.frame.high_ms",
    "cache.*.modelled.passes.name",
    "cache.*.modelled.passes.ms",
    "cache.*.modelled.passes.limit",
    NULL,
};

static enum aob_exit budget(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct asking asking = {.options = o};
    const char *folder = o->common.words.items[0];
    enum aob_exit code = AOB_EXIT_USAGE;
    if (!aob_rows_read_only(&asking.rows, folder, needed, error))
        return code;
    if (*aob_rows_damage(&asking.rows))
        aob_warn("%s", aob_rows_damage(&asking.rows));
    if (read_ask(&asking, error))
        code = answer_all(&asking, &o->common.out, error);
    aob_rows_finish(&asking.rows);
    aob_budget_finish(&asking.budget);
    return code;
}

const struct aob_command aob_command_budget = {
    .name = "budget",
    .help = "which case fits a frame's budget of milliseconds",
    .usage = "DIR --ms X [--budget NAME|FILE] [--scene S] [--profile P] [--target R] [--error E]",
    .summary =
        "Of each scene, view and target the most accurate case that fits, and of all the setting that does.",
    .flags = flags,
    .least = 1,
    .most = 1,
    .size = sizeof(struct options),
    .run = budget,
};
