#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/clock.h"
#include "base/json.h"
#include "base/machine.h"
#include "base/memory.h"
#include "frame/frame.h"
#include "measure/fixed_pass.h"
#include "measure/score.h"
#include "measure/timing.h"
#include "store/image.h"
#include "worker.h"

/* One block while it is worked on. */
struct block {
    const json_t *job, *cases;
    struct aob_registry registry;
    struct aob_gbuffer gbuffer;
    struct aob_gpu *gpu;
    struct aob_screen screen;
    struct aob_frame fixed, frames[AOB_BLOCK_MAX];
    size_t case_of_frame[AOB_BLOCK_MAX], frame_count;
    double setup_ms[AOB_BLOCK_MAX];
    struct aob_camera camera;
    int width, height, guard;
    double seconds;
    int time, error;
    struct aob_block_timing timing;
    double setup_s, images_s;
};

static double seconds_since(int64_t start)
{
    return (double)(aob_clock_wall_ns() - start) * 1e-9;
}

static json_t *fingerprint(const struct block *block)
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

static void reply_all(struct aob_worker *worker, const struct block *block, const char *status,
                      const char *reason)
{
    for (size_t i = 0; i < json_array_size(block->cases); i++)
        reply_failure(worker, i, status, reason);
}

static bool get_block(struct aob_worker *worker, struct block *block, struct aob_error *error)
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
           aob_gbuffer_load(&block->gbuffer, gbuffer, &block->camera, block->width, block->height,
                            block->guard, error);
}

static void init_frame(struct aob_worker *worker, struct block *block, size_t index)
{
    const json_t *c = json_array_get(block->cases, index);
    const char *name = json_string_value(json_object_get(c, "technique"));
    const struct aob_registry_entry *entry = aob_registry_find(&block->registry, name ? name : "");
    struct aob_error error = {{0}};
    unsigned char values[4 * AOB_MAX_PARAM];
    int64_t start = aob_clock_wall_ns();
    if (!entry) {
        reply_failure(worker, index, "failed", "the technique is not in this worker");
        return;
    }
    if (!aob_worker_params(entry->technique, json_object_get(c, "params"), values, &error) ||
        !aob_frame_init(&block->frames[block->frame_count], &block->screen, entry->technique, values,
                        (enum aob_fetch)json_integer_value(json_object_get(c, "fetch")), &error)) {
        reply_failure(worker, index, "failed", error.text);
        return;
    }
    block->setup_ms[block->frame_count] = seconds_since(start) * 1e3;
    block->case_of_frame[block->frame_count++] = index;
}

static bool measure_time(struct block *block, struct aob_error *error)
{
    return aob_timing_run(&(struct aob_timing_desc){.fixed = &block->fixed,
                                                    .frames = block->frames,
                                                    .frame_count = block->frame_count,
                                                    .seconds = block->seconds,
                                                    .seed = 1,
                                                    .wall = !block->gpu->info.software},
                          &block->timing, error);
}

static json_t *time_to_json(const struct block *block, size_t f)
{
    const struct aob_timing *t = &block->timing.cases[f];
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
                     "ref_cpu_ms", block->timing.fixed_cpu_ms, "control_low", block->timing.control.low,
                     "control_high", block->timing.control.high, "passes", passes);
}

static bool load_channel(const char *path, const char *name, const struct block *block, float **pixels,
                         struct aob_error *error)
{
    struct aob_image image = {0};
    if (!aob_image_read(&image, path, error))
        return false;
    const float *channel = aob_image_channel(&image, name);
    size_t count = (size_t)block->width * (size_t)block->height;
    bool ok = channel && image.width == block->width && image.height == block->height;
    if (ok) {
        *pixels = AOB_NEW_ARRAY(float, count);
        memcpy(*pixels, channel, count * sizeof(float));
    }
    aob_image_finish(&image);
    return ok || aob_fail(error, "%s: not a reference of %dx%d", path, block->width, block->height);
}

/* What one case is compared with, cropped to the view. */
struct truth {
    float *depth, *ao, *se, *definition;
};

static void crop(const struct block *block, const float *from, int stride, float *into)
{
    for (int y = 0; y < block->height; y++)
        for (int x = 0; x < block->width; x++)
            into[y * block->width + x] =
                from[((size_t)(y + block->guard) * (size_t)block->gbuffer.projection.width +
                      (size_t)(x + block->guard)) *
                     (size_t)stride];
}

