/* gpu-check-data FOLDER TIMES IMAGES...: makes what gpu-check is packed with (check_data.h) from the folders of runs: each
 * view of TIMES becomes one that techniques are timed on, each case of IMAGES an image. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/json.h"
#include "base/member.h"
#include "base/memory.h"
#include "check_data.h"
#include "scene/camera_json.h"
#include "scene/light_json.h"
#include "scene/scene.h"
#include "store/image.h"
#include "store/journal.h"
#include "technique/graph.h"
#include "technique/option.h"
#include "technique/param.h"
#include "technique/registry.h"

struct maker {
    const char *folder;
    struct aob_registry registry;
    json_t *document, *views, *images;
};

static bool is_kept(const char *name)
{
    static const char *const names[] = {"N.X",      "N.Y",       "N.Z",       "albedo.R",     "albedo.G",
                                        "albedo.B", "roughness", "metalness", "reference.AO", NULL};
    for (const char *const *n = names; *n; n++)
        if (strcmp(*n, name) == 0)
            return true;
    return false;
}

/* The form of gbuffer/gbuffer.h: no depth where sky, and shading normals, which are the geometric ones here. */
static bool write_view(const struct aob_image *from, const char *path, struct aob_error *error)
{
    struct aob_image view = {.width = from->width, .height = from->height};
    size_t count = (size_t)from->width * (size_t)from->height;
    const float *z = aob_image_channel(from, "Z");
    float *depth = aob_image_add(&view, "Z");
    for (size_t i = 0; i < count; i++)
        depth[i] = isfinite(z[i]) ? z[i] : 0;
    for (size_t c = 0; c < from->channel_count; c++)
        if (is_kept(from->channels[c].name))
            memcpy(aob_image_add(&view, from->channels[c].name), from->channels[c].pixels,
                   count * sizeof(float));
    for (int c = 0; c < 3; c++) {
        char normal[] = "N.X", shading[] = "S.X";
        normal[2] = shading[2] = (char)('X' + c);
        memcpy(aob_image_add(&view, shading), aob_image_channel(from, normal), count * sizeof(float));
    }
    bool ok = aob_image_write(&view, path, error);
    aob_image_finish(&view);
    return ok;
}

/* The channels of an output under other names; false if there are none. */
static bool copy_output(const struct aob_image *from, const char *whose, enum aob_output output,
                        struct aob_image *into, const char *as)
{
    float *pixels = aob_check_output(from, whose, output);
    int components = aob_output_components(output);
    for (int c = 0; c < components && pixels; c++) {
        char stem[AOB_CHECK_CHANNEL_SIZE], name[2 * AOB_CHECK_CHANNEL_SIZE];
        aob_check_channel_name(output, c, stem);
        snprintf(name, sizeof name, "%s%s", as, stem);
        aob_image_add_part(into, name, pixels + c, (size_t)components);
    }
    free(pixels);
    return pixels;
}

static bool gives(const json_t *record, enum aob_output output)
{
    const json_t *outputs = json_object_get(record, "outputs");
    for (size_t i = 0; i < json_array_size(outputs); i++)
        if (strcmp(json_string_value(json_array_get(outputs, i)), aob_output_name(output)) == 0)
            return true;
    return false;
}

/* What the technique wrote, and the truth of that where the view has none of it. */
static bool write_outputs(const json_t *record, const struct aob_image *from, const char *path,
                          struct aob_error *error)
{
    struct aob_image file = {.width = from->width, .height = from->height};
    bool ok = true;
    for (int which = 0; ok && which < AOB_OUTPUT_COUNT; which++) {
        enum aob_output output = (enum aob_output)which;
        if (!gives(record, output))
            continue;
        ok = copy_output(from, "technique.", output, &file, "") ||
             aob_fail(error, "the image has nothing of the output %s", aob_output_name(output));
        if (output != AOB_OUT_VISIBILITY)
            copy_output(from, "reference.", output, &file, "reference.");
    }
    ok = ok && aob_image_write(&file, path, error);
    aob_image_finish(&file);
    return ok;
}

/* The light of the view in its own space, as floats, which is what shaders are given. Packed texts hold those to the bit. NULL
 * after a line. */
static json_t *make_light(const json_t *record, struct aob_error *error)
{
    const char *name = aob_member_text(json_object_get(record, "light"), "name");
    const struct aob_light_info *info = aob_light_find(name);
    struct aob_light_projection projection;
    struct aob_camera camera;
    if (!info) {
        aob_fail(error, "%s is lit by '%s', which is no listed light", aob_member_text(record, "scene"),
                 name);
        return NULL;
    }
    if (!aob_camera_from_json(json_object_get(record, "camera"), &camera, error))
        return NULL;
    const struct aob_frame_axes axes = aob_camera_axes(&camera);
    aob_light_make(info, &projection);
    aob_light_turn(&projection.light, &axes, &projection.light);
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            projection.light.sh[i][c] = (double)(float)projection.light.sh[i][c];
    return aob_light_to_json(&projection.light);
}

