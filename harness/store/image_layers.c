#include "image_reader.h"
#include "base/memory.h"
#include "base/text.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The channels of all parts, one after the other. */
struct layers {
    char **names;
    bool *wanted;
    size_t count, capacity;
};

static bool list_part(struct aob_image_reader *r, int parts, struct layers *layers)
{
    const exr_attr_chlist_t *list = NULL;
    const char *name = NULL;
    if (!aob_image_reader_check(r, exr_get_channels(r->file, r->part, &list), "channels"))
        return false;
    if (parts > 1)
        exr_get_name(r->file, r->part, &name);
    size_t size = name ? strlen(name) : 0;
    for (int i = 0; list && i < list->num_channels; i++) {
        const char *channel = list->entries[i].name.str;
        bool whole = !size || (strncmp(channel, name, size) == 0 && channel[size] == '.');
        struct aob_text text = {0};
        aob_text_add(&text, "%s%s%s", whole ? "" : name, whole ? "" : ".", channel);
        *AOB_PUSH(layers->names, layers->count, layers->capacity) = text.data;
    }
    return true;
}

static bool list_layers(struct aob_image_reader *r, int parts, struct layers *layers)
{
    for (r->part = 0; r->part < parts; r->part++)
        if (!list_part(r, parts, layers))
            return false;
    layers->wanted = AOB_NEW_ARRAY(bool, layers->count + 1);
    return true;
}

/* The display window may be larger or smaller than the part that has pixels. */
static bool read_display(struct aob_image_reader *r, exr_attr_box2i_t *display)
{
    float aspect = 1;
    r->part = 0;
    if (!aob_image_reader_check(r, exr_get_display_window(r->file, 0, display), "image size") ||
        !aob_image_reader_check(r, exr_get_pixel_aspect_ratio(r->file, 0, &aspect), "shape of the pixels"))
        return false;
    int64_t width = (int64_t)display->max.x - display->min.x + 1;
    int64_t height = (int64_t)display->max.y - display->min.y + 1;
    if (width < 1 || height < 1 || width > AOB_LAYERS_MAX_SIDE || height > AOB_LAYERS_MAX_SIDE ||
        width * height > AOB_LAYERS_MAX_PIXELS)
        return aob_fail(r->error, "%s: refused: the image is %lld x %lld pixels", r->path, (long long)width,
                        (long long)height);
    if (!(aspect > 0.999f && aspect < 1.001f))
        return aob_fail(r->error, "%s: refused: its pixels are not square (pixel aspect ratio %g)", r->path,
                        (double)aspect);
    r->image->width = (int)width;
    r->image->height = (int)height;
    return true;
}

static void place(const struct aob_image *part, const float *from, const struct aob_image *image, float *into,
                  int64_t left, int64_t top)
{
    for (int y = 0; y < image->height; y++)
        for (int x = 0; x < image->width; x++) {
            int64_t u = x - left, v = y - top;
            bool inside = u >= 0 && v >= 0 && u < part->width && v < part->height;
            into[(size_t)y * (size_t)image->width + (size_t)x] =
                inside ? from[(size_t)v * (size_t)part->width + (size_t)u] : NAN;
        }
}

/* `first` is the part's first channel among the layers. */
static bool read_layers_of_part(struct aob_image_reader *r, const struct layers *layers, size_t first,
                                size_t count, const exr_attr_box2i_t *display)
{
    struct aob_image *image = r->image, part = {0};
    bool any = false;
    for (size_t i = first; i < first + count; i++)
        any = any || layers->wanted[i];
    if (!any)
        return true;
    r->image = &part;
    r->wanted = layers->wanted + first;
    bool ok = aob_image_reader_part(r);
    for (size_t i = first, next = 0; ok && i < first + count; i++) {
        if (!layers->wanted[i])
            continue;
        place(&part, part.channels[next++].pixels, image, aob_image_add(image, layers->names[i]),
              (int64_t)r->window.min.x - display->min.x, (int64_t)r->window.min.y - display->min.y);
    }
    aob_image_finish(&part);
    r->image = image;
    return ok;
}

static bool read_layers(struct aob_image_reader *r, const struct layers *layers, int parts)
{
    exr_attr_box2i_t display;
    size_t first = 0, wanted = 0;
    for (size_t i = 0; i < layers->count; i++)
        wanted += layers->wanted[i];
    if (!read_display(r, &display) || !aob_image_reader_fits(r, wanted) || !aob_image_reader_attributes(r))
        return false;
    for (r->part = 0; r->part < parts; r->part++) {
        const exr_attr_chlist_t *list = NULL;
        if (!aob_image_reader_check(r, exr_get_channels(r->file, r->part, &list), "channels"))
            return false;
        size_t count = list ? (size_t)list->num_channels : 0;
        if (!read_layers_of_part(r, layers, first, count, &display))
            return false;
        first += count;
    }
    return true;
}

bool aob_image_read_layers(struct aob_image *image, const char *path, aob_image_choose *choose, void *user,
                           struct aob_error *error)
{
    *image = (struct aob_image){0};
    struct aob_image_reader r = {.path = path, .image = image, .error = error};
    struct layers layers = {0};
    int parts = 0;
    if (!aob_image_reader_open(&r))
        return false;
    bool ok = aob_image_reader_check(&r, exr_get_count(r.file, &parts), "parts") &&
              list_layers(&r, parts, &layers) &&
              choose(user, (const char *const *)layers.names, layers.count, layers.wanted, error) &&
              read_layers(&r, &layers, parts);
    exr_finish(&r.file);
    for (size_t i = 0; i < layers.count; i++)
        free(layers.names[i]);
    free(layers.names);
    free(layers.wanted);
    if (!ok)
        aob_image_finish(image);
    return ok;
}
