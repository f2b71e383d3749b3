#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "command.h"
#include "gpu/gpu.h"
#include "profile/profile.h"
#include "scene/camera_json.h"
#include "scene/scene.h"
#include "scene/scene_folder.h"
#include "technique/option.h"
#include "technique/param.h"

static bool write_document(json_t *document, const char *json, struct aob_error *error)
{
    bool ok = aob_json_write(document, json, error);
    json_decref(document);
    return ok;
}

static json_t *params_to_json(const struct aob_param *params, size_t count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++)
        json_array_append_new(array, aob_param_to_json(&params[i]));
    return array;
}

static json_t *techniques_to_json(const struct aob_technique_list *list)
{
    json_t *array = json_array();
    for (size_t i = 0; i < list->count; i++)
        json_array_append_new(array, aob_technique_info_to_json(&list->items[i]));
    return json_pack("{s:o, s:o}", "techniques", array, "options",
                     params_to_json(aob_option_params, AOB_OPTION_COUNT));
}

static void print_params(const struct aob_param *params, size_t count, struct aob_text *out)
{
    for (size_t i = 0; i < count; i++) {
        struct aob_text text = {0};
        aob_param_print(&params[i], params[i].initial, &text);
        if (params[i].choices)
            for (int c = 0; params[i].choices[c]; c++)
                aob_text_add(&text, "%s%s", c ? "|" : "  of ", params[i].choices[c]);
        else
            aob_text_add(&text, "%s  in %g .. %g %s",
                         params[i].unit == AOB_UNIT_LENGTH && params[i].initial > 0 ? " m" : "",
                         params[i].min, params[i].max, aob_unit_name(params[i].unit));
        if (aob_param_rule(&params[i]))
            aob_text_add(&text, ", %s", aob_param_rule(&params[i]));
        aob_text_add_line(out, "    %-12s %s", params[i].name, text.data);
        aob_text_add_line(out, "                 %s", params[i].doc);
        aob_text_finish(&text);
    }
}

static void print_techniques(const struct aob_technique_list *list, struct aob_text *out)
{
    for (size_t i = 0; i < list->count; i++) {
        const struct aob_technique_info *t = &list->items[i];
        aob_text_add_line(out, "%s: %s (revision %u%s%s)", t->name, t->title, t->revision,
                          t->module ? ", " : "", t->module ? t->module : "");
        aob_text_add_line(out, "    %s", t->citation);
        if (t->summary)
            aob_text_add_line(out, "    %s", t->summary);
        if (t->notes)
            aob_text_add_line(out, "    Notes: %s", t->notes);
        print_params(t->params, t->param_count, out);
    }
    aob_text_add_line(out, "options of every run");
    print_params(aob_option_params, AOB_OPTION_COUNT, out);
}

