#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "drawing.h"
#include "frame/count.h"
#include "frame/past.h"
#include "frame/trace.h"
#include "job/cache_job.h"
#include "profile/simulate.h"
#include "store/image.h"
#include "worker.h"

/* What a simulated word takes on this class of machine, in both orders and with the curve (docs/cache.md). */
static const double word_s = 1e-7;

/* What counting takes, for each case and for each fetch of it. */
static const double count_s = 0.4, count_word_s = 2e-8;

/* One case and its profiles while they are worked on. */
struct cached {
    struct aob_cache_job job;
    struct aob_drawing drawing;
    struct aob_profile *profiles; /* those of the job, and what simulates them */
    struct aob_simulation **simulations;
    struct aob_room room; /* that all of them share */
    struct aob_drawing_part part;
    struct aob_trace trace;
    struct aob_frame plain;      /* the same frame without a trace */
    struct aob_past past;        /* what the plain frame before it left, where it keeps a history; */
    bool has_past;               /* then true */
    struct aob_gbuffer poses[2]; /* of the sequence, drawn last */
    struct aob_error uncounted;  /* why it has no operations, where a profile has use for them */
};

static void reply_all(struct aob_worker *worker, const struct cached *cached, const char *status,
                      const char *reason)
{
    for (size_t i = 0; i < cached->job.profile_count; i++)
        aob_worker_reply(worker,
                         aob_cache_answer_to_json(&(struct aob_cache_answer){i, status, reason, NULL}));
}

/* What was planned is what is simulated. */
static bool read_profiles(struct cached *cached, struct aob_error *error)
{
    cached->profiles = AOB_NEW_ARRAY(struct aob_profile, cached->job.profile_count);
    cached->simulations = AOB_NEW_ARRAY(struct aob_simulation *, cached->job.profile_count);
    for (size_t i = 0; i < cached->job.profile_count; i++) {
        char digest[AOB_KEY_SIZE];
        if (!aob_profile_read(&cached->profiles[i], cached->job.profiles[i].path, error))
            return false;
        aob_profile_digest(&cached->profiles[i], digest);
        if (strcmp(digest, cached->job.profiles[i].digest) != 0)
            return aob_fail(error, "%s: it has changed since the run was planned: run again",
                            cached->job.profiles[i].path);
        cached->simulations[i] = aob_simulation_create(&(struct aob_simulation_desc){
            &cached->profiles[i], AOB_CURVE_POWERS, cached->job.map, AOB_FLIGHT_MOST, &cached->room});
    }
    return true;
}

static const struct aob_past *past_of(const struct cached *cached)
{
    return cached->has_past ? &cached->past : NULL;
}

/* The next one, once those before have been drawn; the numbers of a sequence count from 0. */
static bool draw_plain(struct cached *cached, int number, struct aob_error *error)
{
    return aob_frame_set(&cached->plain, number, cached->part.values, error) &&
           aob_frame_run(&cached->plain, 1, NULL, error);
}

static bool draw_pose(struct cached *cached, int number, struct aob_error *error)
{
    const struct aob_job_view *view = &cached->job.drawing.view;
    const struct aob_job_pose *pose = &cached->job.poses[number];
    const struct aob_gbuffer_desc desc = {&pose->camera, view->width, view->height, view->guard,
                                          pose->frame > 0};
    struct aob_gbuffer *gbuffer = &cached->poses[number % 2];
    aob_gbuffer_finish(gbuffer);
    return aob_gbuffer_load(gbuffer, pose->gbuffer, &desc, error) &&
           aob_drawing_show(&cached->drawing, gbuffer, &pose->camera, error) &&
           draw_plain(cached, number, error);
}

/* What a technique with a history has before the frame that is traced: the sequence, or the same view once. */
static bool draw_past(struct cached *cached, struct aob_error *error)
{
    int poses = (int)cached->job.pose_count;
    bool ok = true;
    if (!aob_graph_keeps_history(&cached->plain.graph))
        return true;
    for (int i = 0; ok && i < poses; i++)
        ok = draw_pose(cached, i, error);
    if (ok && poses)
        ok = aob_drawing_show(&cached->drawing, &cached->drawing.gbuffer, &cached->job.drawing.view.camera,
                              error);
    else if (ok)
        ok = draw_plain(cached, 0, error);
    aob_past_take(&cached->plain, &cached->past);
    cached->has_past = true;
    return ok;
}

