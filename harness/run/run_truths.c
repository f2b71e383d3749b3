#include "run_truths.h"
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/memory.h"
#include "measurement.h"
#include "plan/block.h"
#include "progress.h"
#include "run_part.h"

struct truths {
    const struct aob_run_desc *desc;
    struct aob_sweep sweep;
    struct aob_measurement m;
    struct aob_progress progress;
    size_t views, lost; /* with cases to measure; those of them whose truths could not be made */
    json_t *failed;     /* a line for each of these, and for each reason why a case was not laid out */
    int64_t start_ns;
};

static bool prepare(struct truths *t, struct aob_error *error)
{
    struct aob_config *config = &t->sweep.config;
    if (!aob_config_read(config, t->desc->config, error) || !aob_run_part_judge(t->desc, config, error))
        return false;
    config->measure_time = false; /* the lock of measuring is not needed */
    return aob_json_check(t->desc->json, error) && aob_sweep_expand(&t->sweep, &t->desc->dispatch, error) &&
           aob_run_part_choose(t->desc, &t->sweep.plan, NULL, error) &&
           aob_measurement_init(&t->m, &t->desc->dispatch, &t->sweep.plan, error);
}

static void say_view(void *user, size_t index, const char *work)
{
    const struct truths *t = user;
    struct aob_text text = {0};
    aob_text_add(&text, "%s: ", work);
    aob_case_describe(&t->sweep.plan, &t->sweep.plan.cases[index], &text);
    aob_progress_say(&t->progress, text.data);
    aob_text_finish(&text);
}

static void tell_failure(struct truths *t, const char *line)
{
    aob_warn("%s", line);
    json_array_append_new(t->failed, aob_json_text(line));
}

/* A view that failed fails for each of its blocks, and is told once. */
static void trace_cases(struct truths *t, const size_t *indices, size_t count)
{
    struct aob_view_files files = {0};
    struct aob_error error = {{0}};
    size_t failed = json_object_size(t->m.failed_views);
    if (aob_view_prepare(&t->m, indices, count, &files, &error))
        aob_view_files_finish(&files);
    else if (json_object_size(t->m.failed_views) > failed) {
        tell_failure(t, error.text);
        t->lost++;
    }
}

/* A truth with mean open directions serves the other cases of a block as well; in a run that has not the same blocks, because it goes on or is
 * filtered, they need their own. */
static void trace_block(struct truths *t, const size_t *indices, size_t count)
{
    for (int bent = 0; bent < 2; bent++) {
        size_t some[AOB_BLOCK_MAX], used = 0;
        for (size_t i = 0; i < count; i++)
            if ((t->m.states[indices[i]].outputs >> AOB_OUT_BENT_NORMAL & 1) == (unsigned)bent)
                some[used++] = indices[i];
        if (used)
            trace_cases(t, some, used);
    }
}

/* What a case is compared with is not known if its technique could not be asked. One that refuses it needs nothing. */
static void tell_unasked(struct truths *t)
{
    json_t *told = json_object();
    for (size_t i = 0; i < t->sweep.plan.case_count; i++) {
        const struct aob_state *state = &t->m.states[i];
        if (state->stage != AOB_REFUSED || strcmp(state->status, "failed") != 0 ||
            json_object_get(told, state->reason))
            continue;
        json_object_set_new(told, state->reason, json_true());
        tell_failure(t, state->reason);
    }
    json_decref(told);
}

/* Adds one to `views` for each view of which no case was here before. */
static void count_view(struct truths *t, size_t index, bool *seen, size_t *views)
{
    bool *here = &seen[aob_view_number(&t->m, index)];
    *views += !*here;
    *here = true;
}

static bool *mark_pending(struct truths *t)
{
    size_t count = t->sweep.plan.case_count;
    bool *pending = AOB_NEW_ARRAY(bool, count), *seen = AOB_NEW_ARRAY(bool, count);
    for (size_t i = 0; i < count; i++) {
        pending[i] = t->m.states[i].stage == AOB_PENDING;
        if (pending[i])
            count_view(t, i, seen, &t->views);
    }
    free(seen);
    return pending;
}

static void trace(struct truths *t)
{
    size_t indices[AOB_BLOCK_MAX];
    t->m.on_work = say_view;
    t->m.user = t;
    aob_measurement_layout(&t->m);
    tell_unasked(t);
    bool *pending = mark_pending(t), *seen = AOB_NEW_ARRAY(bool, t->sweep.plan.case_count);
    aob_progress_init(&t->progress, t->views, t->desc->quiet);
    for (size_t at = 0; at < t->sweep.plan.case_count;) {
        size_t used = aob_plan_next_block(&t->sweep.plan, pending, &at, indices);
        if (!used)
            continue;
        trace_block(t, indices, used);
        count_view(t, indices[0], seen, &t->progress.done);
    }
    aob_progress_finish(&t->progress);
    free(pending);
    free(seen);
}

static bool print_summary(const struct truths *t, struct aob_error *error)
{
    double seconds = (double)(aob_clock_wall_ns() - t->start_ns) * 1e-9;
    size_t good = t->views - t->lost;
    if (!t->desc->quiet)
        aob_note("%zu of %zu views have their truths in %s (%.1f s)", good, t->views, t->m.cache.folder,
                 seconds);
    if (!t->desc->json)
        return true;
    json_t *document = json_pack("{s:s, s:o, s:i, s:O, s:f}", "name", t->sweep.config.name, "cache",
                                 aob_json_text(t->m.cache.folder), "views", (int)t->views, "failed",
                                 t->failed, "seconds", seconds);
    bool ok = aob_json_write(document, t->desc->json, error);
    json_decref(document);
    return ok;
}

static enum aob_exit verdict(const struct truths *t, struct aob_error *error)
{
    if (!json_array_size(t->failed))
        return AOB_EXIT_OK;
    if (t->lost < t->views)
        return AOB_EXIT_PART;
    aob_fail(error, "no view of %s has its truths: the warnings say why", t->desc->config);
    return AOB_EXIT_USAGE;
}

enum aob_exit aob_run_truths(const struct aob_run_desc *desc, struct aob_error *error)
{
    struct truths t = {.desc = desc, .failed = json_array(), .start_ns = aob_clock_wall_ns()};
    bool ok = prepare(&t, error);
    if (ok)
        trace(&t);
    ok = ok && print_summary(&t, error);
    enum aob_exit code = ok ? verdict(&t, error) : AOB_EXIT_USAGE;
    json_decref(t.failed);
    aob_measurement_finish(&t.m);
    aob_sweep_finish(&t.sweep);
    return code;
}
