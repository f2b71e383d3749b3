#include "run.h"
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include "base/clock.h"
#include "base/file.h"
#include "base/json.h"
#include "base/memory.h"
#include "captures.h"
#include "config/config.h"
#include "timing/timing.h"
#include "measurement.h"
#include "plan/plan.h"
#include "progress.h"
#include "reports/page/page.h"
#include "store/run_folder.h"

/* One run, from its config to its page. */
struct run {
    const struct aob_run_desc *desc;
    struct aob_config config;
    struct aob_technique_list techniques;
    struct aob_plan plan;
    struct aob_measurement measurement;
    struct aob_run_folder folder;
    struct aob_progress progress;
    json_t *
        info; /* what run.json says: name, config_hash, build, program, date, cases, keys, techniques; seconds at the end */
    size_t counts[4]; /* by status, in status_names' order, of the cases in this run's plan */
    struct aob_error store_error;
    int64_t start_ns;
};
static const char *const status_names[4] = {"ok", "unsupported", "invalid", "failed"};

static bool read_config(struct run *run, struct aob_error *error)
{
    const struct aob_run_desc *desc = run->desc;
    struct aob_config *config = &run->config;
    if (!aob_config_read(config, desc->config, error))
        return false;
    for (size_t i = 0; i < config->size_count; i++)
        if (desc->max_width && config->sizes[i].width > desc->max_width)
            config->sizes[i].width = desc->max_width;
    if (desc->max_seconds > 0 && config->seconds > desc->max_seconds)
        config->seconds = desc->max_seconds;
    if (desc->max_spp && config->spp > desc->max_spp)
        config->spp = desc->max_spp;
    return true;
}

static bool make_plan(struct run *run, struct aob_error *error)
{
    return read_config(run, error) && aob_dispatch_describe(&run->desc->dispatch, &run->techniques, error) &&
           aob_captures_load(&run->config, &run->desc->dispatch, error) &&
           aob_plan_create(&run->plan, &run->config, &run->techniques, error);
}

/* Those of the plan, so that a page can say what was measured. */
static json_t *techniques_to_json(const struct run *run)
{
    json_t *array = json_array();
    for (size_t t = 0; t < run->techniques.count; t++) {
        bool used = false;
        for (size_t i = 0; i < run->plan.case_count && !used; i++)
            used = run->plan.cases[i].technique == &run->techniques.items[t];
        if (used)
            json_array_append_new(array, aob_technique_info_to_json(&run->techniques.items[t]));
    }
    return array;
}

/* Of the whole plan, whatever the filter: a page is complete when all of it is measured. */
static bool make_info(struct run *run, struct aob_error *error)
{
    char date[32], build[AOB_KEY_SIZE];
    time_t now = time(NULL);
    json_t *keys = json_array();
    strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", gmtime(&now));
    for (size_t i = 0; i < run->plan.case_count; i++)
        json_array_append_new(keys, json_string(run->plan.cases[i].key));
    bool ok = aob_hash_file(run->desc->dispatch.program, build, error);
    run->info =
        json_pack("{s:s, s:s, s:s, s:s, s:s, s:i, s:o, s:o}", "name", run->config.name, "config_hash",
                  run->config.hash, "build", ok ? build : "", "program", AOBUDGET_VERSION, "date", date,
                  "cases", (int)run->plan.case_count, "keys", keys, "techniques", techniques_to_json(run));
    return ok;
}

static bool apply_filter(struct run *run, struct aob_error *error)
{
    if (run->desc->filter)
        aob_plan_filter(&run->plan, run->desc->filter);
    return run->plan.case_count || aob_fail(error, "no case of %s matches '%s'; see: aobudget plan %s",
                                            run->desc->config, run->desc->filter, run->desc->config);
}

static bool open_folder(struct run *run, struct aob_error *error)
{
    char *path = run->desc->out ? aob_strdup(run->desc->out) : aob_path_join("results", run->config.name);
    /* The document may go there too; an earlier run is discarded only when it can be written. */
    bool ok = aob_folder_create(path, error) && aob_json_check(run->desc->json, error) &&
              aob_run_folder_open(&run->folder, path, run->info, run->desc->fresh, error);
    free(path);
    return ok;
}

static void count(struct run *run, const json_t *record)
{
    const char *status = json_string_value(json_object_get(record, "status"));
    for (size_t i = 0; status && i < AOB_COUNT(status_names); i++)
        run->counts[i] += strcmp(status, status_names[i]) == 0;
}

static void skip_case(struct run *run, const json_t *record)
{
    const char *key = json_string_value(json_object_get(record, "key"));
    for (size_t i = 0; i < run->plan.case_count; i++)
        if (strcmp(run->plan.cases[i].key, key) == 0 && run->measurement.states[i].stage == AOB_PENDING) {
            run->measurement.states[i].stage = AOB_DONE;
            count(run, record);
        }
}

