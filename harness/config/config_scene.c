#include "config_scene.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "config_capture.h"
#include "motion_choice.h"
#include "pose.h"

struct scene_reader {
    struct aob_config *config;
    struct aob_scene_choice choice; /* what all views of the entry share; owns its texts */
    char **views;
    size_t view_count, view_capacity;
    bool eye, target, lens, convention; /* lens: whatever needs eye and target */
};

static bool add_view(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    struct scene_reader *reader = user;
    const char *text;
    if (!aob_yaml_text(yaml, node, &text))
        return false;
    *AOB_PUSH(reader->views, reader->view_count, reader->view_capacity) = aob_strdup(text);
    return true;
}

static bool read_scene_entry(struct aob_yaml *yaml, const char *key, yaml_node_t *node, void *user)
{
    struct scene_reader *reader = user;
    struct aob_scene_choice *choice = &reader->choice;
    enum aob_convention_key convention;
    const char *text;
    if (strcmp(key, "name") == 0 || strcmp(key, "file") == 0 || strcmp(key, "capture") == 0) {
        if (!aob_yaml_text(yaml, node, &text))
            return false;
        *(key[0] == 'n'   ? &choice->name
          : key[0] == 'f' ? &choice->file
                          : &choice->capture) = aob_strdup(text);
        return true;
    }
    if (strcmp(key, "light") == 0) {
        if (!aob_yaml_text(yaml, node, &text))
            return false;
        aob_config_take_light(choice, text);
        return true;
    }
    if (aob_config_is_convention(key, &convention))
        return (reader->convention = true) &&
               aob_config_read_convention(yaml, node, convention, &choice->convention);
    if (strcmp(key, "view") == 0 || strcmp(key, "views") == 0)
        return aob_yaml_sequence(yaml, node, add_view, reader);
    if (strcmp(key, "eye") == 0)
        return (reader->eye = true) && aob_yaml_vec3(yaml, node, choice->eye);
    if (strcmp(key, "target") == 0)
        return (reader->target = true) && aob_yaml_vec3(yaml, node, choice->target);
    if (strcmp(key, "fov_deg") == 0)
        return (reader->lens = true) && aob_yaml_number(yaml, node, 1, 170, &choice->fov_deg);
    if (strcmp(key, "shift") == 0)
        return (reader->lens = true) && aob_yaml_vec2(yaml, node, choice->shift);
    if (strcmp(key, "metres_per_unit") == 0)
        return aob_yaml_number(yaml, node, AOB_CONFIG_MIN_UNIT, AOB_CONFIG_MAX_UNIT,
                               &choice->metres_per_unit);
    if (strcmp(key, "motion") == 0)
        return aob_motion_choice_read(yaml, node, &choice->motion);
    if (strcmp(key, "previous") == 0)
        return (reader->lens = choice->moves = true) && aob_pose_read(yaml, node, &choice->previous);
    choice->ortho = reader->lens = true;
    return aob_yaml_number(yaml, node, 1e-9, 1e12, &choice->ortho_height);
}

static void push_scene(struct scene_reader *reader, const char *view)
{
    struct aob_scene_choice *copy =
        AOB_PUSH(reader->config->scenes, reader->config->scene_count, reader->config->scene_capacity);
    *copy = reader->choice;
    copy->name = aob_strdup(reader->choice.name);
    copy->file = aob_strdup(reader->choice.file);
    copy->capture = aob_strdup(reader->choice.capture);
    copy->given = aob_strdup(reader->choice.given);
    copy->light = aob_strdup(reader->choice.light);
    copy->view = aob_strdup(view);
}

static bool judge_scene(struct aob_yaml *yaml, const yaml_node_t *node, struct scene_reader *reader)
{
    aob_config_take_capture(&reader->choice);
    const struct aob_scene_choice *choice = &reader->choice;
    if (!choice->name + !choice->file + !choice->capture != 2)
        return aob_yaml_fail(yaml, node,
                             "a scene needs one of name: SCENE, file: MESH and capture: FILE.exr");
    if (reader->eye != reader->target)
        return aob_yaml_fail(yaml, node, "a camera needs both eye and target");
    if (choice->capture && reader->view_count)
        return aob_yaml_fail(yaml, node, "a capture has no named views");
    reader->choice.has_camera = reader->eye;
    if (!aob_motion_choice_judge(yaml, node, choice))
        return false;
    if (choice->capture)
        return aob_config_judge_capture(yaml, node, choice);
    if (reader->convention)
        return aob_yaml_fail(yaml, node, "depth, normals and what goes with them are keys of a capture");
    if (!reader->eye && reader->lens)
        return aob_yaml_fail(yaml, node, "fov_deg, ortho_height, shift and previous need eye and target");
    if (reader->choice.file && reader->view_count)
        return aob_yaml_fail(yaml, node, "a mesh file has no named views: give eye, target and fov_deg");
    if (reader->eye && reader->view_count)
        return aob_yaml_fail(yaml, node, "give a view or a camera, not both");
    return true;
}

/* Puts the path as the current folder sees it in place of the one that is written. */
static void resolve_path(const struct aob_config *config, struct aob_scene_choice *choice)
{
    char **path = choice->file ? &choice->file : &choice->capture;
    if (choice->is_probe) {
        char *probe = aob_path_beside(config->place, choice->light);
        free(choice->light);
        choice->light = probe;
    }
    if (!*path)
        return;
    choice->given = *path;
    *path = aob_path_beside(config->place, choice->given);
}

void aob_config_take_light(struct aob_scene_choice *choice, const char *text)
{
    free(choice->light);
    choice->light = aob_strdup(text);
    choice->is_probe = strpbrk(text, "/.");
}

static const char *const keys[] = {"name",
                                   "file",
                                   "capture",
                                   "view",
                                   "views",
                                   "eye",
                                   "target",
                                   "fov_deg",
                                   "ortho_height",
                                   "shift",
                                   "previous",
                                   "depth",
                                   "near",
                                   "far",
                                   "normals",
                                   "handed",
                                   "up",
                                   "depth_channel",
                                   "normal_channel",
                                   "light",
                                   "metres_per_unit",
                                   "motion",
                                   "materials",
                                   "albedo_channel",
                                   "roughness_channel",
                                   "metalness_channel",
                                   NULL};

bool aob_config_read_scene(struct aob_yaml *yaml, yaml_node_t *node, void *user)
{
    struct scene_reader reader = {.config = user};
    bool ok =
        aob_yaml_mapping(yaml, node, keys, read_scene_entry, &reader) && judge_scene(yaml, node, &reader);
    if (ok)
        resolve_path(reader.config, &reader.choice);
    if (!(reader.choice.fov_deg > 0) && !reader.choice.capture)
        reader.choice.fov_deg = 60;
    reader.choice.line = (int)node->start_mark.line + 1;
    reader.choice.column = (int)node->start_mark.column + 1;
    if (ok && reader.config->scene_count + reader.view_count > AOB_CONFIG_MAX_VIEWS)
        ok = aob_yaml_fail(yaml, node, "more than %d views of scenes", AOB_CONFIG_MAX_VIEWS);
    for (size_t i = 0; ok && i < reader.view_count; i++)
        push_scene(&reader, reader.views[i]);
    if (ok && !reader.view_count)
        push_scene(&reader, NULL);
    for (size_t i = 0; i < reader.view_count; i++)
        free(reader.views[i]);
    free(reader.views);
    free(reader.choice.name);
    free(reader.choice.file);
    free(reader.choice.capture);
    free(reader.choice.given);
    free(reader.choice.light);
    return ok;
}
