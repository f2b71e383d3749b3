#include "tune_job.h"
#include <stdint.h>
#include <stdlib.h>
#include "base/json.h"
#include "base/memory.h"

static json_t *borrow(const json_t *value)
{
    return (json_t *)(uintptr_t)value;
}

static json_t *axis_to_json(const struct aob_tune_axis *axis)
{
    return json_pack("{s:I, s:b, s:f, s:f, s:f, s:f}", "index", (json_int_t)axis->index, "log", axis->log,
                     "low", axis->low, "high", axis->high, "start", axis->start, "scale", axis->scale);
}

static bool axis_from_json(const json_t *object, struct aob_tune_axis *axis)
{
    json_int_t index;
    int log;
    if (json_unpack(borrow(object), "{s:I, s:b, s:F, s:F, s:F, s:F}", "index", &index, "log", &log, "low",
                    &axis->low, "high", &axis->high, "start", &axis->start, "scale", &axis->scale) != 0)
        return false;
    axis->index = (size_t)index;
    axis->log = log;
    return index >= 0 && index < AOB_MAX_PARAM && axis->low <= axis->start && axis->start <= axis->high &&
           (!log || axis->low > 0) && axis->scale > 0;
}

static json_t *view_to_json(const struct aob_tune_view *view)
{
    json_t *object = json_pack("{s:s}", "truth", view->truth);
    aob_job_drawing_to_json(&view->drawing, object);
    aob_job_frame_to_json(&view->frame, object);
    return object;
}

json_t *aob_tune_job_to_json(const struct aob_tune_job *job)
{
    json_t *views = json_array(), *axes = json_array();
    for (size_t i = 0; i < job->view_count; i++)
        json_array_append_new(views, view_to_json(&job->views[i]));
    for (size_t i = 0; i < job->axis_count; i++)
        json_array_append_new(axes, axis_to_json(&job->axes[i]));
    return json_pack("{s:s, s:o, s:o, s:b, s:i, s:i, s:f}", "job", "tune", "views", views, "axes", axes,
                     "probe", job->probe, "global", job->global, "local", job->local, "step", job->step);
}

static bool read_views(const json_t *views, struct aob_tune_job *job, struct aob_error *error)
{
    const json_t *view;
    size_t at;
    job->views = AOB_NEW_ARRAY(struct aob_tune_view, json_array_size(views) + 1);
    json_array_foreach(borrow(views), at, view)
    {
        struct aob_tune_view *into = &job->views[job->view_count++];
        into->truth = json_string_value(json_object_get(view, "truth"));
        if (!into->truth)
            return aob_fail(error, "a view of a job `tune` has no truth");
        if (!aob_job_drawing_from_json(view, &into->drawing, error) ||
            !aob_job_frame_from_json(view, &into->frame, error))
            return false;
    }
    return true;
}

static bool read_axes(const json_t *axes, struct aob_tune_job *job, struct aob_error *error)
{
    const json_t *axis;
    size_t at;
    json_array_foreach(
        borrow(axes), at,
        axis) if (job->axis_count == AOB_MAX_PARAM ||
                  !axis_from_json(
                      axis,
                      &job->axes
                           [job->axis_count++])) return aob_fail(error,
                                                                 "axis %zu of a job `tune` makes no sense",
                                                                 at);
    for (size_t v = 0; v < job->view_count; v++)
        for (size_t i = 0; i < job->axis_count; i++)
            if (job->axes[i].index >= job->views[v].frame.param_count)
                return aob_fail(error, "axis %zu of a job `tune` is of no parameter", i);
    return true;
}

bool aob_tune_job_from_json(const json_t *object, struct aob_tune_job *job, struct aob_error *error)
{
    const json_t *views, *axes;
    int probe;
    *job = (struct aob_tune_job){0};
    if (json_unpack(borrow(object), "{s:o, s:o, s:b, s:i, s:i, s:F}", "views", &views, "axes", &axes, "probe",
                    &probe, "global", &job->global, "local", &job->local, "step", &job->step) != 0 ||
        !json_array_size(views) || !json_array_size(axes))
        return aob_fail(error, "a job `tune` lacks views, axes or how long it searches");
    job->probe = probe;
    return read_views(views, job, error) && read_axes(axes, job, error);
}

void aob_tune_job_finish(struct aob_tune_job *job)
{
    free(job->views);
    *job = (struct aob_tune_job){0};
}

json_t *aob_tune_progress_to_json(const struct aob_tune_progress *progress)
{
    return json_pack("{s:i, s:i, s:o}", "done", progress->done, "of", progress->of, "least",
                     aob_json_number(progress->error));
}

bool aob_tune_progress_from_json(const json_t *object, struct aob_tune_progress *progress)
{
    progress->error = aob_json_to_number(json_object_get(object, "least"));
    return json_unpack(borrow(object), "{s:i, s:i}", "done", &progress->done, "of", &progress->of) == 0;
}

json_t *aob_tune_result_to_json(const struct aob_tune_result *result)
{
    json_t *idle = json_array();
    for (size_t i = 0; i < result->count; i++)
        json_array_append_new(idle, json_boolean(result->idle[i]));
    return json_pack("{s:o, s:o, s:o, s:o, s:i}", "values", aob_json_vector(result->values, result->count),
                     "idle", idle, "start_error", aob_json_number(result->start_error), "error",
                     aob_json_number(result->error), "evaluations", result->evaluations);
}

bool aob_tune_result_from_json(const json_t *object, struct aob_tune_result *result)
{
    const json_t *values = json_object_get(object, "values"), *idle = json_object_get(object, "idle");
    *result = (struct aob_tune_result){.count = json_array_size(values)};
    if (!result->count || result->count > AOB_MAX_PARAM || json_array_size(idle) != result->count ||
        !aob_json_to_vector(values, result->values, result->count))
        return false;
    for (size_t i = 0; i < result->count; i++)
        result->idle[i] = json_is_true(json_array_get(idle, i));
    result->start_error = aob_json_to_number(json_object_get(object, "start_error"));
    result->error = aob_json_to_number(json_object_get(object, "error"));
    return json_unpack(borrow(object), "{s:i}", "evaluations", &result->evaluations) == 0;
}
