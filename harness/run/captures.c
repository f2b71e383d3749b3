#include "captures.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "gbuffer/capture.h"

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

static char *make_path(const struct aob_scene_choice *choice, struct aob_error *error)
{
    char name[AOB_KEY_SIZE + 16], *folder = aob_path_cache_folder(), *path = NULL;
    snprintf(name, sizeof name, "capture-%s.exr", choice->digest);
    if (aob_folder_create(folder, error))
        path = aob_path_join(folder, name);
    free(folder);
    return path;
}

static void take_answer(void *user, json_t *answer)
{
    struct aob_scene_choice *choice = user;
    json_t *warning;
    size_t at;
    json_array_foreach(json_object_get(answer, "warnings"), at, warning)
        aob_warn("%s", json_string_value(warning));
    choice->width = (int)json_integer_value(json_object_get(answer, "width"));
    choice->height = (int)json_integer_value(json_object_get(answer, "height"));
    choice->fov_deg = json_number_value(json_object_get(answer, "fov_deg"));
    choice->ortho_height = json_number_value(json_object_get(answer, "ortho_height"));
    choice->ortho = choice->ortho_height > 0;
    choice->has_camera = aob_json_to_vector(json_object_get(answer, "eye"), choice->eye, 3) &&
                         aob_json_to_vector(json_object_get(answer, "target"), choice->target, 3);
}

static json_t *make_job(const struct aob_scene_choice *choice)
{
    const struct aob_convention *c = &choice->convention;
    return json_pack("{s:s, s:s, s:s, s:i, s:i, s:b, s:o, s:o, s:o, s:s, s:s, s:f, s:f, s:o, s:o}", "job",
                     "capture", "file", choice->capture, "out", choice->gbuffer, "depth", (int)c->depth,
                     "normals", (int)c->normals, "left_handed", c->left_handed, "near",
                     aob_json_number(c->near), "far", aob_json_number(c->far), "up",
                     aob_json_vector(c->up, 3), "depth_channel", c->depth_channel, "normal_channel",
                     c->normal_channel, "fov_deg", choice->fov_deg, "ortho_height", choice->ortho_height,
                     "eye", choice->has_camera ? aob_json_vector(choice->eye, 3) : json_null(), "target",
                     choice->has_camera ? aob_json_vector(choice->target, 3) : json_null());
}

/* A frame of 40 million pixels takes about 2.5 GB, and a damaged header may claim one. */
static bool load(struct aob_scene_choice *choice, const struct aob_dispatch *dispatch,
                 struct aob_error *error)
{
    if (!make_digest(choice, error))
        return false;
    choice->gbuffer = make_path(choice, error);
    if (!choice->gbuffer)
        return false;
    struct aob_job_desc desc = {.job = make_job(choice),
                                .timeout_s = 60 + 2e-6 * (double)aob_file_size(choice->capture),
                                .memory_limit = (size_t)4 << 30,
                                .on_answer = take_answer,
                                .user = choice};
    bool ok = aob_dispatch_job(dispatch, &desc, error) &&
              (choice->width > 0 || aob_fail(error, "the worker gave no answer"));
    return ok || (strstr(error->text, choice->capture)
                      ? false
                      : aob_fail_in(error, "%s: the reader of captures", choice->capture));
}

bool aob_captures_load(struct aob_config *config, const struct aob_dispatch *dispatch,
                       struct aob_error *error)
{
    for (size_t i = 0; i < config->scene_count; i++) {
        struct aob_scene_choice *choice = &config->scenes[i];
        if (!choice->capture || load(choice, dispatch, error))
            continue;
        return config->path ? aob_fail_in(error, "%s:%d:%d", config->path, choice->line, choice->column)
                            : false;
    }
    return true;
}
