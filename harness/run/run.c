#include "run.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "again.h"
#include "best.h"
#include "cache_case.h"
#include "config/config_builds.h"
#include "info.h"
#include "measurement.h"
#include "plan/block.h"
#include "progress.h"
#include "record.h"
#include "reports/page/page.h"
#include "run_effects.h"
#include "run_part.h"
#include "store/run_folder.h"
#include "stored.h"

/* One run, from its config to its page. */
struct run {
    const struct aob_run_desc *desc;
    struct aob_sweep sweep;
    struct aob_measurement measurement;
    struct aob_run_folder folder;
    struct aob_progress progress;
    struct aob_best best;  /* against the budget */
    bool has_page;         /* the run before in this folder has drawn it, with this budget */
    json_t *info;          /* what run.json says (info.h); at the end with the seconds */
    size_t stored;         /* records of this time */
    size_t counts[4];      /* by status, in status_names' order, of the cases in this run's plan */
    size_t imprecise;      /* of them, those whose time is less precise than was wanted, */
    size_t foretold;       /* of those, the ones for which some seconds would do, */
    double seconds_needed; /* and what the worst of these would need */
    struct aob_error store_error;
    int64_t start_ns;
};
static const char *const status_names[4] = {"ok", "unsupported", "invalid", "failed"};

static bool read_config(struct run *run, struct aob_error *error)
{
    const struct aob_run_desc *desc = run->desc;
    struct aob_config *config = &run->sweep.config;
    if (!(desc->again ? aob_run_again_read(desc->again, desc->config, config, error)
                      : aob_config_read(config, desc->config, error)) ||
        (desc->builds && !aob_config_take_builds(config, desc->builds, error)) ||
        (desc->shard.count && !aob_run_part_judge(desc, config, error)))
        return false;
    for (size_t i = 0; i < config->size_count; i++)
        if (desc->max_width && config->sizes[i].width > desc->max_width)
            config->sizes[i].width = desc->max_width;
    if (desc->seconds > 0)
        config->seconds = desc->seconds;
    config->processes = desc->processes;
    if (desc->builds || desc->again)
        aob_config_leave_unshown(config);
    if (desc->precision > 0)
        config->precision = desc->precision;
    if (desc->max_spp && config->spp > desc->max_spp)
        config->spp = desc->max_spp;
    return true;
}

static bool describe(struct run *run, struct aob_error *error)
{
    run->info = aob_run_info_create(&run->sweep, &run->desc->dispatch, error);
    return run->info;
}

static bool open_folder(struct run *run, struct aob_error *error)
{
    char *path = aob_run_path(run->desc, &run->sweep.config);
    /* The document may go there too; an earlier run is discarded only when it can be written. */
    const struct aob_config *config = &run->sweep.config;
    run->has_page = aob_run_info_has_page(run->info, path);
    bool ok = aob_folder_create(path, error) && aob_json_check(run->desc->json, error) &&
              aob_run_folder_open(&run->folder, path, run->info, run->desc->fresh, error) &&
              aob_run_folder_keep_config(&run->folder, config->text, config->size, error);
    free(path);
    return ok;
}

static void count(struct run *run, const json_t *record)
{
    const char *status = json_string_value(json_object_get(record, "status"));
    for (size_t i = 0; status && i < AOB_COUNT(status_names); i++)
        run->counts[i] += strcmp(status, status_names[i]) == 0;
    const json_t *time = json_object_get(record, "time");
    if (!json_object_get(time, "precision") || aob_stored_is_precise(&run->sweep.config, time))
        return;
    run->imprecise++;
    double needed = aob_stored_seconds_needed(&run->sweep.config, time);
    if (!isfinite(needed))
        return;
    run->foretold++;
    run->seconds_needed = fmax(run->seconds_needed, needed);
}

static const struct aob_case *state_case(const struct run *run, const struct aob_state *state)
{
    return &run->sweep.plan.cases[state - run->measurement.states];
}

static void take_best(struct run *run, const struct aob_case *c, const json_t *record)
{
    struct aob_text what = {0};
    if (!run->best.ask)
        return;
    aob_case_describe(&run->sweep.plan, c, &what);
    aob_best_take(&run->best, record, what.data);
    aob_text_finish(&what);
}

/* Where only the cache figures are not those of now, they alone are measured. A case that is not good has none. */
static void take_stored(struct run *run, struct aob_state *state, json_t *record)
{
    bool good = strcmp(json_string_value(json_object_get(record, "status")), "ok") == 0;
    if (!good || aob_cache_case_is_done(&run->sweep.plan, record)) {
        state->stage = AOB_DONE;
        count(run, record);
        take_best(run, state_case(run, state), record);
    } else
        state->stored = json_incref(record);
}

