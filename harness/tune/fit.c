#include "fit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "axes.h"
#include "base/memory.h"
#include "search.h"
#include "sight.h"

/* A fit while it goes on. */
struct fit {
    struct aob_worker *worker;
    struct aob_tune_job job;
    struct aob_tune_sight *sights;
    bool idle[AOB_MAX_PARAM];
    int done, of;
    double least;
    struct aob_error error; /* why the last place could not be drawn */
};

static void tell(struct fit *fit, double error)
{
    fit->done++;
    fit->least = fmin(fit->least, error);
    aob_worker_reply(fit->worker, aob_tune_progress_to_json(&(struct aob_tune_progress){
                                      .done = fit->done, .of = fit->of, .error = fit->least}));
}

/* Of the views that have something to find, the mean of their errors; INFINITY where one cannot be drawn. `values` NULL: each view's own. */
static double mean_error(struct fit *fit, const double *values)
{
    double sum = 0;
    size_t count = 0;
    for (size_t v = 0; v < fit->job.view_count; v++) {
        const struct aob_job_frame *frame = &fit->job.views[v].frame;
        double params[AOB_MAX_PARAM];
        memcpy(params, frame->params, sizeof params);
        for (size_t i = 0; values && i < fit->job.axis_count; i++)
            params[fit->job.axes[i].index] = values[i] * fit->job.axes[i].scale;
        if (!fit->sights[v].count)
            continue;
        if (!aob_tune_sight_draw(&fit->sights[v], params, frame->param_count, &fit->error))
            return INFINITY;
        sum += aob_tune_sight_error(&fit->sights[v]);
        count++;
    }
    return sum / (double)count;
}

/* Axes that are idle have no coordinate in the search. */
static void place_values(const struct fit *fit, const double *place, double *values)
{
    for (size_t i = 0; i < fit->job.axis_count; i++)
        values[i] = fit->idle[i] ? fit->job.axes[i].start : aob_tune_axis_value(&fit->job.axes[i], *place++);
}

static double measure(void *user, const double *place)
{
    struct fit *fit = user;
    double values[AOB_MAX_PARAM];
    place_values(fit, place, values);
    double error = mean_error(fit, values);
    tell(fit, error);
    return error;
}

/* An axis changes nothing if the error is the same to the bit at both of its ends, all else at its start. */
static void probe(struct fit *fit, const double *start, double error)
{
    double values[AOB_MAX_PARAM];
    for (size_t i = 0; i < fit->job.axis_count; i++) {
        memcpy(values, start, fit->job.axis_count * sizeof *values);
        fit->idle[i] = true;
        for (int end = 0; end < 2 && fit->idle[i]; end++) {
            values[i] = aob_tune_axis_value(&fit->job.axes[i], end);
            fit->idle[i] = mean_error(fit, values) == error;
        }
        tell(fit, error);
    }
}

static bool judge_views(const struct fit *fit, struct aob_error *error)
{
    for (size_t v = 0; v < fit->job.view_count; v++)
        if (fit->sights[v].count)
            return true;
    return aob_fail(error, "no view that is fitted has occlusion within the target's radius: choose other "
                           "views, or a larger target");
}

static bool run(struct fit *fit, struct aob_tune_result *result, struct aob_error *error)
{
    struct aob_search_desc search = {
        .global = fit->job.global, .local = fit->job.local, .step = fit->job.step, measure, fit};
    double start[AOB_MAX_PARAM], best[AOB_MAX_PARAM];
    fit->of = 1 + search.global + search.local + (fit->job.probe ? (int)fit->job.axis_count : 0);
    result->count = fit->job.axis_count;
    result->start_error = mean_error(fit, NULL);
    if (!isfinite(result->start_error))
        return aob_fail(error, "without a fit: %s", fit->error.text);
    for (size_t i = 0; i < fit->job.axis_count; i++)
        start[i] = fit->job.axes[i].start;
    if (fit->job.probe)
        probe(fit, start, mean_error(fit, start));
    for (size_t i = 0; i < fit->job.axis_count; i++)
        if (!fit->idle[i])
            best[search.count++] = aob_tune_axis_place(&fit->job.axes[i], start[i]);
    memcpy(start, best, search.count * sizeof *start);
    search.start = start;
    if (!search.count)
        return aob_fail(error, "none of the parameters changes an image here: name others with --params");
    result->error = aob_search_run(&search, best);
    place_values(fit, best, result->values);
    memcpy(result->idle, fit->idle, sizeof result->idle);
    result->evaluations = fit->done;
    return true;
}

static bool open_sights(struct fit *fit, struct aob_error *error)
{
    fit->sights = AOB_NEW_ARRAY(struct aob_tune_sight, fit->job.view_count);
    for (size_t v = 0; v < fit->job.view_count; v++)
        if (!aob_tune_sight_open(&fit->sights[v], &fit->job.views[v], error))
            return false;
    return judge_views(fit, error);
}

static bool run_tune(struct aob_worker *worker, struct aob_error *error)
{
    struct fit *fit = AOB_NEW(struct fit);
    struct aob_tune_result result = {.count = 0};
    fit->worker = worker;
    fit->least = INFINITY;
    bool ok = aob_tune_job_from_json(worker->job, &fit->job, error) && open_sights(fit, error) &&
              run(fit, &result, error);
    if (ok)
        aob_worker_reply(worker, aob_tune_result_to_json(&result));
    for (size_t v = 0; fit->sights && v < fit->job.view_count; v++)
        aob_tune_sight_close(&fit->sights[v]);
    free(fit->sights);
    aob_tune_job_finish(&fit->job);
    free(fit);
    return ok;
}

const struct aob_worker_job aob_worker_tune = {"tune", run_tune};
