#include "block.h"
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "frame/frame.h"
#include "timing/fixed_pass.h"
#include "timing/timing.h"
#include "technique/param.h"

static double seconds_since(int64_t start)
{
    return (double)(aob_clock_wall_ns() - start) * 1e-9;
}

static json_t *fingerprint(const struct aob_block *block)
{
    char processor[256];
    const char *threads = getenv("LP_NUM_THREADS");
    aob_machine_processor(processor, sizeof processor);
    return json_pack("{s:s, s:s, s:i, s:s, s:s, s:s, s:i, s:s}", "program", AOBUDGET_VERSION, "cpu",
                     processor, "cores", aob_machine_cores(), "backend", block->gpu->info.backend, "device",
                     block->gpu->info.device, "driver", block->gpu->info.driver, "fixed_pass",
                     (int)aob_technique_fixed_pass.revision, "threads", threads ? threads : "default");
}

static void reply_failure(struct aob_worker *worker, size_t index, const char *status, const char *reason)
{
    aob_worker_reply(worker,
                     json_pack("{s:i, s:s, s:s}", "index", (int)index, "status", status, "reason", reason));
}

static void reply_all(struct aob_worker *worker, const struct aob_block *block, const char *status,
                      const char *reason)
{
    for (size_t i = 0; i < json_array_size(block->cases); i++)
        reply_failure(worker, i, status, reason);
}

static bool get_block(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    const char *gbuffer;
    block->job = worker->job;
    block->cases = json_object_get(worker->job, "cases");
    if (json_unpack((json_t *)(uintptr_t)worker->job, "{s:i, s:i, s:i, s:s, s:F, s:b, s:b}", "width",
                    &block->width, "height", &block->height, "guard", &block->guard, "gbuffer", &gbuffer,
                    "seconds", &block->seconds, "time", &block->time, "error", &block->error) != 0 ||
        json_array_size(block->cases) < 1 || json_array_size(block->cases) > AOB_BLOCK_MAX)
        return aob_fail(error, "a block job lacks a field");
    return aob_worker_camera(json_object_get(worker->job, "camera"), &block->camera, error) &&
           (aob_gbuffer_load(&block->gbuffer, gbuffer, &block->camera, block->width, block->height,
                             block->guard, error) ||
            aob_block_drop_damaged(gbuffer, error));
}

/* The screen in the encodings of these options, made when it is first wanted. */
static const struct aob_screen *use_screen(struct aob_block *block, const struct aob_options *options,
                                           struct aob_error *error)
{
    for (size_t i = 0; i < block->screen_count; i++) {
        const struct aob_options *o = &block->screen_options[i];
        if (o->depth_encoding == options->depth_encoding && o->normal_encoding == options->normal_encoding &&
            o->normals == options->normals && o->fetch == options->fetch && o->near == options->near &&
            o->far == options->far)
            return &block->screens[i];
    }
    struct aob_screen *screen = &block->screens[block->screen_count];
    const struct aob_gbuffer *seen = block->drawn.depth ? &block->drawn : &block->gbuffer;
    if (!aob_screen_init(screen, block->gpu, seen, options, error))
        return NULL;
    screen->geometry = block->geometry.count ? &block->geometry : NULL;
    block->screen_options[block->screen_count++] = *options;
    return screen;
}

static bool get_options(const json_t *c, struct aob_options *options, struct aob_error *error)
{
    double numbers[AOB_OPTION_COUNT];
    if (!aob_json_to_vector(json_object_get(c, "options"), numbers, AOB_OPTION_COUNT))
        return aob_fail(error, "the job has not %d options", AOB_OPTION_COUNT);
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, numbers, options, sizeof *options);
    return true;
}

