#include "stage.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "run/drawing.h"
#include "shape.h"

/* A small image has about so many columns, and its truth so many rays a pixel. */
enum { SMALL_WIDTH = 160, SMALL_SPP = 128 };

/* Images of every view that a search may draw: some for each search, and some more for each parameter. */
enum {
    GLOBAL_LEAST = 40,
    GLOBAL_MORE = 15,
    LOCAL_LEAST = 40,
    LOCAL_MORE = 30,
    FULL_LEAST = 20,
    FULL_MORE = 12
};

/* Of the local search, as a share of the box. In a bent valley a shorter one takes as many images and stops before the end (decision 54). */
static const double first_step = 0.1;

/* What goes wrong is said by one line, but a fit may need hours of a slow machine: ten times what was measured of a dear frame. */
static const double job_s = 300, pixel_s = 1e-5;

/* A stage while it goes on. */
struct stage {
    const struct aob_tune_desc *desc;
    const struct aob_tune *tune;
    struct aob_tune_setting *setting;
    enum aob_tune_stage which;
    struct aob_sweep sweep;
    struct aob_measurement measurement;
    struct aob_view_files *files; /* one a view that is fitted */
    struct aob_tune_job job;
    struct aob_tune_result result;
    bool answered;
};

int aob_tune_stage_divisor(const struct aob_tune *tune, enum aob_tune_stage stage)
{
    return stage == AOB_TUNE_FULL ? 1 : (int)fmax(1, round((double)tune->width / SMALL_WIDTH));
}

static void say(const struct stage *stage, const char *work)
{
    if (stage->desc->on_work)
        stage->desc->on_work(stage->desc->user, work);
}

static void take(void *user, const json_t *object)
{
    struct stage *stage = user;
    struct aob_tune_progress progress;
    struct aob_text text = {0};
    if (aob_tune_result_from_json(object, &stage->result))
        stage->answered = stage->result.count == stage->job.axis_count;
    else if (aob_tune_progress_from_json(object, &progress)) {
        aob_text_add(&text, "fitting %s at %dx%d: %d of %d, error %.4f", stage->desc->technique,
                     stage->sweep.plan.cases[0].width, stage->sweep.plan.cases[0].height, progress.done,
                     progress.of, progress.error);
        say(stage, text.data);
        aob_text_finish(&text);
    }
}

bool aob_tune_stage_axes(const struct aob_tune_desc *desc, const struct aob_case *first,
                         struct aob_tune_setting *setting, struct aob_error *error)
{
    const struct aob_technique_info *technique = first->technique;
    bool stated[AOB_MAX_PARAM];
    for (size_t i = 0; i < technique->param_count; i++)
        stated[i] = aob_tune_setting_states(setting, technique->params[i].name);
    return aob_tune_axes_choose(
        &setting->axes,
        &(struct aob_tune_axes_desc){
            .technique = technique, .start = first->params, .names = desc->params, .stated = stated},
        error);
}

/* The case of a view that is fitted; NULL: it is held out, or another view is the same. */
static const struct aob_case *case_of(const struct stage *stage, size_t view)
{
    const struct aob_plan *plan = &stage->sweep.plan;
    for (size_t i = 0; i < plan->case_count && !stage->tune->views[view].held_out; i++)
        if (plan->cases[i].scene == &plan->scenes[view])
            return &plan->cases[i];
    return NULL;
}

static bool add_view(struct stage *stage, const struct aob_case *c, struct aob_error *error)
{
    struct aob_measurement *m = &stage->measurement;
    size_t index = (size_t)(c - stage->sweep.plan.cases);
    struct aob_view_files *files = &stage->files[stage->job.view_count];
    if (m->states[index].stage == AOB_REFUSED)
        return aob_fail(error, "%s: %s: %s", stage->desc->technique, m->states[index].status,
                        m->states[index].reason);
    if (!aob_view_prepare(m, &index, 1, files, error))
        return false;
    stage->job.views[stage->job.view_count++] =
        (struct aob_tune_view){.drawing = aob_job_drawing_of(m, index, files),
                               .frame = aob_job_frame_of(c),
                               .truth = files->truth[0][AOB_OUT_VISIBILITY]};
    return true;
}

static void add_axes(struct stage *stage)
{
    const int divisor = aob_tune_stage_divisor(stage->tune, stage->which);
    const struct aob_tune_axes *axes = &stage->setting->axes;
    for (size_t i = 0; i < axes->count; i++) {
        const struct aob_param *param = &stage->tune->technique->params[axes->items[i].index];
        struct aob_tune_axis axis = axes->items[i];
        if (stage->which == AOB_TUNE_FULL && stage->setting->idle[i])
            continue;
        if (stage->which == AOB_TUNE_FULL)
            aob_tune_axis_centre(&axis, param, stage->setting->fitted[i]);
        if (param->unit == AOB_UNIT_PIXEL)
            axis.scale = 1.0 / divisor;
        stage->job.axes[stage->job.axis_count++] = axis;
    }
}

