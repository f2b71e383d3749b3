#include "effects_scene.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "config/config.h"
#include "scene/scene.h"

/* A text in quotes, as JSON and YAML have it. */
static void add_quoted(const char *key, const char *value, struct aob_text *text)
{
    json_t *string = json_string(value);
    char *quoted = json_dumps(string, JSON_ENCODE_ANY);
    aob_text_add(text, "%s: %s", key, quoted);
    free(quoted);
    json_decref(string);
}

static void add_path(const char *key, const char *path, struct aob_text *text)
{
    char *whole = aob_path_absolute(path);
    add_quoted(key, whole, text);
    free(whole);
}

/* Which of the three it is aob_single_config has decided by the same rule. */
static void add_source(const char *scene, struct aob_text *text)
{
    const char *capture = aob_capture_file(scene);
    bool path = strchr(scene, '/') || aob_file_exists(scene);
    if (capture)
        add_path("capture", capture, text);
    else if (aob_scene_find(scene) || !path)
        add_quoted("name", scene, text);
    else
        add_path("file", scene, text);
}

static void add_list(const char *key, const char *numbers, struct aob_text *text)
{
    if (numbers)
        aob_text_add(text, ", %s: [%s]", key, numbers);
}

static void add_value(const char *key, const char *value, struct aob_text *text)
{
    if (value)
        aob_text_add(text, ", %s: %s", key, value);
}

static void add_light(const char *light, struct aob_text *text)
{
    if (!light)
        return;
    aob_text_add(text, ", ");
    if (aob_light_find(light))
        add_quoted("light", light, text);
    else
        add_path("light", light, text);
}

static void add_motion(const struct aob_single_flags *flags, int still_frames, struct aob_text *text)
{
    if (!flags->frames && !still_frames)
        return;
    if (flags->frames)
        aob_text_add(text, ", motion: {frames: %s", flags->frames);
    else
        aob_text_add(text, ", motion: {frames: %d", still_frames);
    add_list("eye", flags->last_eye, text);
    add_list("target", flags->last_target, text);
    aob_text_add(text, "}");
}

void aob_effects_scene_print(const struct aob_single_flags *flags, int still_frames, struct aob_text *text)
{
    aob_text_add(text, "{");
    add_source(flags->scene, text);
    if (flags->view) {
        aob_text_add(text, ", ");
        add_quoted("view", flags->view, text);
    }
    add_list("eye", flags->eye, text);
    add_list("target", flags->target, text);
    add_list("shift", flags->shift, text);
    add_value(flags->ortho ? "ortho_height" : "fov_deg", flags->ortho ? flags->ortho : flags->fov, text);
    add_value("metres_per_unit", flags->metres_per_unit, text);
    for (int key = 0; key < AOB_CONVENTION_COUNT; key++)
        if (key == AOB_CONVENTION_UP)
            add_list(aob_convention_keys[key], flags->convention[key], text);
        else
            add_value(aob_convention_keys[key], flags->convention[key], text);
    add_light(flags->light, text);
    add_motion(flags, still_frames, text);
    aob_text_add(text, "}");
}