/* Cases with a verdict stay; failed and unsupported ones get another chance. */
static bool skip_finished(struct run *run, struct aob_error *error)
{
    json_t *records = aob_journal_read(run->folder.journal_path, error), *record;
    size_t at;
    if (!records)
        return false;
    json_array_foreach(records, at, record)
    {
        const char *status = json_string_value(json_object_get(record, "status"));
        if (status && (strcmp(status, "ok") == 0 || strcmp(status, "invalid") == 0))
            skip_case(run, record);
    }
    json_decref(records);
    return true;
}

static void store_record(void *user, size_t index, json_t *record)
{
    struct run *run = user;
    struct aob_text next = {0};
    if (!*run->store_error.text)
        aob_journal_append(&run->folder.journal, record, &run->store_error);
    count(run, record);
    aob_case_describe(&run->plan, &run->plan.cases[index], &next);
    aob_progress_step(&run->progress, next.data);
    aob_text_finish(&next);
}

static void store_refused(struct run *run)
{
    for (size_t i = 0; i < run->plan.case_count; i++) {
        struct aob_state *state = &run->measurement.states[i];
        if (state->stage != AOB_REFUSED)
            continue;
        json_t *record = aob_record_create(&run->measurement, i, state->status, state->reason, NULL);
        store_record(run, i, record);
        json_decref(record);
    }
}

static bool measure_blocks(struct run *run, struct aob_error *error)
{
    size_t indices[AOB_BLOCK_MAX];
    for (size_t first = 0; first < run->plan.case_count; first++) {
        size_t used = 0;
        for (size_t i = first; i < run->plan.case_count && used < AOB_BLOCK_MAX; i++)
            if (run->measurement.states[i].stage == AOB_PENDING &&
                aob_case_same_block(&run->plan.cases[first], &run->plan.cases[i]))
                indices[used++] = i;
        if (run->measurement.states[first].stage == AOB_PENDING)
            aob_measurement_block(&run->measurement, indices, used);
        if (*run->store_error.text) {
            *error = run->store_error;
            return false;
        }
    }
    return true;
}

static size_t pending(const struct run *run)
{
    size_t count = 0;
    for (size_t i = 0; i < run->plan.case_count; i++)
        count += run->measurement.states[i].stage == AOB_PENDING;
    return count;
}

static bool measure(struct run *run, struct aob_error *error)
{
    if (!aob_measurement_init(&run->measurement, &run->desc->dispatch, &run->plan, error) ||
        !skip_finished(run, error))
        return false;
    run->measurement.folder = run->folder.path;
    run->measurement.on_record = store_record;
    run->measurement.user = run;
    aob_progress_init(&run->progress, pending(run), run->desc->quiet);
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

static bool write_report(struct run *run, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    char *report = aob_path_join(run->folder.path, "report");
    bool ok = aob_page_write(&(struct aob_page_desc){.folders = (const char *const[]){run->folder.path, NULL},
                                                     .out = report,
                                                     .program = run->desc->dispatch.program},
                             error);
    free(report);
    json_object_set_new(run->info, "seconds",
                        shares_to_json(run, (double)(aob_clock_wall_ns() - start) * 1e-9));
    return ok && aob_run_folder_describe(&run->folder, run->info, error);
}

static bool print_summary(const struct run *run, struct aob_error *error)
{
    if (!run->desc->quiet)
        aob_note("%zu cases: %zu ok, %zu unsupported, %zu invalid, %zu failed; page: %s/report/index.html",
                 run->plan.case_count, run->counts[0], run->counts[1], run->counts[2], run->counts[3],
                 run->folder.path);
    if (!run->desc->json)
        return true;
    json_t *counts = json_object();
    for (size_t i = 0; i < AOB_COUNT(status_names); i++)
        json_object_set_new(counts, status_names[i], json_integer((json_int_t)run->counts[i]));
    json_t *document = json_pack("{s:s, s:s, s:i, s:o, s:O}", "name", run->config.name, "folder",
                                 run->folder.path, "cases", (int)run->plan.case_count, "status", counts,
                                 "seconds", json_object_get(run->info, "seconds"));
    bool ok = aob_json_write(document, run->desc->json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit verdict(const struct run *run, struct aob_error *error)
{
    if (run->counts[0] == run->plan.case_count)
        return AOB_EXIT_OK;
    if (run->counts[0])
        return AOB_EXIT_PART;
    aob_fail(error, "nothing could run: %zu cases, none ok; the reasons are in %s", run->plan.case_count,
             run->folder.journal_path);
    return AOB_EXIT_USAGE;
}

enum aob_exit aob_run(const struct aob_run_desc *desc, struct aob_error *error)
{
    struct run run = {.desc = desc, .start_ns = aob_clock_wall_ns()};
    bool ok = make_plan(&run, error) && make_info(&run, error) && apply_filter(&run, error) &&
              open_folder(&run, error) && measure(&run, error) &&
              (desc->no_page || write_report(&run, error)) && print_summary(&run, error);
    enum aob_exit code = ok ? verdict(&run, error) : AOB_EXIT_USAGE;
    json_decref(run.info);
    aob_measurement_finish(&run.measurement);
    aob_run_folder_close(&run.folder);
    aob_plan_finish(&run.plan);
    aob_technique_list_finish(&run.techniques);
    aob_config_finish(&run.config);
    return code;
}