static bool fill_job(struct stage *stage, struct aob_error *error)
{
    const bool small = stage->which == AOB_TUNE_SMALL;
    stage->job.views = AOB_NEW_ARRAY(struct aob_tune_view, stage->tune->view_count);
    stage->files = AOB_NEW_ARRAY(struct aob_view_files, stage->tune->view_count);
    for (size_t v = 0; v < stage->tune->view_count; v++) {
        const struct aob_case *c = case_of(stage, v);
        if (c && small && !stage->setting->axes.count &&
            !aob_tune_stage_axes(stage->desc, c, stage->setting, error))
            return false;
        if (c && !add_view(stage, c, error))
            return false;
    }
    add_axes(stage);
    const int axes = (int)stage->job.axis_count;
    stage->job.probe = small;
    stage->job.global = small ? GLOBAL_LEAST + GLOBAL_MORE * axes : 0;
    stage->job.local = small ? LOCAL_LEAST + LOCAL_MORE * axes : FULL_LEAST + FULL_MORE * axes;
    stage->job.step = first_step;
    return true;
}

static double time_limit(const struct stage *stage)
{
    const struct aob_tune_job *job = &stage->job;
    double pixels = 0, images = 2.0 * (double)job->axis_count + job->global + job->local + 2;
    for (size_t v = 0; v < job->view_count; v++)
        pixels += (double)job->views[v].drawing.view.width * job->views[v].drawing.view.height;
    return job_s + images * pixels * pixel_s;
}

static bool send(struct stage *stage, struct aob_error *error)
{
    struct aob_drawing_environment env;
    aob_drawing_environment_init(&env, &stage->measurement, &stage->sweep.plan.cases[0]);
    bool ok = aob_dispatch_job(stage->desc->dispatch,
                               &(struct aob_job_desc){.job = aob_tune_job_to_json(&stage->job),
                                                      .env = (const char *const *)env.texts,
                                                      .timeout_s = time_limit(stage),
                                                      .on_answer = take,
                                                      .user = stage},
                               error);
    aob_drawing_environment_finish(&env);
    return (ok || aob_fail_in(error, "%s", stage->desc->technique)) &&
           (stage->answered || aob_fail(error, "%s: the worker ended without a fit", stage->desc->technique));
}

static void keep(struct stage *stage)
{
    struct aob_tune_setting *setting = stage->setting;
    for (size_t i = 0, at = 0; i < setting->axes.count; i++) {
        if (stage->which == AOB_TUNE_FULL && setting->idle[i])
            continue;
        setting->fitted[i] = stage->result.values[at];
        setting->idle[i] = stage->result.idle[at++];
    }
    setting->evaluations += stage->result.evaluations;
}

static bool measure(struct stage *stage, struct aob_error *error)
{
    if (!aob_measurement_init(&stage->measurement, stage->desc->dispatch, &stage->sweep.plan, error))
        return false;
    stage->measurement.shaders = stage->desc->folder;
    aob_measurement_layout(&stage->measurement);
    say(stage, "tracing the truth that is fitted");
    if (!fill_job(stage, error) || !send(stage, error))
        return false;
    keep(stage);
    return true;
}

bool aob_tune_stage_run(const struct aob_tune_desc *desc, const struct aob_tune *tune,
                        enum aob_tune_stage which, struct aob_tune_setting *setting, struct aob_error *error)
{
    struct stage stage = {.desc = desc, .tune = tune, .setting = setting, .which = which};
    const struct aob_tune_shape shape = {.settings = setting,
                                         .count = 1,
                                         .sides = {[AOB_TUNE_DEFAULT] = true},
                                         .divisor = aob_tune_stage_divisor(tune, which),
                                         .spp = which == AOB_TUNE_SMALL ? SMALL_SPP : INT_MAX,
                                         .error = true};
    bool ok = aob_tune_shape_expand(desc, tune, &shape, &stage.sweep, error) && measure(&stage, error);
    for (size_t v = 0; stage.files && v < stage.job.view_count; v++)
        aob_view_files_finish(&stage.files[v]);
    free(stage.files);
    aob_tune_job_finish(&stage.job);
    aob_measurement_finish(&stage.measurement);
    aob_sweep_finish(&stage.sweep);
    return ok;
}