/* The frame as it is timed, after those before it. */
static bool init_plain(struct cached *cached, bool *unfit, struct aob_error *error)
{
    const struct aob_drawing_part *part = &cached->part;
    const struct aob_frame_desc plain = {
        .technique = part->technique, .values = part->values, .fetch = part->fetch, .wanted = part->wanted};
    bool ok = aob_frame_init_desc(&cached->plain, part->screen, &plain, error);
    *unfit = cached->plain.unfit;
    return ok && draw_past(cached, error) &&
           draw_plain(cached, cached->has_past ? cached->past.number + 1 : 0, error);
}

/* False: *status says what the refusal is. */
static bool init_trace(struct cached *cached, const char **status, struct aob_error *error)
{
    struct aob_drawing_part *part = &cached->part;
    bool unfit = false;
    *status = "failed";
    if (!aob_drawing_set(&cached->drawing, &cached->job.frame, part, error) ||
        !init_plain(cached, &unfit, error)) {
        *status = part->unfit || unfit ? "unsupported" : "failed";
        return false;
    }
    if (!aob_trace_init(&cached->trace,
                        &(struct aob_trace_desc){.screen = part->screen,
                                                 .technique = part->technique,
                                                 .values = part->values,
                                                 .fetch = part->fetch,
                                                 .wanted = part->wanted,
                                                 .past = past_of(cached)},
                        error)) {
        *status = cached->trace.unfit ? "unsupported" : "failed";
        return false;
    }
    return true;
}

static bool wants_operations(const struct cached *cached)
{
    for (size_t i = 0; i < cached->job.profile_count; i++)
        if (cached->profiles[i].rates.clock > 0)
            return true;
    return false;
}

static void reply_capture(struct aob_worker *worker, const struct cached *cached)
{
    const struct aob_trace_cost *cost = &cached->trace.cost;
    double counting_s = wants_operations(cached) ? count_s + cost->words * count_word_s : 0;
    aob_worker_reply(worker, aob_cache_capture_to_json(&(struct aob_cache_capture){
                                 .words = cost->words,
                                 .strips = (double)cost->strips,
                                 .seconds = cost->seconds + counting_s +
                                            cost->words * word_s * (double)cached->job.profile_count}));
}

static bool capture(struct cached *cached, size_t *differ, struct aob_error *error)
{
    size_t count = cached->job.profile_count;
    struct aob_trace_sink *sinks = AOB_NEW_ARRAY(struct aob_trace_sink, count);
    for (size_t i = 0; i < count; i++)
        sinks[i] = aob_simulation_sink(cached->simulations[i]);
    struct aob_trace_fan fan = {sinks, count};
    const struct aob_trace_sink sink = aob_trace_fan_sink(&fan);
    bool ok = aob_trace_run(&cached->trace, &sink, error) &&
              aob_trace_compare(&cached->trace, &cached->plain, differ, error);
    free(sinks);
    return ok;
}

static void take_operations(struct cached *cached, const struct aob_count *count)
{
    for (size_t i = 0; i < cached->job.profile_count; i++) {
        const struct aob_cache_result *result = aob_simulation_result(cached->simulations[i]);
        for (size_t p = 0; p < result->pass_count; p++)
            aob_simulation_count(cached->simulations[i], p, &count->passes[result->passes[p].index].whole);
    }
}

/* A case that cannot be counted here keeps its other figures. */
static bool count_operations(struct cached *cached, struct aob_error *error)
{
    struct aob_count count;
    const struct aob_count_desc desc = {.screen = cached->part.screen,
                                        .technique = cached->part.technique,
                                        .values = cached->part.values,
                                        .fetch = cached->part.fetch,
                                        .wanted = cached->part.wanted,
                                        .past = past_of(cached)};
    if (!wants_operations(cached))
        return true;
    if (!aob_count_init(&count, &desc, error)) {
        cached->uncounted = *error;
        return count.unfit;
    }
    bool ok = aob_count_run(&count, error);
    if (ok)
        take_operations(cached, &count);
    else
        cached->uncounted = *error;
    ok |= count.unfit;
    aob_count_finish(&count);
    return ok;
}

