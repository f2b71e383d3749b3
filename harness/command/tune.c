#include "tune/tune.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "command.h"
#include "effects/work_folder.h"
#include "run/progress.h"
#include "single.h"
#include "tune/report.h"
#include "tune/written.h"

struct options {
    struct aob_common common;
    const char *config, *params, *target, *budget_ms, *held_out, *out;
};

static const struct aob_flag flags[] = {
    AOB_FLAG_OF(struct options, config, "config", "C.yaml",
                "whose views, size, rays and target are fitted to"),
    AOB_FLAG_OF(struct options, params, "params", "a,b", "what is fitted (the floats that shape the image)"),
    AOB_FLAG_OF(struct options, target, "target", "R",
                "radius of the truth, scene units, or inf (the config's)"),
    AOB_FLAG_OF(struct options, budget_ms, "budget-ms", "X", "milliseconds that a frame may take"),
    AOB_FLAG_OF(struct options, held_out, "held-out", "SCENES", "scene,scene/view: scored and never fitted"),
    AOB_FLAG_OF(struct options, out, "out", "FILE.yaml", "the config that is written (beside C, C-T.yaml)"),
    {0},
};

/* Where the work stands has no number, as searches end when they are done. */
static void show(void *user, const char *work)
{
    aob_progress_say(user, work);
}

/* What was found is told even where it cannot be written. */
static bool tell(struct options *o, const struct aob_tune_desc *desc, const struct aob_tune *tune,
                 const char *out, struct aob_error *error)
{
    const bool chosen = tune->chosen != AOB_NO_CANDIDATE;
    bool ok = !chosen || aob_tune_written_save(desc, tune, out, error);
    if (chosen && aob_common_speaks(&o->common)) {
        aob_tune_print(tune, &o->common.out);
        if (ok)
            aob_text_add_line(&o->common.out, "config: %s", out);
    }
    json_t *document = o->common.json ? aob_tune_to_json(desc, tune, chosen && ok ? out : NULL) : NULL;
    ok = (!document || aob_json_write(document, o->common.json, ok ? error : NULL)) && ok;
    json_decref(document);
    if (ok && !chosen)
        aob_fail(
            error,
            "--budget-ms: nothing of %s fits %g ms: the cheapest of its settings takes up to %.3g ms %s a "
            "fit; allow more, or give the config fewer samples or a smaller size",
            desc->technique, desc->budget_ms, tune->cheapest_ms, tune->unfitted ? "without" : "with");
    return ok;
}

static bool lacks(const struct aob_tune *tune)
{
    for (size_t v = 0; v < tune->view_count; v++)
        for (int side = 0; side < AOB_TUNE_SIDES; side++)
            if (*tune->settings[tune->chosen].figures[v][side].reason)
                return true;
    return false;
}

static enum aob_exit fit(struct options *o, struct aob_tune_desc *desc, const char *out,
                         struct aob_error *error)
{
    struct aob_tune tune;
    struct aob_work_folder folder;
    struct aob_progress progress;
    if (!aob_work_folder_create(&folder, error))
        return AOB_EXIT_USAGE;
    aob_progress_init(&progress, 1, o->common.quiet);
    desc->folder = folder.path;
    desc->on_work = show;
    desc->user = &progress;
    bool ok = aob_tune_run(desc, &tune, error);
    aob_progress_finish(&progress);
    ok = ok && tell(o, desc, &tune, out, error);
    enum aob_exit code = !ok                               ? AOB_EXIT_USAGE
                         : tune.chosen == AOB_NO_CANDIDATE ? AOB_EXIT_BAD
                         : lacks(&tune)                    ? AOB_EXIT_PART
                                                           : AOB_EXIT_OK;
    aob_tune_finish(&tune);
    aob_work_folder_remove(&folder);
    return code;
}

static enum aob_exit tune(void *from, struct aob_error *error)
{
    struct options *o = from;
    struct aob_tune_desc desc = {.dispatch = &o->common.dispatch,
                                 .technique = o->common.words.items[0],
                                 .config = o->config,
                                 .params = o->params,
                                 .target = o->target,
                                 .held_out = o->held_out,
                                 .budget_ms = INFINITY};
    if (!o->config) {
        aob_fail(error, "tune: --config C.yaml is missing: the views that are fitted to");
        return AOB_EXIT_USAGE;
    }
    char *out = o->out ? NULL : aob_tune_written_path(o->config, desc.technique);
    const char *path = out ? out : o->out;
    bool ok = aob_single_number("budget-ms", o->budget_ms, 1e-6, 1e6, &desc.budget_ms, error) &&
              aob_json_check(o->common.json, error) && aob_tune_written_check(&desc, path, error);
    enum aob_exit code = ok ? fit(o, &desc, path, error) : AOB_EXIT_USAGE;
    free(out);
    return code;
}

const struct aob_command aob_command_tune = {
    .name = "tune",
    .help = "a technique's free parameters fitted to the truth of one target",
    .usage = "TECHNIQUE --config C.yaml [--params a,b] [--target R] [--held-out SCENES] [--budget-ms X] "
             "[--out FILE.yaml] [--device NAME|N] [--module FILE.so]",
    .summary =
        "Fits the free parameters of a technique to the ray-traced truth on the views of a config, says what "
        "that gains on views which no fit has seen, and writes a config with both.",
    .flags = flags,
    .modules = true,
    .devices = true,
    .least = 1,
    .most = 1,
    .size = sizeof(struct options),
    .run = tune,
};
