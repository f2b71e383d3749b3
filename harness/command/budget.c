#include "budget/budget.h"
#include <math.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"
#include "base/shelf.h"
#include "base/text.h"
#include "budget_reason.h"
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
    char *profile; /* of --profile, as records call it; NULL without */
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

static bool refuse_empty(const char *flag, const char *text, struct aob_error *error)
{
    return !text || *text || aob_fail(error, "--%s: is empty", flag);
}

static bool read_texts(struct asking *asking, struct aob_error *error)
{
    const struct options *o = asking->options;
    if (!refuse_empty("scene", o->scene, error) || !refuse_empty("profile", o->profile, error))
        return false;
    asking->ask.scene = o->scene;
    if (o->profile)
        asking->ask.profile = asking->profile =
            aob_shelf_is_path(o->profile) ? aob_shelf_name(o->profile) : aob_strdup(o->profile);
    return true;
}

/* The slice itself, whatever the frame is. */
static bool read_slice(struct asking *asking, struct aob_error *error)
{
    struct aob_ask *ask = &asking->ask;
    if (!asking->options->ms)
        return ask->budget ||
               aob_fail(error, "budget: say how much time there is, as --ms 2 or --budget NAME");
    ask->budget = NULL;
    return read_number("ms", asking->options->ms, 1e-6, 1e6, &ask->ms, error);
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
    return read_texts(asking, error) && read_slice(asking, error) &&
           read_number("error", o->error, 0, 1, &ask->error, error) &&
           read_number("target", o->target, 1e-6, INFINITY, &ask->radius, error);
}

static void print_budget(const struct asking *asking, const struct aob_answer *answer, struct aob_text *out)
{
    aob_text_add_line(out, "%s: %s (%s)", asking->budget.name, asking->budget.title, asking->budget.source);
    for (size_t i = 0; i < answer->frame_count && asking->ask.budget; i++) {
        struct aob_text frame = {0};
        aob_answer_print_frame(answer, &answer->frames[i], &frame);
        aob_text_add_line(out, "%s", frame.data);
        aob_text_finish(&frame);
    }
}

static bool write_answer(struct asking *asking, const struct aob_answer *answer, struct aob_text *out,
                         struct aob_error *error)
{
    const struct aob_common *common = &asking->options->common;
    if (aob_common_speaks(common)) {
        if (asking->budget.name)
            print_budget(asking, answer, out);
        aob_budget_table_print(answer, out);
    }
    if (!common->json)
        return true;
    json_t *document = aob_budget_answer_to_json(answer);
    json_object_set_new(document, "run", aob_json_text(asking->rows.runs[0].folder));
    json_object_set_new(document, "budget",
                        asking->budget.name ? aob_budget_to_json(&asking->budget) : json_null());
    bool ok = aob_json_write(document, common->json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit answer_all(struct asking *asking, struct aob_text *out, struct aob_error *error)
{
    struct aob_answer answer;
    aob_answer_make(&answer, &asking->rows, &asking->ask);
    bool ok =
        aob_budget_judge(&asking->rows, &asking->ask, error) && write_answer(asking, &answer, out, error);
    bool all = aob_answer_is_known(&answer) && aob_answer_is_whole(&answer);
    enum aob_exit code = !ok                         ? AOB_EXIT_USAGE
                         : !aob_answer_fits(&answer) ? AOB_EXIT_BAD
                         : !all                      ? AOB_EXIT_PART
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
    free(asking.profile);
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