static bool load_truth(const struct block *block, const json_t *c, struct truth *truth,
                       struct aob_error *error)
{
    const char *reference = json_string_value(json_object_get(c, "reference"));
    const char *definition = json_string_value(json_object_get(c, "definition"));
    size_t count = (size_t)block->width * (size_t)block->height;
    truth->depth = AOB_NEW_ARRAY(float, count);
    crop(block, block->gbuffer.depth, 1, truth->depth);
    if (!reference || !block->error)
        return true;
    return load_channel(reference, "AO", block, &truth->ao, error) &&
           load_channel(reference, "SE", block, &truth->se, error) &&
           (!definition || load_channel(definition, "AO", block, &truth->definition, error));
}

static void free_truth(struct truth *truth)
{
    free(truth->depth);
    free(truth->ao);
    free(truth->se);
    free(truth->definition);
}

static void map_definition(const struct block *block, const struct aob_frame *frame, const json_t *c,
                           struct truth *truth)
{
    const struct aob_technique *technique = frame->graph.technique;
    unsigned char values[4 * AOB_MAX_PARAM];
    if (!truth->definition || !technique->definition.map ||
        !aob_worker_params(technique, json_object_get(c, "params"), values, NULL))
        return;
    for (size_t i = 0; i < (size_t)block->width * (size_t)block->height; i++)
        truth->definition[i] = technique->definition.map(values, truth->definition[i]);
}

static json_t *score_to_json(const struct aob_score *s, double definition_rmse)
{
    return json_pack("{s:s, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:o, s:I, s:I}", "reference",
                     "ray-traced", "rmse", aob_json_number(s->rmse), "band_rmse",
                     aob_json_number(s->band_rmse), "border_rmse", aob_json_number(s->border_rmse), "mae",
                     aob_json_number(s->mae), "bias", aob_json_number(s->bias), "p95",
                     aob_json_number(s->p95), "max", aob_json_number(s->max), "reference_se",
                     aob_json_number(s->reference_se), "definition_rmse", aob_json_number(definition_rmse),
                     "pixels", (json_int_t)s->pixels, "band_pixels", (json_int_t)s->band_pixels);
}

static bool score_case(const struct block *block, const json_t *c, const float *ao, const struct truth *truth,
                       json_t *answer, struct aob_error *error)
{
    struct aob_score score;
    const struct aob_projection *view = &block->gbuffer.projection;
    struct aob_score_desc desc = {.width = block->width,
                                  .height = block->height,
                                  .image = ao,
                                  .truth = truth->ao ? truth->ao : ao,
                                  .truth_se = truth->se,
                                  .depth = truth->depth,
                                  .sky_depth = 0.5f * AOB_GBUFFER_SKY,
                                  .radius = aob_json_to_number(json_object_get(c, "radius")),
                                  .pixel_scale = view->sy,
                                  .perspective = view->perspective};
    if (!aob_score(&desc, &score, error))
        return false;
    double definition = truth->definition ? aob_score_rmse(&desc, truth->definition, truth->ao) : NAN;
    if (truth->ao)
        json_object_set_new(answer, "error", score_to_json(&score, definition));
    return true;
}

static void add_plane(struct aob_image *image, const char *name, const float *pixels)
{
    if (pixels)
        memcpy(aob_image_add(image, name), pixels,
               (size_t)image->width * (size_t)image->height * sizeof(float));
}

static void add_camera(struct aob_image *image, const struct aob_camera *camera)
{
    aob_image_set_number(image, "aobudget.fov_deg", camera->fov_deg);
    aob_image_set_number(image, "aobudget.ortho_height", camera->ortho_height);
    aob_image_set_vec3(image, "aobudget.eye", (double[3]){camera->eye.x, camera->eye.y, camera->eye.z});
    aob_image_set_vec3(image, "aobudget.target",
                       (double[3]){camera->target.x, camera->target.y, camera->target.z});
}

static void add_error(struct aob_image *image, const float *ao, const struct truth *truth)
{
    float *error = truth->ao ? aob_image_add(image, "error.AO") : NULL;
    for (size_t i = 0; error && i < (size_t)image->width * (size_t)image->height; i++)
        error[i] = truth->depth[i] < 0.5f * AOB_GBUFFER_SKY ? ao[i] - truth->ao[i] : 0;
}

static bool write_image(const struct block *block, const json_t *c, const char *path, const float *ao,
                        const struct truth *truth, struct aob_error *error)
{
    static const char *const normals[3] = {"N.X", "N.Y", "N.Z"};
    struct aob_image image = {.width = block->width, .height = block->height};
    float *z = aob_image_add(&image, "Z");
    for (size_t i = 0; i < (size_t)block->width * (size_t)block->height; i++)
        z[i] = truth->depth[i] < 0.5f * AOB_GBUFFER_SKY ? truth->depth[i] : INFINITY;
    for (int n = 0; n < 3; n++)
        crop(block, block->gbuffer.normal + n, 4, aob_image_add(&image, normals[n]));
    add_plane(&image, "technique.AO", ao);
    add_plane(&image, "reference.AO", truth->ao);
    add_plane(&image, "reference.SE", truth->se);
    add_plane(&image, "definition.AO", truth->definition);
    add_error(&image, ao, truth);
    add_camera(&image, &block->camera);
    aob_image_set_text(&image, "aobudget.technique", json_string_value(json_object_get(c, "technique")));
    bool ok = aob_image_write(&image, path, error);
    aob_image_finish(&image);
    return ok;
}

