#include "plan_scene.h"
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "base/table.h"
#include "scene/light.h"
#include "scene/scene_folder.h"
#include "scene/source.h"

struct chooser {
    struct aob_plan *plan;
    struct aob_table seen;          /* sources of geometry: the first scene that has each */
    struct aob_scene_folder folder; /* of the user, read for the first name that is not listed */
    bool folder_read;
};

static bool choose_view(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                        struct aob_error *error)
{
    const struct aob_view *view = aob_scene_view(scene->info, choice->view);
    if (view) {
        scene->camera = view->camera;
        scene->view = aob_strdup(view->name);
        return true;
    }
    struct aob_text all = {0};
    for (size_t i = 0; i < scene->info->view_count; i++)
        aob_text_add(&all, "%s%s", i ? ", " : "", scene->info->views[i].name);
    aob_fail(error, "scene '%s' has no view '%s'; it has %s", scene->name, choice->view, all.data);
    aob_text_finish(&all);
    return false;
}

static struct aob_vec3 from_array(const double v[3])
{
    return aob_vec(v[0], v[1], v[2]);
}

static bool choose_camera(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                          struct aob_error *error)
{
    if (choice->has_camera) {
        scene->view = aob_strdup("camera");
        scene->camera = (struct aob_camera){.eye = from_array(choice->eye),
                                            .target = from_array(choice->target),
                                            .fov_deg = choice->fov_deg,
                                            .ortho_height = choice->ortho ? choice->ortho_height : 0,
                                            .shift = {choice->shift[0], choice->shift[1]},
                                            .moves = choice->moves,
                                            .previous_eye = from_array(choice->previous.eye),
                                            .previous_target = from_array(choice->previous.target)};
        return aob_camera_check(&scene->camera, error);
    }
    if (scene->info)
        return choose_view(scene, choice, error);
    if (choice->view)
        return aob_fail(error,
                        "scene '%s' is a mesh file and has no named views: give eye, target and fov_deg",
                        scene->name);
    scene->view = aob_strdup("framed");
    scene->framed = true;
    return true;
}

/* The camera that is chosen is that of frame 0; what is scored is the last one. */
static bool choose_motion(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                          struct aob_error *error)
{
    const struct aob_camera first = scene->camera;
    struct aob_motion *motion = &scene->motion;
    struct aob_text view = {0};
    if (!choice->motion.frames)
        return true;
    if (scene->framed)
        return aob_fail(error, "scene '%s' is a mesh, and its motion needs a camera: give eye and target",
                        scene->name);
    *motion = (struct aob_motion){choice->motion.frames, first.eye, first.target, first.eye, first.target};
    if (choice->motion.camera) {
        motion->last_eye = from_array(choice->motion.last.eye);
        motion->last_target = from_array(choice->motion.last.target);
    }
    for (int t = 0; t < motion->frames; t++) {
        scene->camera = aob_motion_camera(motion, &first, t);
        if (!aob_camera_check(&scene->camera, error))
            return aob_fail_in(error, "frame %d of the motion", t);
    }
    aob_text_add(&view, "%s-%d-frames", scene->view, motion->frames);
    free(scene->view);
    scene->view = view.data;
    return true;
}

int aob_plan_scene_frame(const struct aob_plan_scene *scene, int frame)
{
    return scene->info && scene->info->moves ? frame : 0;
}

static bool fail_unknown(const char *name, const struct aob_scene_folder *folder, struct aob_error *error)
{
    struct aob_text all = {0};
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++)
        aob_text_add(&all, "%s%s", s == aob_scenes ? "" : ", ", (*s)->name);
    for (size_t i = 0; i < folder->count; i++)
        aob_text_add(&all, ", %s", folder->files[i].name);
    aob_fail(error, "unknown scene '%s'; there are %s", name, all.data);
    aob_text_finish(&all);
    return false;
}

/* A unit of which nothing is known is taken as a metre; what is then odd is told once the mesh is loaded. */
static double metre_of(const struct aob_scene_choice *choice)
{
    return choice->metres_per_unit > 0 ? 1 / choice->metres_per_unit : 1;
}

/* A listed scene, one of the user's folder by its name, or a mesh file. */
static bool find_scene(struct chooser *chooser, struct aob_plan_scene *scene,
                       const struct aob_scene_choice *choice, struct aob_error *error)
{
    struct aob_scene_folder *folder = &chooser->folder;
    scene->info = choice->name ? aob_scene_find(choice->name) : NULL;
    scene->name = aob_strdup(choice->name ? choice->name : choice->given ? choice->given : choice->file);
    if (scene->info && choice->metres_per_unit > 0)
        return aob_fail(error, "scene '%s' is listed, so its unit is known: leave metres_per_unit out",
                        scene->info->name);
    scene->unit_stated = scene->info || choice->metres_per_unit > 0;
    scene->metre = scene->info ? scene->info->metre : metre_of(choice);
    scene->file = aob_strdup(scene->info ? scene->info->file : choice->file);
    if (scene->info || choice->file)
        return true;
    if (!chooser->folder_read && !aob_scene_folder_read(folder, error))
        return aob_fail_in(error, "unknown scene '%s'", scene->name);
    chooser->folder_read = true;
    scene->file = aob_strdup(aob_scene_folder_find(folder, scene->name));
    return scene->file || fail_unknown(scene->name, folder, error);
}

