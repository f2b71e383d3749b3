#include "check_data.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "scene/camera_json.h"
#include "scene/light_json.h"
#include "technique/graph.h"
#include "technique/registry.h"

static bool same_techniques(const json_t *techniques)
{
    struct aob_registry registry;
    bool same = true;
    aob_registry_init(&registry);
    for (size_t i = 0; i < registry.count; i++) {
        const struct aob_registry_entry *entry = &registry.entries[i];
        const char *digest = json_string_value(json_object_get(techniques, entry->technique->name));
        same = same && digest && strcmp(digest, entry->digest) == 0;
    }
    aob_registry_finish(&registry);
    return same;
}

static bool read_view(const json_t *object, const char *folder, struct aob_check_view *view,
                      struct aob_error *error)
{
    const char *file;
    json_t *camera;
    int timed;
    if (json_unpack((json_t *)object, "{s:s, s:s, s:o, s:i, s:i, s:F, s:s, s:b}", "scene", &view->scene,
                    "view", &view->view, "camera", &camera, "width", &view->width, "height", &view->height,
                    "metre", &view->metre, "file", &file, "timed", &timed) != 0)
        return aob_fail(error, "a view lacks a field");
    view->timed = timed;
    view->file = aob_path_join(folder, file);
    return aob_camera_from_json(camera, &view->camera, error);
}

static bool read_image(const json_t *object, const char *folder, struct aob_check_data *data,
                       struct aob_error *error)
{
    struct aob_check_image *image = &data->images[data->image_count++];
    const char *file;
    json_t *params, *options, *light = NULL;
    int view;
    if (json_unpack((json_t *)object, "{s:s, s:i, s:i, s:s, s:o, s:o, s?o, s:s}", "name", &image->name,
                    "view", &view, "frames", &image->frames, "technique", &image->drawing.technique, "params",
                    &params, "options", &options, "light", &light, "file", &file) != 0 ||
        view < 0 || (size_t)view >= data->view_count || image->frames < 1)
        return aob_fail(error, "an image lacks a field, or is of no view");
    image->view = &data->views[view];
    image->drawing.params = params;
    image->drawing.options = options;
    image->drawing.light = aob_light_uniform;
    image->file = aob_path_join(folder, file);
    return !light || aob_light_from_json(light, &image->drawing.light) ||
           aob_fail(error, "the light of '%s' is not nine coefficients", image->name);
}

static bool read_document(struct aob_check_data *data, const char *folder, struct aob_error *error)
{
    const json_t *views = json_object_get(data->document, "views");
    const json_t *images = json_object_get(data->document, "images");
    const char *schema = json_string_value(json_object_get(data->document, "schema"));
    if (!schema || strcmp(schema, AOB_CHECK_DATA_SCHEMA) != 0)
        return aob_fail(error, "its schema is '%s', and this program reads '%s': pack it again",
                        schema ? schema : "", AOB_CHECK_DATA_SCHEMA);
    if (!same_techniques(json_object_get(data->document, "techniques")))
        return aob_fail(error, "it was made with other techniques than this program's: pack it again");
    data->views = AOB_NEW_ARRAY(struct aob_check_view, json_array_size(views) + 1);
    data->images = AOB_NEW_ARRAY(struct aob_check_image, json_array_size(images) + 1);
    for (size_t i = 0; i < json_array_size(views); i++)
        if (!read_view(json_array_get(views, i), folder, &data->views[data->view_count++], error))
            return false;
    for (size_t i = 0; i < json_array_size(images); i++)
        if (!read_image(json_array_get(images, i), folder, data, error))
            return false;
    return data->image_count || aob_fail(error, "it holds no image");
}

bool aob_check_data_load(struct aob_check_data *data, const char *folder, struct aob_error *error)
{
    char *path = aob_path_join(folder, "check.json");
    size_t size;
    *data = (struct aob_check_data){0};
    char *bytes = aob_file_read(path, (size_t)64 << 20, &size, error);
    bool ok = bytes;
    if (ok) {
        data->document = json_loadb(bytes, size, JSON_REJECT_DUPLICATES, NULL);
        ok = data->document ? read_document(data, folder, error) : aob_fail(error, "it is no JSON document");
        if (!ok)
            aob_fail_in(error, "%s", path);
    }
    if (!ok)
        aob_check_data_finish(data);
    free(bytes);
    free(path);
    return ok;
}

void aob_check_data_finish(struct aob_check_data *data)
{
    for (size_t i = 0; i < data->view_count; i++)
        free(data->views[i].file);
    for (size_t i = 0; i < data->image_count; i++)
        free(data->images[i].file);
    free(data->views);
    free(data->images);
    json_decref(data->document);
    *data = (struct aob_check_data){0};
}

void aob_check_channel_name(enum aob_output output, int component, char name[AOB_CHECK_CHANNEL_SIZE])
{
    const char *stem = aob_output_name(output);
    if (output == AOB_OUT_VISIBILITY)
        snprintf(name, AOB_CHECK_CHANNEL_SIZE, "AO");
    else if (output == AOB_OUT_BENT_NORMAL)
        snprintf(name, AOB_CHECK_CHANNEL_SIZE, "bent.%c", "XYZ"[component]);
    else if (aob_output_components(output) == 1)
        snprintf(name, AOB_CHECK_CHANNEL_SIZE, "%s", stem);
    else
        snprintf(name, AOB_CHECK_CHANNEL_SIZE, "%s.%c", stem, "RGB"[component]);
}

bool aob_check_file_read(struct aob_image *file, const char *path, const struct aob_check_view *view,
                         struct aob_error *error)
{
    if (!aob_image_read(file, path, error))
        return false;
    if (file->width == view->width && file->height == view->height)
        return true;
    aob_fail(error, "%s: it has %dx%d pixels in place of %dx%d: pack it again", path, file->width,
             file->height, view->width, view->height);
    aob_image_finish(file);
    return false;
}

float *aob_check_output(const struct aob_image *file, const char *whose, enum aob_output output)
{
    enum { MOST = 4 };
    char stems[MOST][AOB_CHECK_CHANNEL_SIZE], names[MOST][2 * AOB_CHECK_CHANNEL_SIZE];
    const char *channels[MOST];
    int count = aob_output_components(output);
    for (int c = 0; c < count; c++) {
        aob_check_channel_name(output, c, stems[c]);
        snprintf(names[c], sizeof names[c], "%s%s", whose, stems[c]);
        channels[c] = names[c];
    }
    return aob_image_interleaved(file, channels, (size_t)count, (size_t)count);
}