/* Frames of a sequence; 1 of a picture. */
static int frames_of(const json_t *record)
{
    const json_t *motion = json_object_get(record, "motion");
    return motion ? (int)json_integer_value(json_object_get(motion, "frames")) : 1;
}

/* A sequence of a still view shows what the view does, whose name it has with its frames behind it. */
static void name_view(const json_t *record, char *name, size_t size)
{
    char frames[32];
    snprintf(name, size, "%s", aob_member_text(record, "view"));
    snprintf(frames, sizeof frames, "-%d-frames", frames_of(record));
    size_t length = strlen(name), more = strlen(frames);
    if (length > more && strcmp(name + length - more, frames) == 0)
        name[length - more] = 0;
}

/* The frames before the last have no G-buffers of their own here. */
static bool stands_still(const json_t *record, struct aob_error *error)
{
    const struct aob_scene_info *scene = aob_scene_find(aob_member_text(record, "scene"));
    const json_t *previous = json_object_get(json_object_get(record, "camera"), "previous");
    return frames_of(record) == 1 || (!json_is_object(previous) && scene && !scene->moves) ||
           aob_fail(error, "%s %s moves: a sequence must be of a still view",
                    aob_member_text(record, "scene"), aob_member_text(record, "view"));
}

/* The view's place, made if it is new. -1 after a line. */
static int place_view(struct maker *maker, const json_t *record, const struct aob_image *image, bool timed,
                      struct aob_error *error)
{
    size_t count = json_array_size(maker->views);
    char shown[256];
    name_view(record, shown, sizeof shown);
    for (size_t i = 0; i < count; i++) {
        const json_t *view = json_array_get(maker->views, i);
        if (strcmp(aob_member_text(view, "scene"), aob_member_text(record, "scene")) == 0 &&
            strcmp(aob_member_text(view, "view"), shown) == 0 &&
            json_integer_value(json_object_get(view, "width")) == image->width)
            return (int)i;
    }
    char name[32];
    snprintf(name, sizeof name, "view-%zu.exr", count);
    char *path = aob_path_join(maker->folder, name);
    bool ok = write_view(image, path, error);
    free(path);
    json_array_append_new(
        maker->views,
        json_pack("{s:s, s:s, s:O, s:i, s:i, s:O, s:s, s:b}", "scene", aob_member_text(record, "scene"),
                  "view", shown, "camera", json_object_get(record, "camera"), "width", image->width, "height",
                  image->height, "metre", json_object_get(record, "metre"), "file", name, "timed", timed));
    return ok ? (int)count : -1;
}

static bool is_default(const struct aob_param *param, double metre, const json_t *value)
{
    double initial;
    aob_param_defaults(param, 1, metre, &initial);
    if (param->choices)
        return strcmp(param->choices[(int)initial], json_string_value(value)) == 0;
    return (float)json_number_value(value) == (float)initial;
}

static void add_values(struct aob_text *name, const struct aob_param *params, size_t count, double metre,
                       const json_t *values)
{
    for (size_t i = 0; i < count; i++) {
        const json_t *value = json_object_get(values, params[i].name);
        if (!value || is_default(&params[i], metre, value))
            continue;
        if (json_is_string(value))
            aob_text_add(name, " %s=%s", params[i].name, json_string_value(value));
        else
            aob_text_add(name, " %s=%.6g", params[i].name, json_number_value(value));
    }
}

/* "gtao fetch=storage on cornell blocks 320x180". free() it. */
static char *name_image(const struct maker *maker, const json_t *record, const struct aob_image *image)
{
    const struct aob_registry_entry *entry =
        aob_registry_find(&maker->registry, NULL, aob_member_text(record, "technique"));
    double metre = json_number_value(json_object_get(record, "metre"));
    struct aob_text name = {0};
    aob_text_add(&name, "%s", aob_member_text(record, "technique"));
    if (entry)
        add_values(&name, entry->technique->params, entry->technique->param_count, metre,
                   json_object_get(record, "params"));
    add_values(&name, aob_option_params, AOB_OPTION_COUNT, metre, json_object_get(record, "options"));
    aob_text_add(&name, " on %s %s %dx%d", aob_member_text(record, "scene"), aob_member_text(record, "view"),
                 image->width, image->height);
    return name.data;
}