/* A frame of another renderer, of the size and seen by the camera that it was loaded with. */
static bool choose_capture(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                           struct aob_error *error)
{
    struct aob_text name = {0};
    aob_text_add(&name, "capture:%s", choice->given ? choice->given : choice->capture);
    scene->name = name.data;
    scene->gbuffer = choice->gbuffer;
    scene->materials = choice->materials;
    scene->width = choice->width;
    scene->height = choice->height;
    scene->metre = metre_of(choice);
    memcpy(scene->digest, choice->digest, sizeof scene->digest);
    memcpy(scene->geometry, choice->geometry, sizeof scene->geometry);
    bool ok = choose_camera(scene, choice, error);
    free(scene->view);
    scene->view = aob_strdup("capture");
    return ok;
}

/* The digest of a mesh takes a pass over its triangles or its file, so views of one scene share it. */
static bool find_digest(struct chooser *chooser, size_t index, struct aob_error *error)
{
    struct aob_plan_scene *scenes = chooser->plan->scenes, *scene = &scenes[index];
    struct aob_text source = {0};
    aob_text_add(&source, "%s %s", scene->file ? "file" : "scene", scene->file ? scene->file : scene->name);
    size_t first = aob_table_put(&chooser->seen, source.data, index);
    aob_text_finish(&source);
    if (first != index)
        memcpy(scene->geometry, scenes[first].geometry, sizeof scene->geometry);
    else if (!aob_source_digest(scene->info, scene->file, scene->geometry, error))
        return scene->info && scene->info->package && !aob_file_exists(scene->file)
                   ? aob_fail(error, "scene '%s' needs %s: apt-get install %s", scene->name, scene->file,
                              scene->info->package)
                   : false;
    aob_source_import_digest(scene->file, scene->geometry, scene->digest);
    return true;
}

static bool fail_unknown_light(const char *name, struct aob_error *error)
{
    struct aob_text all = {0};
    for (const struct aob_light_info *l = aob_lights; l->name; l++)
        aob_text_add(&all, "%s, ", l->name);
    aob_fail(error, "unknown light '%s'; there are %sand probes: FILE.exr", name, all.data);
    aob_text_finish(&all);
    return false;
}

/* A scene whose light nobody states is lit by its own, and a mesh or a capture uniformly. */
static bool find_light(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                       struct aob_error *error)
{
    struct aob_light_projection projection;
    const char *own = scene->info && scene->info->light ? scene->info->light : aob_lights[0].name;
    scene->light_stated = choice->light;
    scene->light_name = choice->light ? choice->light : own;
    if (choice->is_probe) {
        memcpy(scene->light.sh, choice->sh, sizeof scene->light.sh);
        return true;
    }
    const struct aob_light_info *info = aob_light_find(scene->light_name);
    if (!info)
        return fail_unknown_light(scene->light_name, error);
    aob_light_make(info, &projection);
    scene->light = projection.light;
    return true;
}

/* Nine digits: they are floats for the device. */
static bool choose_light(struct aob_plan_scene *scene, const struct aob_scene_choice *choice,
                         struct aob_error *error)
{
    struct aob_text text = {0};
    if (!find_light(scene, choice, error))
        return false;
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            aob_text_add(&text, " %.9g", scene->light.sh[i][c]);
    aob_hash_text(text.data, scene->light_digest);
    aob_text_finish(&text);
    return true;
}

static bool choose_scene(struct chooser *chooser, size_t index, struct aob_error *error)
{
    const struct aob_scene_choice *choice = &chooser->plan->config->scenes[index];
    struct aob_plan_scene *scene = &chooser->plan->scenes[index];
    if (choice->capture)
        return choose_capture(scene, choice, error) && choose_light(scene, choice, error);
    return find_scene(chooser, scene, choice, error) && choose_light(scene, choice, error) &&
           find_digest(chooser, index, error) && choose_camera(scene, choice, error) &&
           choose_motion(scene, choice, error);
}

/* Views that the config gives by numbers have no names of their own: the second camera on a scene is `camera-2`. So what
 * people, charts and filters call by a name is one view. */
static void name_views(struct aob_plan *plan)
{
    struct aob_table seen = {0};
    size_t *counts = AOB_NEW_ARRAY(size_t, plan->scene_count + 1);
    for (size_t i = 0; i < plan->scene_count; i++) {
        struct aob_plan_scene *scene = &plan->scenes[i];
        struct aob_text name = {0};
        aob_text_add(&name, "%s %s", scene->name, scene->view);
        size_t *count = &counts[aob_table_put(&seen, name.data, i)];
        aob_text_finish(&name);
        bool listed = scene->info && aob_scene_view(scene->info, scene->view);
        if (listed || ++*count == 1)
            continue;
        aob_text_add(&name, "%s-%zu", scene->view, *count);
        free(scene->view);
        scene->view = name.data;
    }
    free(counts);
    aob_table_finish(&seen);
}

bool aob_plan_choose_scenes(struct aob_plan *plan, struct aob_error *error)
{
    const struct aob_config *config = plan->config;
    struct chooser chooser = {.plan = plan};
    bool ok = true;
    plan->scene_count = config->scene_count;
    plan->scenes = AOB_NEW_ARRAY(struct aob_plan_scene, config->scene_count);
    for (size_t i = 0; ok && i < config->scene_count; i++)
        ok = choose_scene(&chooser, i, error) ||
             aob_config_fail_at(config, config->scenes[i].line, config->scenes[i].column, error);
    aob_table_finish(&chooser.seen);
    aob_scene_folder_finish(&chooser.folder);
    if (ok)
        name_views(plan);
    return ok;
}

void aob_plan_scene_finish(struct aob_plan_scene *scene)
{
    free(scene->name);
    free(scene->file);
    free(scene->view);
    free(scene->targets);
}