static void init_frame(struct aob_worker *worker, struct aob_block *block, size_t index)
{
    const json_t *c = json_array_get(block->cases, index);
    const char *name = json_string_value(json_object_get(c, "technique"));
    const struct aob_registry_entry *entry = aob_registry_find(&block->registry, name ? name : "");
    struct aob_error error = {{0}};
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    const struct aob_screen *screen = NULL;
    int64_t start = aob_clock_wall_ns();
    if (!entry) {
        reply_failure(worker, index, "failed", "the technique is not in this worker");
        return;
    }
    if (!aob_worker_params(entry->technique, json_object_get(c, "params"), values, &error) ||
        !get_options(c, &options, &error) || !(screen = use_screen(block, &options, &error)) ||
        !aob_frame_init(&block->frames[block->frame_count], screen, entry->technique, values,
                        (enum aob_fetch)options.fetch, &error)) {
        reply_failure(worker, index, block->frames[block->frame_count].unfit ? "unsupported" : "failed",
                      error.text);
        return;
    }
    block->setup_ms[block->frame_count] = seconds_since(start) * 1e3;
    block->case_of_frame[block->frame_count++] = index;
}

/* One timing run of some of the block's frames; its results go to their places. */
static bool time_frames(struct aob_block *block, const size_t *which, size_t count, struct aob_error *error)
{
    struct aob_frame *frames[AOB_BLOCK_MAX];
    struct aob_block_timing timing;
    for (size_t i = 0; i < count; i++)
        frames[i] = &block->frames[which[i]];
    if (!aob_timing_run(&(struct aob_timing_desc){.fixed = &block->fixed,
                                                  .frames = frames,
                                                  .frame_count = count,
                                                  .seconds = block->seconds,
                                                  .seed = 1,
                                                  .wall = !block->gpu->info.software},
                        &timing, error))
        return false;
    for (size_t i = 0; i < count; i++) {
        block->timing[which[i]] = timing;
        block->timing[which[i]].cases[0] = timing.cases[i];
        block->measured_s += timing.cases[i].measured_s;
    }
    block->measured_s += timing.fixed_s;
    return true;
}

/* A frame in milliseconds of this process, after the driver has compiled it. */
static bool probe_cost(struct aob_block *block, size_t f, double *ms, struct aob_error *error)
{
    int64_t start = 0;
    for (int i = 0; i < 2; i++) {
        start = aob_clock_cpu_ns();
        if (!aob_frame_run(&block->frames[f], NULL, error))
            return false;
    }
    *ms = (double)(aob_clock_cpu_ns() - start) * 1e-6;
    return true;
}

/* A case dearer than 100 ms a frame is timed by itself: it would take the rounds of its neighbours. */
static bool measure_time(struct aob_block *block, struct aob_error *error)
{
    size_t cheap[AOB_BLOCK_MAX], cheap_count = 0;
    double ms;
    for (size_t f = 0; f < block->frame_count; f++) {
        if (!probe_cost(block, f, &ms, error))
            return false;
        if (ms <= 100)
            cheap[cheap_count++] = f;
        else if (!time_frames(block, &f, 1, error))
            return false;
    }
    return !cheap_count || time_frames(block, cheap, cheap_count, error);
}

static json_t *time_to_json(const struct aob_block *block, size_t f)
{
    const struct aob_block_timing *run = &block->timing[f];
    const struct aob_timing *t = &run->cases[0];
    const struct aob_frame *frame = &block->frames[f];
    const char *threads = getenv("LP_NUM_THREADS");
    json_t *passes = json_array();
    for (int p = 0; p < frame->graph.pass_count; p++)
        if (frame->passes[p])
            json_array_append_new(passes, json_pack("{s:s, s:f}", "name", frame->graph.passes[p].name,
                                                    "cpu_ms", t->pass_cpu_ms[p]));
    bool bounded = t->to_fixed.bounded;
    return json_pack("{s:s, s:f, s:o, s:f, s:o, s:o, s:i, s:i, s:i, s:f, s:f, s:f, s:f, s:o}", "clock",
                     block->gpu->info.software ? "cpu" : "wall", "cpu_ms", t->cpu_ms, "wall_ms",
                     aob_json_number(t->wall_ms), "ratio_to_ref", t->to_fixed.ratio, "ci_low",
                     bounded ? json_real(t->to_fixed.low) : json_null(), "ci_high",
                     bounded ? json_real(t->to_fixed.high) : json_null(), "rounds", (int)t->rounds,
                     "clean_rounds", (int)t->clean_rounds, "threads",
                     threads ? atoi(threads) : aob_machine_cores(), "setup_ms", block->setup_ms[f],
                     "ref_cpu_ms", run->fixed_cpu_ms, "control_low", run->control.low, "control_high",
                     run->control.high, "passes", passes);
}

