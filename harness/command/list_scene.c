#include "list_scene.h"
#include "base/file.h"
#include "base/json.h"
#include "scene/camera_json.h"
#include "scene/light_json.h"
#include "scene/scene.h"
#include "scene/scene_folder.h"

static bool write_document(json_t *document, const char *json, struct aob_error *error)
{
    bool ok = aob_json_write(document, json, error);
    json_decref(document);
    return ok;
}

static const char *light_of(const struct aob_scene_info *scene)
{
    return scene->light ? scene->light : aob_lights[0].name;
}

static json_t *scene_to_json(const struct aob_scene_info *scene)
{
    json_t *views = json_array();
    for (size_t i = 0; i < scene->view_count; i++) {
        json_t *view = aob_camera_to_json(&scene->views[i].camera);
        json_object_set_new(view, "name", json_string(scene->views[i].name));
        json_array_append_new(views, view);
    }
    return json_pack("{s:s, s:s, s:s, s:f, s:f, s:s?, s:s?, s:s?, s:s?, s:b, s:b, s:o}", "name", scene->name,
                     "geometry", scene->title, "light", light_of(scene), "metres_per_unit",
                     scene->metres_per_unit, "metre", scene->metre, "file", scene->file, "package",
                     scene->package, "licence", scene->licence, "sha256", scene->sha256, "available",
                     !scene->file || aob_file_exists(scene->file), "moves", scene->moves, "views", views);
}

/* A file name that is not UTF-8 cannot be in JSON, nor in a plan: jansson packs no object then. */
static json_t *scenes_to_json(const struct aob_scene_folder *folder)
{
    json_t *array = json_array(), *own = json_array(), *known = json_array();
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++)
        json_array_append_new(array, scene_to_json(*s));
    for (size_t i = 0; i < folder->count; i++)
        json_array_append_new(
            own, json_pack("{s:s, s:s}", "name", folder->files[i].name, "file", folder->files[i].path));
    for (const struct aob_known_scene *k = aob_known_scenes; k->name; k++)
        json_array_append_new(known, json_pack("{s:s, s:s, s:s, s:s}", "name", k->name, "geometry", k->title,
                                               "source", k->source, "licence", k->licence));
    return json_pack("{s:o, s:o, s:o}", "scenes", array, "own", own, "known_elsewhere", known);
}

static void print_scene(const struct aob_scene_info *scene, struct aob_text *out)
{
    struct aob_text views = {0};
    for (size_t i = 0; i < scene->view_count; i++)
        aob_text_add(&views, " %s", scene->views[i].name);
    aob_text_add_line(out, "%s: %s", scene->name, scene->title);
    aob_text_add_line(out, "    views:%s; light: %s%s", views.data, light_of(scene),
                      scene->moves ? "; it moves from frame to frame" : "");
    aob_text_finish(&views);
    if (!scene->file)
        return;
    aob_text_add_line(out, "    %s (package %s)%s", scene->file, scene->package,
                      aob_file_exists(scene->file) ? "" : ": not installed");
    aob_text_add_line(out, "    licence %s; sha256 %s", scene->licence, scene->sha256);
}

static void print_scenes(const struct aob_scene_folder *folder, struct aob_text *out)
{
    for (const struct aob_scene_info *const *s = aob_scenes; *s; s++)
        print_scene(*s, out);
    if (folder->count)
        aob_text_add_line(out, "your own, in AOBUDGET_SCENES");
    for (size_t i = 0; i < folder->count; i++)
        aob_text_add_line(out, "    %s: %s", folder->files[i].name, folder->files[i].path);
    aob_text_add_line(out,
                      "known elsewhere: put a mesh into the folder AOBUDGET_SCENES to use it by its name");
    for (const struct aob_known_scene *k = aob_known_scenes; k->name; k++) {
        aob_text_add_line(out, "    %s: %s", k->name, k->title);
        aob_text_add_line(out, "        %s; %s", k->source, k->licence);
    }
}

bool aob_list_scenes(struct aob_common *common, struct aob_error *error)
{
    struct aob_scene_folder folder;
    bool ok = aob_scene_folder_read(&folder, error);
    if (ok && common->json)
        ok = write_document(scenes_to_json(&folder), common->json, error);
    else if (ok)
        print_scenes(&folder, &common->out);
    aob_scene_folder_finish(&folder);
    return ok;
}

bool aob_list_lights(struct aob_common *common, struct aob_error *error)
{
    json_t *array = json_array();
    for (const struct aob_light_info *info = aob_lights; info->name; info++) {
        struct aob_light_projection made;
        aob_light_make(info, &made);
        json_array_append_new(array,
                              json_pack("{s:s, s:s, s:f, s:[f, f], s:o}", "name", info->name, "radiance",
                                        info->title, "held", made.held, "factors", made.factors[0],
                                        made.factors[1], "coefficients", aob_light_to_json(&made.light)));
        if (common->json)
            continue;
        aob_text_add_line(&common->out, "%s: %s", info->name, info->title);
        aob_text_add_line(
            &common->out,
            "    nine coefficients hold %.1f %% of its energy; bands 1 and 2 count %.3f and %.3f",
            100 * made.held, made.factors[0], made.factors[1]);
    }
    json_t *document = json_pack("{s:o}", "lights", array);
    if (common->json)
        return write_document(document, common->json, error);
    json_decref(document);
    return true;
}
