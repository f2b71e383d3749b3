#include "effects/effects.h"
#include <math.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "command.h"
#include "effects/pictures.h"
#include "effects/report.h"
#include "effects/work_folder.h"
#include "effects_scene.h"
#include "reports/page/effects_page.h"
#include "run/progress.h"

struct options {
    struct aob_common common;
    struct aob_single_flags frame;
    const char *budget_ms, *tolerance, *profile, *radius, *spp, *out, *page;
};

static const struct aob_flag flags[] = {
    AOB_FLAG_OF(struct options, tolerance, "tolerance", "E",
                "how much farther off than the best set the lit image may be, 0 .. 1 (0.02)"),
    AOB_FLAG_OF(struct options, budget_ms, "budget-ms", "X", "milliseconds that a frame may take"),
    AOB_FLAG_OF(struct options, profile, "profile", "P", "judge by time modelled on this device"),
    AOB_FLAG_OF(struct options, radius, "radius", "R",
                "how far occlusion reaches, scene units (the technique's)"),
    AOB_FLAG_OF(struct options, spp, "reference-spp", "N", "rays a pixel of the lit truth (by the size)"),
    AOB_FLAG_OF(struct options, out, "out", "FILE.yaml", "a config of the chosen set, ready for `run`"),
    AOB_FLAG_OF(struct options, page, "page", "DIR",
                "a page of what each effect adds and costs, with pictures"),
    AOB_VIEW_FLAGS(struct options, frame),
    {0},
};

static bool make(void *user, struct aob_config *config, struct aob_error *error)
{
    const struct options *o = user;
    struct aob_technique_choice *technique;
    if (!aob_single_config("effects", &o->frame, config, error))
        return false;
    technique = &config->techniques[0];
    if (o->radius)
        aob_axis_add(&technique->axes, &technique->axis_count, &technique->axis_capacity, "radius",
                     o->radius);
    return true;
}

static bool read_ask(const struct options *o, struct aob_effects_desc *desc, struct aob_error *error)
{
    double spp = 0, radius = 1;
    desc->ask = (struct aob_effect_ask){NAN, INFINITY, o->profile};
    if (!aob_single_number("tolerance", o->tolerance, 0, 1, &desc->ask.tolerance, error) ||
        !aob_single_number("budget-ms", o->budget_ms, 1e-6, 1e6, &desc->ask.budget_ms, error) ||
        !aob_single_number("radius", o->radius, 1e-6, 1e6, &radius, error) ||
        !aob_single_number("reference-spp", o->spp, 2, 65536, &spp, error))
        return false;
    desc->spp = (int)spp;
    return (spp == floor(spp) && fmod(spp, 2) == 0) ||
           aob_fail(error, "--reference-spp: %s is not an even whole number", o->spp);
}

static bool check_outputs(const struct options *o, struct aob_error *error)
{
    return aob_json_check(o->common.json, error) && (!o->out || aob_file_check(o->out, error)) &&
           (!o->page || aob_folder_create(o->page, error));
}

static bool check_backend(const struct options *o, struct aob_error *error)
{
    const char *backend = o->frame.backend;
    return !backend || strcmp(backend, "null") != 0 ||
           aob_fail(error, "effects: the backend null draws nothing; see: aobudget list backends");
}

static bool write_config(const struct options *o, const struct aob_effects *effects, struct aob_error *error)
{
    struct aob_text scene = {0}, text = {0};
    if (!o->out || effects->answer.chosen < 0)
        return true;
    unsigned set = effects->answer.candidates[effects->answer.chosen].set;
    aob_effects_scene_print(&o->frame, aob_effect_has(set, AOB_EFFECT_TEMPORAL) ? AOB_EFFECT_HISTORY : 0,
                            &scene);
    aob_effects_write_config(effects, scene.data, &text);
    bool ok = aob_file_write(o->out, text.data, text.size, error);
    aob_text_finish(&scene);
    aob_text_finish(&text);
    return ok;
}

static bool write_page(struct options *o, const struct aob_effects *effects, json_t *document,
                       struct aob_error *error)
{
    const struct aob_effects_page_desc page = {document, o->page, o->common.dispatch.program};
    if (!aob_effects_draw(effects, o->page, document, error) || !aob_effects_page_write(&page, error))
        return false;
    if (aob_common_speaks(&o->common))
        aob_text_add_line(&o->common.out, "page: %s/index.html", o->page);
    return true;
}

static bool tell(struct options *o, const struct aob_effects *effects, struct aob_error *error)
{
    if (aob_common_speaks(&o->common))
        aob_effects_print(effects, &o->common.out);
    json_t *document = aob_effects_to_json(effects);
    bool ok = (!o->page || write_page(o, effects, document, error)) &&
              (!o->common.json || aob_json_write(document, o->common.json, error));
    json_decref(document);
    return ok;
}

/* At most: a truth, images, those of a mean, flicker, times; a frame of full size may be timed behind them. */
enum { STEPS = 5 };

static void show(void *user, const char *work)
{
    struct aob_progress *progress = user;
    aob_progress_say(progress, work);
    progress->done += progress->done < STEPS;
}

static enum aob_exit plan(struct options *o, struct aob_effects_desc *desc, struct aob_error *error)
{
    struct aob_effects effects = {0};
    struct aob_work_folder folder;
    if (!aob_work_folder_create(&folder, error))
        return AOB_EXIT_USAGE;
    struct aob_progress progress;
    aob_progress_init(&progress, STEPS, o->common.quiet);
    desc->folder = folder.path;
    desc->on_work = show;
    desc->user = &progress;
    bool ok = aob_effects_plan(desc, &effects, error);
    aob_progress_finish(&progress);
    ok = ok && write_config(o, &effects, error) && tell(o, &effects, error);
    enum aob_exit code = !ok                         ? AOB_EXIT_USAGE
                         : effects.answer.chosen < 0 ? AOB_EXIT_BAD
                         : effects.answer.lacks      ? AOB_EXIT_PART
                                                     : AOB_EXIT_OK;
    aob_effects_finish(&effects);
    aob_work_folder_remove(&folder);
    return code;
}

static enum aob_exit effects(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_effects_desc desc = {.dispatch = &o->common.dispatch, .maker = {make, o}};
    o->frame.technique = "gtao";
    o->frame.scene = o->common.words.items[0];
    bool ok = check_outputs(o, error) && read_ask(o, &desc, error) && check_backend(o, error);
    enum aob_exit code = ok ? plan(o, &desc, error) : AOB_EXIT_USAGE;
    aob_words_finish(&o->frame.params);
    return code;
}

const struct aob_command aob_command_effects = {
    .name = "effects",
    .help = "which effects the lit image of a scene calls for",
    .usage = "SCENE [--view V] [--budget-ms X] [--tolerance E] [--profile P] [--out FILE.yaml] [--page DIR] "
             "[flags]",
    .summary =
        "Which effects the lit image of a view calls for, what each costs and gives, and the set to take.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .least = 1,
    .most = 1,
    .size = sizeof(struct options),
    .run = effects,
};