static json_t *scene_to_json(const struct aob_scene_info *scene)
{
    json_t *views = json_array();
    for (size_t i = 0; i < scene->view_count; i++) {
        json_t *view = aob_camera_to_json(&scene->views[i].camera);
        json_object_set_new(view, "name", json_string(scene->views[i].name));
        json_array_append_new(views, view);
    }
    return json_pack("{s:s, s:s, s:f, s:f, s:s?, s:s?, s:s?, s:s?, s:b, s:o}", "name", scene->name,
                     "geometry", scene->title, "metres_per_unit", scene->metres_per_unit, "metre",
                     scene->metre, "file", scene->file, "package", scene->package, "licence", scene->licence,
                     "sha256", scene->sha256, "available", !scene->file || aob_file_exists(scene->file),
                     "views", views);
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
    aob_text_add_line(out, "    views:%s", views.data);
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

static bool list_scenes(struct aob_common *common, struct aob_error *error)
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

static json_t *backends_to_json(const struct aob_dispatch *dispatch)
{
    json_t *array = json_array();
    for (const struct aob_gpu_fns *const *b = aob_gpu_backends; *b; b++) {
        struct aob_error error = {{0}};
        json_t *devices = aob_dispatch_devices(dispatch, (*b)->name, &error);
        json_array_append_new(array,
                              json_pack("{s:s, s:s, s:o, s:s}", "name", (*b)->name, "title", (*b)->title,
                                        "devices", devices ? devices : json_array(), "reason", error.text));
    }
    return json_pack("{s:o}", "backends", array);
}

static const char *text_of(const json_t *object, const char *name)
{
    return json_string_value(json_object_get(object, name));
}

/* One a line; a star before the one that is used. */
static void print_devices(const json_t *devices, struct aob_text *out)
{
    for (size_t i = 0; i < json_array_size(devices); i++) {
        const json_t *d = json_array_get(devices, i);
        bool software = json_is_true(json_object_get(d, "software"));
        const char *lacks = text_of(d, "lacks");
        aob_text_add_line(out, "  %c %zu  %s: %s%s; %s; %s%s%s",
                          json_is_true(json_object_get(d, "chosen")) ? '*' : ' ', i, text_of(d, "name"),
                          text_of(d, "class"), software ? ", software" : "", text_of(d, "driver"),
                          json_is_true(json_object_get(d, "timer")) ? "timer" : "no timer",
                          *lacks ? "; it lacks " : "", lacks);
    }
}

static void print_backends(const json_t *document, struct aob_text *out)
{
    const json_t *array = json_object_get(document, "backends");
    for (size_t i = 0; i < json_array_size(array); i++) {
        const json_t *backend = json_array_get(array, i);
        aob_text_add_line(out, "%-12s %s", text_of(backend, "name"), text_of(backend, "title"));
        print_devices(json_object_get(backend, "devices"), out);
        if (*text_of(backend, "reason"))
            aob_text_add_line(out, "    %s", text_of(backend, "reason"));
    }
}

static bool list_techniques(struct aob_common *common, struct aob_error *error)
{
    struct aob_technique_list list;
    bool ok = aob_dispatch_describe(&common->dispatch, &common->dispatch.modules, &list, error);
    if (ok && common->json)
        ok = write_document(techniques_to_json(&list), common->json, error);
    else if (ok)
        print_techniques(&list, &common->out);
    aob_technique_list_finish(&list);
    return ok;
}

static bool list_backends(struct aob_common *common, struct aob_error *error)
{
    json_t *document = backends_to_json(&common->dispatch);
    if (common->json)
        return write_document(document, common->json, error);
    print_backends(document, &common->out);
    json_decref(document);
    return true;
}

static json_t *profile_to_json(const struct aob_profile *profile)
{
    json_t *facts = json_array();
    for (size_t i = 0; i < profile->fact_count; i++) {
        const struct aob_profile_fact *fact = &profile->facts[i];
        json_array_append_new(facts, json_pack("{s:s, s:s, s:s, s:b}", "key", fact->key, "value", fact->value,
                                               "source", fact->source, "confirmed", fact->confirmed));
    }
    return json_pack("{s:s, s:s, s:s, s:o, s:s}", "name", profile->name, "title", profile->title, "file",
                     profile->path, "facts", facts, "reason", "");
}

static void print_profile(const struct aob_profile *profile, struct aob_text *out)
{
    aob_text_add_line(out, "%s: %s", profile->name, profile->title);
    for (size_t i = 0; i < profile->fact_count; i++) {
        const struct aob_profile_fact *fact = &profile->facts[i];
        aob_text_add_line(out, "    %-20s %-12s %-10s %s", fact->key, fact->value,
                          fact->confirmed ? "confirmed" : "unverified", fact->source);
    }
}

/* One that cannot be read says why in place of its numbers, as a backend without a device does. */
static void add_profile(const char *name, json_t *array, struct aob_text *out)
{
    struct aob_profile profile;
    struct aob_error error = {{0}};
    if (aob_profile_find(&profile, name, &error)) {
        json_array_append_new(array, profile_to_json(&profile));
        print_profile(&profile, out);
        aob_profile_finish(&profile);
        return;
    }
    json_array_append_new(array, json_pack("{s:s, s:n, s:n, s:[], s:s}", "name", name, "title", "file",
                                           "facts", "reason", error.text));
    aob_text_add_line(out, "%s: cannot be used", name);
    aob_text_add_line(out, "    %s", error.text);
}

static bool list_profiles(struct aob_common *common, struct aob_error *error)
{
    struct aob_profile_names names;
    struct aob_text out = {0};
    if (!aob_profile_names(&names, error))
        return false;
    json_t *array = json_array();
    for (size_t i = 0; i < names.count; i++)
        add_profile(names.items[i], array, common->json ? &out : &common->out);
    aob_profile_names_finish(&names);
    aob_text_finish(&out);
    json_t *document = json_pack("{s:o}", "profiles", array);
    if (common->json)
        return write_document(document, common->json, error);
    json_decref(document);
    return true;
}

static enum aob_exit list(void *options, struct aob_error *error)
{
    struct aob_common *common = options;
    const char *what = common->words.items[0];
    bool ok = false;
    if (strcmp(what, "techniques") == 0)
        ok = list_techniques(common, error);
    else if (strcmp(what, "scenes") == 0)
        ok = list_scenes(common, error);
    else if (strcmp(what, "backends") == 0)
        ok = list_backends(common, error);
    else if (strcmp(what, "profiles") == 0)
        ok = list_profiles(common, error);
    else
        aob_fail(error, "list: '%s' is not one of techniques, scenes, backends, profiles", what);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}

const struct aob_command aob_command_list = {
    .name = "list",
    .help = "what there is: techniques, scenes, backends, profiles",
    .usage = "techniques|scenes|backends|profiles [--device NAME|N] [--json FILE]",
    .summary = "What there is, with parameters, units, bounds and geometry.",
    .modules = true,
    .devices = true,
    .least = 1,
    .most = 1,
    .size = sizeof(struct aob_common),
    .run = list,
};