/* What is left is timed by the clock of what is there. */
static bool skip_finished(struct run *run, struct aob_error *error)
{
    struct aob_error damage = {{0}};
    json_t *records = aob_journal_read(run->folder.journal_path, &damage, error), *record,
           *places = json_object();
    size_t at;
    if (*damage.text)
        aob_warn("%s", damage.text);
    for (size_t i = 0; i < run->sweep.plan.case_count; i++)
        json_object_set_new(places, run->sweep.plan.cases[i].key, json_integer((json_int_t)i));
    json_array_foreach(records, at, record)
    {
        const char *key = json_string_value(json_object_get(record, "key"));
        const json_t *place = key ? json_object_get(places, key) : NULL;
        struct aob_state *state = place ? &run->measurement.states[json_integer_value(place)] : NULL;
        if (!state || state->stage != AOB_PENDING ||
            !aob_stored_is_finished(&run->sweep.plan, run->folder.path, record))
            continue;
        aob_run_clocks_take(&run->measurement.clocks, state_case(run, state)->backend, record);
        take_stored(run, state, record);
    }
    json_decref(places);
    json_decref(records);
    return records;
}

static void store_record(void *user, size_t index, json_t *record)
{
    struct run *run = user;
    struct aob_text done = {0};
    if (!*run->store_error.text)
        aob_journal_append(&run->folder.journal, record, &run->store_error);
    run->stored++;
    count(run, record);
    aob_case_describe(&run->sweep.plan, &run->sweep.plan.cases[index], &done);
    take_best(run, &run->sweep.plan.cases[index], record);
    aob_progress_step(&run->progress, done.data);
    aob_text_finish(&done);
}

static void say_work(void *user, size_t index, const char *work)
{
    struct run *run = user;
    struct aob_text text = {0};
    aob_text_add(&text, "%s: ", work);
    aob_case_describe(&run->sweep.plan, &run->sweep.plan.cases[index], &text);
    aob_progress_say(&run->progress, text.data);
    aob_text_finish(&text);
}

/* One with a record loses nothing of it but the figures that it lacks (measure_caches). */
static void store_refused(struct run *run)
{
    for (size_t i = 0; i < run->sweep.plan.case_count; i++) {
        struct aob_state *state = &run->measurement.states[i];
        if (state->stage != AOB_REFUSED || state->stored)
            continue;
        json_t *record = aob_record_create(&(struct aob_record_desc){.config = &run->sweep.config,
                                                                     .c = &run->sweep.plan.cases[i],
                                                                     .state = state,
                                                                     .status = state->status,
                                                                     .reason = state->reason});
        store_record(run, i, record);
        json_decref(record);
    }
}

static void measure_caches(struct run *run)
{
    for (size_t i = 0; i < run->sweep.plan.case_count && !*run->store_error.text; i++)
        if (run->measurement.states[i].stage != AOB_DONE && run->measurement.states[i].stored)
            aob_cache_case_again(&run->measurement, i);
}

/* What cannot be stored is not measured. A journal that went away behind its last line is noticed at the end. */
static bool measure_blocks(struct run *run, struct aob_error *error)
{
    size_t indices[AOB_BLOCK_MAX];
    bool *pending = AOB_NEW_ARRAY(bool, run->sweep.plan.case_count);
    measure_caches(run);
    for (size_t i = 0; i < run->sweep.plan.case_count; i++)
        pending[i] = run->measurement.states[i].stage == AOB_PENDING;
    for (size_t at = 0; at < run->sweep.plan.case_count && !*run->store_error.text;) {
        size_t used = aob_plan_next_block(&run->sweep.plan, pending, &at, indices);
        if (used)
            aob_measurement_block(&run->measurement, indices, used);
    }
    free(pending);
    if (!*run->store_error.text)
        aob_journal_check(&run->folder.journal, &run->store_error);
    *error = run->store_error;
    return !*error->text;
}

static size_t pending(const struct run *run)
{
    size_t count = 0;
    for (size_t i = 0; i < run->sweep.plan.case_count; i++)
        count += run->measurement.states[i].stage == AOB_PENDING;
    return count;
}

static bool measure(struct run *run, struct aob_error *error)
{
    aob_best_init(&run->best, &run->sweep.budget);
    if (!aob_measurement_init(&run->measurement, &run->desc->dispatch, &run->sweep.plan, error) ||
        !skip_finished(run, error))
        return false;
    run->measurement.folder = run->folder.path;
    run->measurement.shaders = run->folder.shaders;
    run->measurement.on_work = say_work;
    run->measurement.on_record = store_record;
    run->measurement.user = run;
    aob_progress_init(&run->progress, pending(run), run->desc->quiet);
    run->progress.below = run->best.lines;
    run->progress.below_count = run->best.ask ? AOB_BEST_SHOWN : 0;
    aob_measurement_layout(&run->measurement);
    store_refused(run);
    bool ok = measure_blocks(run, error);
    aob_progress_finish(&run->progress);
    return ok;
}

static json_t *shares_to_json(const struct run *run, double report_s)
{
    const struct aob_shares *s = &run->measurement.shares;
    return json_pack("{s:f, s:f, s:f, s:f, s:f, s:f}", "total",
                     (double)(aob_clock_wall_ns() - run->start_ns) * 1e-9, "measured", s->measured, "warmup",
                     s->warmup, "reference", s->reference, "images", s->images, "report", report_s);
}

