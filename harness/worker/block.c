#include "block.h"
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "technique/param.h"
#include "timing/fixed_pass.h"

static double seconds_since(int64_t start)
{
    return (double)(aob_clock_wall_ns() - start) * 1e-9;
}

static json_t *fingerprint(const struct aob_block *block)
{
    char processor[256];
    const char *threads = getenv("LP_NUM_THREADS");
    aob_machine_processor(processor, sizeof processor);
    const struct aob_gpu_info *gpu = &block->gpu->info;
    return json_pack("{s:s, s:o, s:i, s:s, s:o, s:o, s:s, s:i, s:o}", "program", AOBUDGET_VERSION, "cpu",
                     aob_json_text(processor), "cores", aob_machine_cores(), "backend", gpu->backend,
                     "device", aob_json_text(gpu->device), "driver", aob_json_text(gpu->driver), "class",
                     gpu->device_class, "fixed_pass", (int)aob_technique_fixed_pass.revision, "threads",
                     aob_json_text(threads ? threads : "default"));
}

static void reply_failure(struct aob_worker *worker, size_t index, const char *status, const char *reason)
{
    aob_worker_reply(worker,
                     json_pack("{s:i, s:s, s:s}", "index", (int)index, "status", status, "reason", reason));
}

static void reply_all(struct aob_worker *worker, const struct aob_block *block, const char *status,
                      const char *reason)
{
    for (size_t i = 0; i < block->job.case_count; i++)
        reply_failure(worker, i, status, reason);
}

static bool load_gbuffer(struct aob_block *block, struct aob_error *error)
{
    const struct aob_job_view *view = &block->job.view;
    const struct aob_gbuffer_desc desc = {&view->camera, view->width, view->height, view->guard};
    return aob_gbuffer_load(&block->gbuffer, view->gbuffer, &desc, error);
}

static bool same_encoding(const struct aob_options *a, const struct aob_options *b)
{
    return a->depth_encoding == b->depth_encoding && a->normal_encoding == b->normal_encoding &&
           a->normals == b->normals && a->fetch == b->fetch && a->near == b->near && a->far == b->far;
}

/* The screen in the encodings of these options, made when it is first wanted. NULL after a line; `unfit`: the device lacks what
 * they need. */
static const struct aob_screen *use_screen(struct aob_block *block, const struct aob_options *options,
                                           bool *unfit, struct aob_error *error)
{
    for (size_t i = 0; i < block->screen_count; i++)
        if (same_encoding(&block->screen_options[i], options))
            return &block->screens[i];
    struct aob_screen *screen = &block->screens[block->screen_count];
    const struct aob_gbuffer *seen = block->drawn.depth ? &block->drawn : &block->gbuffer;
    bool ok = aob_screen_init(screen, block->gpu, seen, options, error);
    *unfit = screen->unfit;
    if (!ok)
        return NULL;
    screen->geometry = block->geometry.count ? &block->geometry : NULL;
    block->screen_options[block->screen_count++] = *options;
    return screen;
}

/* False: its status and reason are in the two last. */
static bool init_frame(struct aob_block *block, size_t index, const char **status, struct aob_error *error)
{
    const struct aob_block_case *c = &block->job.cases[index];
    struct aob_frame *frame = &block->frames[block->frame_count];
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    const struct aob_screen *screen = NULL;
    const struct aob_technique *technique = aob_registry_open(&block->registry, &c->technique, error);
    bool unfit = false;
    *status = "failed";
    if (!technique)
        return false;
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, c->options, &options, sizeof options);
    if (!aob_worker_values(technique, c->params, c->param_count, values, error))
        return false;
    if (!(screen = use_screen(block, &options, &unfit, error))) {
        *status = unfit ? "unsupported" : "failed";
        return false;
    }
    int64_t start = aob_clock_wall_ns();
    if (!aob_frame_init(frame, screen, technique, values, (enum aob_fetch)options.fetch, error)) {
        *status = frame->unfit ? "unsupported" : "failed";
        return false;
    }
    block->setup_ms[block->frame_count] = seconds_since(start) * 1e3;
    block->case_of_frame[block->frame_count++] = index;
    return true;
}

/* A case that has no frame is told where cases are judged; a process that only times has failed then. */
static bool init_frames(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    for (size_t i = 0; i < block->job.case_count; i++) {
        struct aob_error why = {{0}};
        const char *status;
        if (init_frame(block, i, &status, &why))
            continue;
        if (!block->job.score)
            return aob_fail(error, "%s", why.text);
        reply_failure(worker, i, status, why.text);
    }
    return true;
}

static void reply_case(struct aob_worker *worker, struct aob_block *block, size_t f)
{
    struct aob_error error = {{0}};
    json_t *answer = json_pack("{s:i, s:s, s:I, s:o}", "index", (int)block->case_of_frame[f], "status",
                               "failed", "memory_bytes", (json_int_t)block->frames[f].memory_bytes,
                               "fingerprint", fingerprint(block));
    if (block->difference)
        json_object_set(answer, "gbuffer", block->difference);
    block->good[f] = aob_block_score(block, f, answer, &error);
    if (block->good[f])
        json_object_set_new(answer, "status", json_string("ok"));
    else
        json_object_set_new(answer, "reason", json_string(error.text));
    aob_worker_reply(worker, answer);
}

/* The scene itself, where the cases need more of it than the G-buffer. */
static bool load_scene(struct aob_block *block, struct aob_error *error)
{
    if (!block->job.triangles && !block->job.raster)
        return true;
    if (!aob_worker_load(&block->job.view, &block->mesh, error))
        return false;
    if (!block->job.triangles)
        return true;
    aob_geometry_init(&block->geometry, &block->mesh, &block->job.view.camera);
    return aob_geometry_upload(&block->geometry, block->gpu, error);
}

static bool open_device(struct aob_block *block, struct aob_error *error)
{
    const struct aob_gpu_desc desc = {.validate = block->job.validate, .device = block->job.device};
    bool unfit; /* whatever stops a block here is no case's fault */
    block->gpu = aob_gpu_open(block->job.backend, &desc, error);
    return block->gpu && load_scene(block, error) && aob_block_draw(block, error) &&
           use_screen(block, &(struct aob_options){0}, &unfit, error);
}

/* Images come first, so that only what is worth it is timed. */
static bool run_cases(struct aob_worker *worker, struct aob_block *block, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    if (!init_frames(worker, block, error))
        return false;
    for (size_t f = 0; block->job.score && f < block->frame_count; f++)
        reply_case(worker, block, f);
    if (block->job.time && !aob_block_measure(worker, block, error))
        return false;
    /* compiling, probing, warming up */
    block->shares.warmup = seconds_since(start) - block->shares.measured - block->shares.images;
    aob_worker_reply(worker, aob_block_shares_to_json(&block->shares));
    return true;
}

static void finish_block(struct aob_block *block)
{
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
    aob_block_job_finish(&block->job);
    free(block);
}

static bool run_block(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_block *block = AOB_NEW(struct aob_block);
    aob_registry_init(&block->registry);
    bool ok = aob_block_job_from_json(worker->job, &block->job, error) && load_gbuffer(block, error);
    bool opened = ok && open_device(block, error);
    if (opened)
        ok = run_cases(worker, block, error);
    else if (ok && block->job.score)
        reply_all(worker, block, "unsupported", error->text);
    else
        ok = false;
    finish_block(block);
    return ok;
}

const struct aob_worker_job aob_worker_block = {"block", run_block};
