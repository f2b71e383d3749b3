#include "held.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "scene/scene.h"

/* As a plan calls it. */
static const char *view_of(const struct aob_scene_choice *choice)
{
    const struct aob_scene_info *info = choice->name ? aob_scene_find(choice->name) : NULL;
    if (choice->capture || choice->has_camera)
        return choice->capture ? "capture" : "camera";
    return choice->view ? choice->view : info ? info->views[0].name : "framed";
}

static const char *scene_of(const struct aob_scene_choice *choice)
{
    return choice->name ? choice->name : choice->given;
}

/* The place of a view among those that the config gives by numbers, of one scene; from 1, and 1 of a listed view. */
static size_t number_of(const struct aob_config *config, size_t at)
{
    const struct aob_scene_choice *choice = &config->scenes[at];
    size_t number = 1;
    for (size_t i = 0; i < at && choice->has_camera; i++)
        number += config->scenes[i].has_camera && strcmp(scene_of(&config->scenes[i]), scene_of(choice)) == 0;
    return number;
}

static bool is_meant(const struct aob_config *config, size_t at, const char *name)
{
    const struct aob_scene_choice *choice = &config->scenes[at];
    const size_t number = number_of(config, at);
    struct aob_text text = {0};
    aob_text_add(&text, number > 1 ? "%s/%s-%zu" : "%s/%s", scene_of(choice), view_of(choice), number);
    bool meant = strcmp(name, text.data) == 0 || strcmp(name, scene_of(choice)) == 0;
    aob_text_finish(&text);
    return meant;
}

static size_t mark(const struct aob_config *config, size_t count, const char *name, bool *held)
{
    size_t found = 0;
    for (size_t i = 0; i < count; i++)
        if (is_meant(config, i, name)) {
            held[i] = true;
            found++;
        }
    return found;
}

static void add_scene(struct aob_config *config, const char *name)
{
    struct aob_scene_choice *choice = AOB_PUSH(config->scenes, config->scene_count, config->scene_capacity);
    const char *view = strchr(name, '/');
    choice->name = aob_strdup(name);
    if (!view)
        return;
    choice->name[view - name] = '\0';
    choice->view = aob_strdup(view + 1);
}

static bool mark_names(struct aob_config *config, const char *names, bool **held, struct aob_error *error)
{
    const size_t own = config->scene_count;
    char *copy = aob_strdup(names), *rest = copy;
    bool ok = true;
    for (char *name; ok && (name = strsep(&rest, ","));) {
        ok = *name || aob_fail(error, "--held-out: '%s' has an empty name", names);
        if (!ok || mark(config, own, name, *held))
            continue;
        add_scene(config, name);
        *held = aob_realloc(*held, config->scene_count, sizeof **held);
        (*held)[config->scene_count - 1] = true;
    }
    free(copy);
    return ok;
}

bool aob_tune_held_mark(struct aob_config *config, const char *names, bool **held, struct aob_error *error)
{
    *held = AOB_NEW_ARRAY(bool, config->scene_count + 1);
    if (names && !mark_names(config, names, held, error))
        return false;
    for (size_t i = 0; i < config->scene_count; i++)
        if (!(*held)[i])
            return true;
    return aob_fail(error, "--held-out: %s leaves no view of %s to fit: hold fewer out", names, config->path);
}