static bool finish_case(struct block *block, size_t f, json_t *answer, struct aob_error *error)
{
    const json_t *c = json_array_get(block->cases, block->case_of_frame[f]);
    const char *path = json_string_value(json_object_get(c, "image"));
    struct truth truth = {0};
    float *ao = AOB_NEW_ARRAY(float, (size_t)block->width *(size_t)block->height);
    int64_t start = aob_clock_wall_ns();
    bool ok = aob_frame_run(&block->frames[f], NULL, error) &&
              aob_frame_read(&block->frames[f], AOB_OUT_VISIBILITY, ao, error) &&
              load_truth(block, c, &truth, error);
    if (ok) {
        map_definition(block, &block->frames[f], c, &truth);
        ok = score_case(block, c, ao, &truth, answer, error) ||
             (json_object_set_new(answer, "status", json_string("invalid")), false);
    }
    if (path && truth.depth && (ok || *error->text))
        ok = write_image(block, c, path, ao, &truth, ok ? error : NULL) && ok;
    block->images_s += seconds_since(start);
    free_truth(&truth);
    free(ao);
    return ok;
}

static void reply_case(struct aob_worker *worker, struct block *block, size_t f)
{
    struct aob_error error = {{0}};
    json_t *answer = json_pack("{s:i, s:s, s:I, s:o}", "index", (int)block->case_of_frame[f], "status",
                               "failed", "memory_bytes", (json_int_t)block->frames[f].memory_bytes,
                               "fingerprint", fingerprint(block));
    if (finish_case(block, f, answer, &error)) {
        json_object_set_new(answer, "status", json_string("ok"));
        if (block->time)
            json_object_set_new(answer, "time", time_to_json(block, f));
    } else
        json_object_set_new(answer, "reason", json_string(error.text));
    aob_worker_reply(worker, answer);
}

static void reply_shares(struct aob_worker *worker, const struct block *block)
{
    double measured = block->timing.fixed_s;
    for (size_t f = 0; f < block->frame_count; f++)
        measured += block->timing.cases[f].measured_s;
    aob_worker_reply(worker, json_pack("{s:{s:f, s:f, s:f}}", "shares", "measured_s", measured, "warmup_s",
                                       block->timing.warmup_s + block->setup_s, "images_s", block->images_s));
}

static bool open_device(struct block *block, struct aob_error *error)
{
    const char *backend = json_string_value(json_object_get(block->job, "backend"));
    bool validate = json_is_true(json_object_get(block->job, "validate"));
    block->gpu = aob_gpu_open(backend ? backend : "", &(struct aob_gpu_desc){.validate = validate}, error);
    return block->gpu && aob_screen_init(&block->screen, block->gpu, &block->gbuffer, error);
}

static bool run_cases(struct aob_worker *worker, struct block *block, struct aob_error *error)
{
    int64_t start = aob_clock_wall_ns();
    for (size_t i = 0; i < json_array_size(block->cases); i++)
        init_frame(worker, block, i);
    if (block->time && block->frame_count &&
        !aob_frame_init(&block->fixed, &block->screen, &aob_technique_fixed_pass, &(int32_t){0},
                        AOB_FETCH_SAMPLED, error))
        return false;
    block->setup_s = seconds_since(start);
    if (block->time && block->frame_count && !measure_time(block, error))
        return false;
    for (size_t f = 0; f < block->frame_count; f++)
        reply_case(worker, block, f);
    reply_shares(worker, block);
    return true;
}

bool aob_worker_block(struct aob_worker *worker, struct aob_error *error)
{
    struct block *block = AOB_NEW(struct block);
    bool ok = get_block(worker, block, error) && aob_worker_registry(worker, &block->registry, error);
    if (ok && !open_device(block, error))
        reply_all(worker, block, "unsupported", error->text);
    else if (ok)
        ok = run_cases(worker, block, error);
    for (size_t f = 0; f < block->frame_count; f++)
        aob_frame_finish(&block->frames[f]);
    aob_frame_finish(&block->fixed);
    aob_screen_finish(&block->screen);
    aob_gpu_close(block->gpu);
    aob_gbuffer_finish(&block->gbuffer);
    aob_registry_finish(&block->registry);
    free(block);
    return ok;
}