static void reply_case(struct aob_worker *worker, struct aob_block *block, size_t f)
{
    struct aob_error error = {{0}};
    json_t *answer = json_pack("{s:i, s:s, s:I, s:o}", "index", (int)block->case_of_frame[f], "status",
                               "failed", "memory_bytes", (json_int_t)block->frames[f].memory_bytes,
                               "fingerprint", fingerprint(block));
    if (block->difference)
        json_object_set(answer, "gbuffer", block->difference);
    if (aob_block_finish_case(block, f, answer, &error)) {
        json_object_set_new(answer, "status", json_string("ok"));
        if (block->time)
            json_object_set_new(answer, "time", time_to_json(block, f));
    } else
        json_object_set_new(answer, "reason", json_string(error.text));
    aob_worker_reply(worker, answer);
}

static void reply_shares(struct aob_worker *worker, const struct aob_block *block)
{
    aob_worker_reply(worker, json_pack("{s:{s:f, s:f, s:f}}", "shares", "measured_s", block->measured_s,
                                       "warmup_s", block->warmup_s, "images_s", block->images_s));
}

/* The scene itself, where the cases need more of it than the G-buffer. */
static bool load_scene(struct aob_block *block, struct aob_error *error)
{
    bool triangles = json_is_true(json_object_get(block->job, "triangles"));
    if (!triangles && !json_is_true(json_object_get(block->job, "raster")))
        return true;
    if (!aob_worker_mesh(block->job, &block->mesh, error))
        return false;
    if (triangles)
        aob_geometry_init(&block->geometry, &block->mesh, &block->camera);
    return !triangles || aob_geometry_upload(&block->geometry, block->gpu, error);
}

static bool open_device(struct aob_block *block, struct aob_error *error)
{
    const char *backend = json_string_value(json_object_get(block->job, "backend"));
    bool validate = json_is_true(json_object_get(block->job, "validate"));
    block->gpu = aob_gpu_open(backend ? backend : "", &(struct aob_gpu_desc){.validate = validate}, error);
    return block->gpu && load_scene(block, error) && aob_block_draw(block, error) &&
           use_screen(block, &(struct aob_options){0}, error);
}

static bool run_cases(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    for (size_t i = 0; i < json_array_size(block->cases); i++)
        init_frame(worker, block, i);
    if (block->time && block->frame_count &&
        !aob_frame_init(&block->fixed, &block->screens[0], &aob_technique_fixed_pass, &(int32_t){0},
                        AOB_FETCH_SAMPLED, error))
        return false;
    if (block->time && block->frame_count && !measure_time(block, error))
        return false;
    block->warmup_s = seconds_since(start) - block->measured_s; /* compiling, probing, warming up */
    for (size_t f = 0; f < block->frame_count; f++)
        reply_case(worker, block, f);
    reply_shares(worker, block);
    return true;
}

bool aob_worker_block(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_block *block = AOB_NEW(struct aob_block);
    bool ok = get_block(worker, block, error) && aob_worker_registry(worker, &block->registry, error);
    if (ok && !open_device(block, error))
        reply_all(worker, block, "unsupported", error->text);
    else if (ok)
        ok = run_cases(worker, block, error);
    for (size_t f = 0; f < block->frame_count; f++)
        aob_frame_finish(&block->frames[f]);
    aob_frame_finish(&block->fixed);
    for (size_t i = 0; i < block->screen_count; i++)
        aob_screen_finish(&block->screens[i]);
    aob_geometry_finish(&block->geometry);
    aob_mesh_finish(&block->mesh);
    aob_gpu_close(block->gpu);
    aob_gbuffer_finish(&block->drawn);
    json_decref(block->difference);
    aob_gbuffer_finish(&block->gbuffer);
    aob_registry_finish(&block->registry);
    free(block);
    return ok;
}
