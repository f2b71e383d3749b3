#include "captures.h"
#include <string.h>
#include "base/file.h"
#include "gbuffer/capture.h"
#include "job/capture_job.h"
#include "store/cache.h"

/* Everything that the G-buffer is made of. */
static bool make_digest(struct aob_scene_choice *choice, struct aob_error *error)
{
    struct aob_text text = {0};
    char bytes[AOB_KEY_SIZE];
    if (!aob_hash_file(choice->capture, bytes, error))
        return false;
    aob_text_add(&text, "%s ", bytes);
    aob_convention_print(&choice->convention, &text);
    aob_text_add(&text, " %d %.17g %.17g %.17g  %.17g %.17g %.17g  %.17g %.17g", choice->has_camera,
                 choice->eye[0], choice->eye[1], choice->eye[2], choice->target[0], choice->target[1],
                 choice->target[2], choice->fov_deg, choice->ortho_height);
    aob_hash_text(text.data, choice->geometry);
    aob_text_add(&text, " %s", aob_capture_version);
    aob_hash_text(text.data, choice->digest);
    aob_text_finish(&text);
    return true;
}

static void take_answer(void *user, const json_t *object)
{
    struct aob_scene_choice *choice = user;
    struct aob_capture_answer answer;
    json_t *warning;
    size_t at;
    if (!aob_capture_answer_from_json(object, &answer))
        return;
    json_array_foreach(answer.warnings, at, warning) if (!choice->told)
        aob_warn("%s", json_string_value(warning));
    choice->told = true;
    choice->width = answer.width;
    choice->height = answer.height;
    choice->fov_deg = answer.fov_deg;
    choice->ortho_height = answer.ortho_height;
    choice->ortho = answer.ortho_height > 0;
    choice->has_camera = true;
    choice->materials = answer.materials;
    memcpy(choice->eye, answer.eye, sizeof choice->eye);
    memcpy(choice->target, answer.target, sizeof choice->target);
}

static json_t *make_job(const struct aob_scene_choice *choice)
{
    struct aob_capture_job job = {.file = choice->capture,
                                  .out = choice->gbuffer,
                                  .convention = choice->convention,
                                  .fov_deg = choice->fov_deg,
                                  .ortho_height = choice->ortho_height,
                                  .has_camera = choice->has_camera};
    memcpy(job.eye, choice->eye, sizeof job.eye);
    memcpy(job.target, choice->target, sizeof job.target);
    return aob_capture_job_to_json(&job);
}

/* A frame of 40 million pixels takes about 2.5 GB, and with materials twice that; a damaged header may claim one. */
static bool load(struct aob_scene_choice *choice, const struct aob_cache *cache,
                 const struct aob_dispatch *dispatch, struct aob_error *error)
{
    if (!make_digest(choice, error))
        return false;
    choice->gbuffer = aob_cache_path(cache, "capture", choice->digest, ".exr");
    struct aob_job_desc desc = {.job = make_job(choice),
                                .timeout_s = 60 + 2e-6 * (double)aob_file_size(choice->capture),
                                .memory_limit = (size_t)8 << 30,
                                .on_answer = take_answer,
                                .user = choice,
                                .file = choice->capture};
    return aob_dispatch_job(dispatch, &desc, error) &&
           (choice->width > 0 || aob_fail(error, "%s: the worker gave no answer", choice->capture));
}

static bool load_in(struct aob_config *config, struct aob_scene_choice *choice,
                    const struct aob_dispatch *dispatch, struct aob_error *error)
{
    struct aob_cache cache = {0};
    if (!aob_cache_open(&cache, error))
        return false;
    bool ok = load(choice, &cache, dispatch, error);
    aob_cache_close(&cache);
    if (!ok && config->path)
        aob_fail_in(error, "%s:%d:%d", config->path, choice->line, choice->column);
    return ok;
}

bool aob_captures_load(struct aob_config *config, const struct aob_dispatch *dispatch,
                       struct aob_error *error)
{
    for (size_t i = 0; i < config->scene_count; i++)
        if (config->scenes[i].capture && !load_in(config, &config->scenes[i], dispatch, error))
            return false;
    return true;
}