/* How many of `whole` lie on number `at` of `part`, where at = i * part / whole. */
static int share(int at, int part, int whole)
{
    return ((at + 1) * whole + part - 1) / part - (at * whole + part - 1) / part;
}

/* A pixel of a smaller pass is spread over those of the frame that it stands for, so that the sum stays. */
static void add_map(const struct aob_cache_pass *pass, const struct aob_cache_pass *frame, float *map)
{
    for (int y = 0; y < frame->height; y++)
        for (int x = 0; x < frame->width; x++) {
            int px = (int)((int64_t)x * pass->width / frame->width),
                py = (int)((int64_t)y * pass->height / frame->height);
            int parts = share(px, pass->width, frame->width) * share(py, pass->height, frame->height);
            map[(size_t)y * (size_t)frame->width + (size_t)x] +=
                pass->map[(size_t)py * (size_t)pass->width + (size_t)px] / (float)parts;
        }
}

static bool write_map(const struct cached *cached, struct aob_error *error)
{
    const struct aob_cache_pass *frame = &aob_simulation_result(cached->simulations[0])->frame;
    struct aob_image image = {.width = frame->width, .height = frame->height};
    for (size_t i = 0; i < cached->job.profile_count; i++) {
        const struct aob_cache_result *result = aob_simulation_result(cached->simulations[i]);
        struct aob_text name = {0};
        aob_text_add(&name, "%s.misses", cached->profiles[i].name);
        float *map = aob_image_add(&image, name.data);
        for (size_t p = 0; p < result->pass_count; p++)
            add_map(&result->passes[p], frame, map);
        aob_text_finish(&name);
    }
    bool ok = aob_image_write(&image, cached->job.map, error);
    aob_image_finish(&image);
    return ok;
}

static void reply_figures(struct aob_worker *worker, const struct cached *cached, size_t differ)
{
    for (size_t i = 0; i < cached->job.profile_count; i++) {
        json_t *figures = aob_cache_result_to_json(aob_simulation_result(cached->simulations[i]));
        json_object_set_new(figures, "digest", json_string(cached->job.profiles[i].digest));
        json_object_set_new(figures, "line_bytes", json_integer(cached->profiles[i].levels[0].line));
        json_object_set_new(figures, "texels_differ", json_integer((json_int_t)differ));
        if (*cached->uncounted.text && cached->profiles[i].rates.clock > 0)
            json_object_set_new(figures, "not_modelled", json_string(cached->uncounted.text));
        aob_worker_reply(worker,
                         aob_cache_answer_to_json(&(struct aob_cache_answer){i, "ok", NULL, figures}));
        json_decref(figures);
    }
}

static bool run_case(struct aob_worker *worker, struct cached *cached, const char **status,
                     struct aob_error *error)
{
    size_t differ = 0;
    *status = "unsupported";
    if (!aob_drawing_open(&cached->drawing, error) || !init_trace(cached, status, error))
        return false;
    *status = "failed";
    reply_capture(worker, cached);
    if (!capture(cached, &differ, error) || !count_operations(cached, error) ||
        (cached->job.map && !write_map(cached, error)))
        return false;
    reply_figures(worker, cached, differ);
    return true;
}

static void finish(struct cached *cached)
{
    aob_frame_finish(&cached->plain);
    aob_trace_finish(&cached->trace);
    aob_drawing_finish(&cached->drawing);
    aob_gbuffer_finish(&cached->poses[0]);
    aob_gbuffer_finish(&cached->poses[1]);
    for (size_t i = 0; cached->simulations && i < cached->job.profile_count; i++) {
        aob_simulation_destroy(cached->simulations[i]);
        aob_profile_finish(&cached->profiles[i]);
    }
    free(cached->simulations);
    free(cached->profiles);
    aob_cache_job_finish(&cached->job);
    free(cached);
}

static bool run_cache(struct aob_worker *worker, struct aob_error *error)
{
    struct cached *cached = AOB_NEW(struct cached);
    const char *status;
    bool ok = aob_cache_job_from_json(worker->job, &cached->job, error) && read_profiles(cached, error) &&
              aob_drawing_load(&cached->drawing, &cached->job.drawing, error);
    if (ok && !run_case(worker, cached, &status, error))
        reply_all(worker, cached, status, error->text);
    finish(cached);
    return ok;
}

const struct aob_worker_job aob_worker_cache = {"cache", run_cache};