static bool add_image(struct maker *maker, const json_t *record, const struct aob_image *image,
                      struct aob_error *error)
{
    char file[32], *name = name_image(maker, record, image);
    int view = place_view(maker, record, image, false, error);
    snprintf(file, sizeof file, "image-%zu.exr", json_array_size(maker->images));
    char *path = aob_path_join(maker->folder, file);
    bool lit = json_object_get(record, "light");
    json_t *light = lit ? make_light(record, error) : NULL;
    bool ok = view >= 0 && stands_still(record, error) && (light || !lit) &&
              write_outputs(record, image, path, error);
    json_array_append_new(maker->images,
                          json_pack("{s:s, s:i, s:i, s:s, s:O, s:O, s:s, s:o*}", "name", name, "view", view,
                                    "frames", frames_of(record), "technique",
                                    aob_member_text(record, "technique"), "params",
                                    json_object_get(record, "params"), "options",
                                    json_object_get(record, "options"), "file", file, "light", light));
    if (!json_object_get(maker->document, "made_on"))
        json_object_set(maker->document, "made_on", json_object_get(record, "fingerprint"));
    free(path);
    free(name);
    return ok;
}

/* A GPU's images must not be what GPUs are compared with. */
static bool is_of_software(const json_t *record, struct aob_error *error)
{
    const json_t *fingerprint = json_object_get(record, "fingerprint");
    return strcmp(aob_member_text(fingerprint, "class"), "cpu") == 0 ||
           aob_fail(error,
                    "%s was drawn by %s: the images must be of a software driver: run with --device llvmpipe",
                    aob_member_text(record, "technique"), aob_member_text(fingerprint, "device"));
}

static bool add_record(struct maker *maker, const char *run, const json_t *record, bool timed,
                       struct aob_error *error)
{
    struct aob_image image = {0};
    if (strcmp(aob_member_text(record, "status"), "ok") != 0)
        return aob_fail(error, "%s is %s: %s", aob_member_text(record, "technique"),
                        aob_member_text(record, "status"), aob_member_text(record, "reason"));
    if (!is_of_software(record, error))
        return false;
    char *path = aob_path_join(run, aob_member_text(record, "image"));
    bool ok = aob_image_read(&image, path, error);
    free(path);
    if (ok && timed)
        ok = place_view(maker, record, &image, true, error) >= 0;
    else if (ok)
        ok = add_image(maker, record, &image, error);
    aob_image_finish(&image);
    return ok;
}

static bool add_run(struct maker *maker, const char *run, bool timed, struct aob_error *error)
{
    char *path = aob_path_join(run, "journal.jsonl");
    json_t *records = aob_journal_read(path, NULL, error);
    bool ok = records && (json_array_size(records) || aob_fail(error, "no cases"));
    for (size_t i = 0; ok && i < json_array_size(records); i++)
        ok = add_record(maker, run, json_array_get(records, i), timed, error);
    if (!ok)
        aob_fail_in(error, "%s", path);
    json_decref(records);
    free(path);
    return ok;
}

static json_t *list_techniques(const struct aob_registry *registry)
{
    json_t *techniques = json_object();
    for (size_t i = 0; i < registry->count; i++)
        json_object_set_new(techniques, registry->entries[i].technique->name,
                            json_string(registry->entries[i].digest));
    return techniques;
}

static bool make(const char *folder, char *const *runs, size_t run_count, struct aob_error *error)
{
    struct maker maker = {.folder = folder, .views = json_array(), .images = json_array()};
    aob_registry_init(&maker.registry);
    maker.document =
        json_pack("{s:s, s:o, s:o, s:o}", "schema", AOB_CHECK_DATA_SCHEMA, "techniques",
                  list_techniques(&maker.registry), "views", maker.views, "images", maker.images);
    char *path = aob_path_join(folder, "check.json");
    bool ok = aob_folder_create(folder, error);
    for (size_t i = 0; ok && i < run_count; i++)
        ok = add_run(&maker, runs[i], i == 0, error);
    ok = ok && aob_json_write(maker.document, path, error);
    free(path);
    json_decref(maker.document);
    aob_registry_finish(&maker.registry);
    return ok;
}

int main(int argc, char **argv)
{
    struct aob_error error = {{0}};
    bool ok = argc > 3 ? make(argv[1], argv + 2, (size_t)argc - 2, &error)
                       : aob_fail(&error, "usage: gpu-check-data FOLDER TIMES IMAGES...");
    if (!ok)
        aob_error_print(&error);
    return ok ? AOB_EXIT_OK : AOB_EXIT_USAGE;
}
