#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"
#include "canvas.h"
#include "section.h"
#include "technique/registry.h"
#include "timing/fixed_pass.h"
#include "trial.h"

enum { MAX_TIMED = 64, HISTORY = 16 };

/* A technique at its defaults, or with a history as well. */
struct timed {
    const struct aob_technique *technique;
    json_t *params; /* NULL: the defaults */
    char name[64];
};

static bool may_keep_history(const struct aob_technique *technique)
{
    for (uint32_t i = 0; i < technique->param_count; i++)
        if (strcmp(technique->params[i].name, "history") == 0)
            return true;
    return false;
}

/* Each technique at its defaults, and once more where it may have a history. */
static size_t list_timed(struct timed list[MAX_TIMED])
{
    size_t count = 0;
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t && count < MAX_TIMED - 1; t++) {
        struct timed *timed = &list[count++];
        *timed = (struct timed){.technique = *t};
        snprintf(timed->name, sizeof timed->name, "%s", (*t)->name);
        if (!may_keep_history(*t))
            continue;
        timed = &list[count++];
        *timed = (struct timed){.technique = *t, .params = json_pack("{s:i}", "history", HISTORY)};
        snprintf(timed->name, sizeof timed->name, "%s history=%d", (*t)->name, HISTORY);
    }
    return count;
}

/* What the techniques of a view share. */
struct stand {
    const struct aob_section_job *job;
    struct aob_gpu *gpu;
    struct aob_canvas canvas;
    struct aob_frame
        fixed;     /* on the canvas's screen, which is the same for all, as all have the same options */
    double spread; /* of the A/A ratio from 1, the farthest */
};

/* Processor time is the work of a software driver, and means nothing on a GPU. */
static enum aob_clock choose_clock(const struct stand *stand)
{
    if (stand->job->trusted)
        return AOB_CLOCK_DEVICE;
    return stand->gpu->info.software ? AOB_CLOCK_CPU : AOB_CLOCK_WALL;
}

static void add_time(json_t *object, const struct aob_trial_time *time)
{
    json_object_set_new(object, "ms", aob_json_number(time->ms));
    json_object_set_new(object, "ms_low", aob_json_number(time->low));
    json_object_set_new(object, "ms_high", aob_json_number(time->high));
}

static json_t *bound(const struct aob_ratio *ratio, double value)
{
    return ratio->bounded ? json_real(value) : json_null();
}

static json_t *passes_to_json(const struct aob_frame *frame, const struct aob_trial *trial)
{
    json_t *passes = json_array();
    size_t live = 0;
    for (int p = 0; p < frame->graph.pass_count; p++) {
        if (!frame->passes[p])
            continue;
        json_t *pass = json_pack("{s:s}", "name", frame->graph.passes[p].name);
        add_time(pass, &trial->passes[live++]);
        json_array_append_new(passes, pass);
    }
    return passes;
}

static void reply_time(struct stand *stand, const char *name, const struct aob_frame *frame,
                       const struct aob_trial *trial)
{
    const struct aob_ratio *ratio = &trial->to_fixed, *control = &trial->control;
    json_t *item = json_pack(
        "{s:s, s:s, s:s, s:i, s:i, s:f, s:f, s:o, s:o, s:f, s:o, s:o, s:o, s:o}", "item", name, "status",
        AOB_CHECK_PASSED, "clock", aob_clock_name(choose_clock(stand)), "rounds", (int)trial->rounds,
        "frames", trial->frames, "fixed_ms", trial->fixed.ms, "ratio_to_ref", ratio->ratio, "ci_low",
        bound(ratio, ratio->low), "ci_high", bound(ratio, ratio->high), "control", control->ratio,
        "control_low", bound(control, control->low), "control_high", bound(control, control->high),
        "passes_share", aob_json_number(trial->passes_share), "passes", passes_to_json(frame, trial));
    add_time(item, &trial->whole);
    aob_section_reply(stand->job, item);
    if (control->bounded)
        stand->spread = fmax(stand->spread, fabs(log(control->ratio)));
}

static bool make_fixed(struct stand *stand, struct aob_error *error)
{
    return stand->fixed.screen ||
           aob_frame_init(&stand->fixed, &stand->canvas.screen, &aob_technique_fixed_pass, &(int32_t){0},
                          AOB_FETCH_SAMPLED, error);
}

/* Where a technique keeps a history, what is timed is the frame after the first. */
static bool begin(struct stand *stand, const struct timed *timed, struct aob_frame *frame,
                  struct aob_error *error)
{
    unsigned char values[sizeof frame->values];
    const struct aob_check_drawing drawing = {
        .technique = timed->technique->name, .params = timed->params, .light = aob_light_uniform};
    if (!aob_canvas_show(&stand->canvas, &drawing, frame, error) || !make_fixed(stand, error))
        return false;
    memcpy(values, frame->values, sizeof values);
    return !aob_graph_keeps_history(&frame->graph) ||
           (aob_canvas_draw(frame, 1, error) && aob_frame_set(frame, 1, values, error));
}

static void time_technique(struct stand *stand, const struct timed *timed, double seconds)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_error cause = {{0}};
    struct aob_trial trial;
    struct aob_trial_desc desc = {.fixed = &stand->fixed,
                                  .frame = frame,
                                  .clock = choose_clock(stand),
                                  .seconds = seconds,
                                  .precision = stand->job->precision};
    if (begin(stand, timed, frame, &cause) && aob_trial_run(&desc, &trial, &cause))
        reply_time(stand, timed->name, frame, &trial);
    else
        aob_section_say(stand->job, timed->name, frame->unfit ? AOB_CHECK_SKIPPED : AOB_CHECK_FAILED,
                        cause.text);
    aob_frame_finish(frame);
    free(frame);
}

static void time_view(struct stand *stand)
{
    struct timed list[MAX_TIMED];
    size_t count = list_timed(list);
    for (size_t i = 0; i < count; i++) {
        if (!aob_section_is_over(stand->job, list[i].name))
            time_technique(stand, &list[i], aob_section_seconds_left(stand->job) / (double)(count - i));
        json_decref(list[i].params);
    }
}

static bool run_times(const struct aob_section_job *job, struct aob_error *error)
{
    struct stand *stand = AOB_NEW(struct stand);
    stand->job = job;
    stand->spread = -INFINITY;
    stand->gpu = aob_section_open(job, &(struct aob_gpu_desc){.as_gpu = job->trusted}, error);
    bool ok = stand->gpu;
    for (size_t i = 0; ok && i < job->data.view_count; i++) {
        if (!job->data.views[i].timed)
            continue;
        ok = aob_canvas_init(&stand->canvas, stand->gpu, &job->data.views[i], error);
        if (ok)
            time_view(stand);
        aob_frame_finish(&stand->fixed);
        aob_canvas_finish(&stand->canvas);
    }
    double known = isfinite(stand->spread) ? stand->spread : NAN; /* no control had an interval */
    if (ok)
        aob_section_reply(job, json_pack("{s:s, s:s, s:o}", "item", "A/A", "status", AOB_CHECK_PASSED,
                                         "spread", aob_json_number(expm1(known))));
    aob_gpu_close(stand->gpu);
    free(stand);
    return ok;
}

const struct aob_section aob_section_times = {"times", run_times};