/* A run that measured nothing has the page of the one that did, unless that was stopped before it drew one or had another
 * budget. */
static bool page_stands(const struct run *run, const char *report)
{
    struct stat page_stat, journal_stat;
    char *page = aob_path_join(report, "index.html");
    bool stands = !run->stored && run->has_page && stat(page, &page_stat) == 0 &&
                  stat(run->folder.journal_path, &journal_stat) == 0 &&
                  page_stat.st_mtime >= journal_stat.st_mtime;
    free(page);
    return stands;
}

static bool write_report(struct run *run, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    char *report = aob_path_join(run->folder.path, "report");
    const struct aob_page_desc page = {.folders = (const char *const[]){run->folder.path, NULL},
                                       .out = report,
                                       .program = run->desc->dispatch.program};
    aob_progress_say(&run->progress, "drawing the page");
    bool ok = page_stands(run, report) || aob_page_write(&page, error);
    aob_progress_finish(&run->progress);
    free(report);
    json_object_set_new(run->info, "seconds",
                        shares_to_json(run, (double)(aob_clock_wall_ns() - start) * 1e-9));
    return ok && aob_run_folder_describe(&run->folder, run->info, error);
}

/* "; 3 less precise than 3 %, for which seconds: 12 would do". Two digits of an estimate are enough. */
static void add_imprecise(const struct run *run, struct aob_text *text)
{
    if (!run->imprecise)
        return;
    aob_text_add(text, "; %zu less precise than %g %%", run->imprecise, 100 * run->sweep.config.precision);
    if (!run->foretold)
        return;
    double step = pow(10, floor(log10(run->seconds_needed)) - 1);
    aob_text_add(text, ", for which seconds: %g would do", ceil(run->seconds_needed / step) * step);
    if (run->foretold < run->imprecise)
        aob_text_add(text, " in %zu of them", run->foretold);
}

static json_t *summary_to_json(const struct run *run)
{
    json_t *counts = json_object();
    for (size_t i = 0; i < AOB_COUNT(status_names); i++)
        json_object_set_new(counts, status_names[i], json_integer((json_int_t)run->counts[i]));
    double seconds = run->foretold && run->foretold == run->imprecise ? run->seconds_needed : NAN;
    return json_pack("{s:s, s:s, s:i, s:o, s:{s:i, s:o}, s:O}", "name", run->sweep.config.name, "folder",
                     run->folder.path, "cases", (int)run->sweep.plan.case_count, "status", counts,
                     "imprecise", "cases", (int)run->imprecise, "seconds_needed", aob_json_number(seconds),
                     "seconds", json_object_get(run->info, "seconds"));
}

static void note_summary(const struct run *run)
{
    struct aob_text imprecise = {0};
    add_imprecise(run, &imprecise);
    aob_note("%zu cases: %zu ok, %zu unsupported, %zu invalid, %zu failed%s; page: %s/report/index.html",
             run->sweep.plan.case_count, run->counts[0], run->counts[1], run->counts[2], run->counts[3],
             imprecise.data ? imprecise.data : "", run->folder.path);
    aob_text_finish(&imprecise);
}

static bool print_summary(const struct run *run, struct aob_error *error)
{
    if (!run->desc->quiet)
        note_summary(run);
    if (!run->desc->json)
        return true;
    json_t *document = summary_to_json(run);
    bool ok = aob_json_write(document, run->desc->json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit verdict(const struct run *run, struct aob_error *error)
{
    if (run->counts[0] == run->sweep.plan.case_count)
        return AOB_EXIT_OK;
    if (run->counts[0])
        return AOB_EXIT_PART;
    aob_fail(error, "nothing could run: %zu cases, none ok; the reasons are in %s",
             run->sweep.plan.case_count, run->folder.journal_path);
    return AOB_EXIT_USAGE;
}

/* What can be said before anything is measured. */
static bool prepare(struct run *run, struct aob_error *error)
{
    const struct aob_run_desc *desc = run->desc;
    return read_config(run, error) && aob_sweep_expand(&run->sweep, &desc->dispatch, error) &&
           (!desc->again || aob_run_again_choose(desc->again, &run->sweep, error)) && describe(run, error) &&
           aob_run_effects_choose(desc, &run->sweep, run->info, error) &&
           aob_run_part_choose(desc, &run->sweep.plan, run->info, error);
}

enum aob_exit aob_run(const struct aob_run_desc *desc, struct aob_error *error)
{
    struct run run = {.desc = desc, .sweep.choice = desc->choice, .start_ns = aob_clock_wall_ns()};
    bool ok = prepare(&run, error) && open_folder(&run, error) && measure(&run, error) &&
              (desc->no_page || write_report(&run, error)) && print_summary(&run, error);
    enum aob_exit code = ok ? verdict(&run, error) : AOB_EXIT_USAGE;
    json_decref(run.info);
    aob_best_finish(&run.best);
    aob_measurement_finish(&run.measurement);
    aob_run_folder_close(&run.folder);
    aob_sweep_finish(&run.sweep);
    return code;
}
