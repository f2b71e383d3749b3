#include "capture.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "capture_channel.h"
#include "capture_material_channel.h"
#include "store/image.h"

const char aob_capture_version[] = "capture 3";

struct chosen {
    const struct aob_capture_desc *desc;
    struct aob_capture *capture;
    char depth[64], normal[3][64];
    char material[AOB_MATERIAL_CHANNELS][3][64]; /* empty: the file has none */
    bool has_normal;
};

void aob_capture_warn(struct aob_capture *capture, const char *format, ...)
{
    struct aob_error *line = &capture->warnings[capture->warning_count++];
    va_list arguments;
    va_start(arguments, format);
    aob_line_print_list(line->text, sizeof line->text, format, arguments);
    va_end(arguments);
}

static void warn_other(struct chosen *chosen, const char *what, const char *const *names, int taken,
                       int other)
{
    char a[64], b[64];
    if (other < 0)
        return;
    aob_capture_channel_print(names[taken], a, sizeof a);
    aob_capture_channel_print(names[other], b, sizeof b);
    aob_capture_warn(chosen->capture, "%s: reads %s as %s; %s would do as well: choose by %s_channel",
                     chosen->desc->file, a, what, b, what);
}

static void warn_mix(struct chosen *chosen, const char *const *names,
                     const struct aob_capture_channels *channels)
{
    char a[64], b[64];
    if (!channels->mixed)
        return;
    aob_capture_channel_print(names[channels->depth], a, sizeof a);
    aob_capture_channel_print(names[channels->normal[0]], b, sizeof b);
    aob_capture_warn(
        chosen->capture,
        "%s: its depth %s and its normal %s are of different layers: choose by depth_channel and "
        "normal_channel, or state normals derived",
        chosen->desc->file, a, b);
}

static void warn_materials(struct chosen *chosen, const char *const *names,
                           const struct aob_capture_channels *channels,
                           const struct aob_capture_material_channels *materials)
{
    char depth[64], own[64];
    for (int m = 0; m < AOB_MATERIAL_CHANNELS; m++) {
        const struct aob_capture_material_channel *channel = &materials->of[m];
        const char *what = aob_material_channel_names[m];
        warn_other(chosen, what, names, channel->at[0], channel->other);
        if (!channel->mixed)
            continue;
        aob_capture_channel_print(names[channels->depth], depth, sizeof depth);
        aob_capture_channel_print(names[channel->at[0]], own, sizeof own);
        aob_capture_warn(chosen->capture,
                         "%s: its depth %s and its %s %s are of different layers: choose by %s_channel, or "
                         "state materials none",
                         chosen->desc->file, depth, what, own, what);
    }
}

static bool choose_materials(struct chosen *chosen, const char *const *names, size_t count, bool *wanted,
                             const struct aob_capture_channels *channels, struct aob_error *error)
{
    struct aob_capture_material_channels materials;
    if (!aob_capture_materials_choose(&materials, names, count, channels->layer, &chosen->desc->convention,
                                      error))
        return aob_fail_in(error, "%s", chosen->desc->file);
    for (int m = 0; m < AOB_MATERIAL_CHANNELS; m++)
        for (int c = 0; c < 3 && materials.of[m].at[c] >= 0; c++) {
            wanted[materials.of[m].at[c]] = true;
            strcpy(chosen->material[m][c], names[materials.of[m].at[c]]);
        }
    warn_materials(chosen, names, channels, &materials);
    return true;
}

static bool choose_channels(void *user, const char *const *names, size_t count, bool *wanted,
                            struct aob_error *error)
{
    struct chosen *chosen = user;
    struct aob_capture_channels channels;
    if (!aob_capture_channels_choose(&channels, names, count, &chosen->desc->convention, error))
        return aob_fail_in(error, "%s", chosen->desc->file);
    wanted[channels.depth] = true;
    strcpy(chosen->depth, names[channels.depth]);
    chosen->has_normal = channels.normal[0] >= 0;
    for (int c = 0; c < 3 && chosen->has_normal; c++) {
        wanted[channels.normal[c]] = true;
        strcpy(chosen->normal[c], names[channels.normal[c]]);
    }
    warn_other(chosen, "depth", names, channels.depth, channels.other_depth);
    warn_other(chosen, "normal", names, channels.normal[0], channels.other_normal);
    warn_mix(chosen, names, &channels);
    return choose_materials(chosen, names, count, wanted, &channels, error);
}

static const struct aob_attribute *find_attribute(const struct aob_image *image, const char *name, int count)
{
    for (size_t i = 0; i < image->attribute_count; i++)
        if (strcmp(image->attributes[i].name, name) == 0 && image->attributes[i].count == count)
            return &image->attributes[i];
    return NULL;
}

static bool find_camera(struct aob_capture *capture, const struct aob_capture_desc *desc,
                        const struct aob_image *image, bool *known, struct aob_error *error)
{
    const struct aob_attribute *fov = find_attribute(image, "aobudget.fov_deg", 1),
                               *ortho = find_attribute(image, "aobudget.ortho_height", 1),
                               *eye = find_attribute(image, "aobudget.eye", 3),
                               *target = find_attribute(image, "aobudget.target", 3),
                               *shift = find_attribute(image, "aobudget.shift", 3);
    struct aob_camera *camera = &capture->camera;
    *camera = (struct aob_camera){.target = aob_vec(0, 0, -1)};
    *known = desc->has_camera || (eye && target);
    if (desc->has_camera) {
        camera->eye = desc->eye;
        camera->target = desc->target;
    } else if (*known) {
        camera->eye = aob_vec(eye->values[0], eye->values[1], eye->values[2]);
        camera->target = aob_vec(target->values[0], target->values[1], target->values[2]);
    }
    if (shift && (shift->values[0] != 0 || shift->values[1] != 0))
        return aob_fail(error, "%s: its view is off-centre (shift %g, %g): a capture must be centred",
                        desc->file, shift->values[0], shift->values[1]);
    bool stated = desc->fov_deg > 0 || desc->ortho_height > 0;
    camera->fov_deg = stated ? desc->fov_deg : fov ? fov->values[0] : 0;
    camera->ortho_height = stated ? desc->ortho_height : ortho ? ortho->values[0] : 0;
    capture->own = fov && ortho && eye && target && camera->fov_deg == fov->values[0] &&
                   camera->ortho_height == ortho->values[0];
    if (!stated && !fov && !ortho)
        return aob_fail(error,
                        "%s: the file does not say its field of view: state fov_deg (vertical) or "
                        "ortho_height (--fov, --ortho)",
                        desc->file);
    return aob_camera_check(camera, error) || aob_fail_in(error, "%s", desc->file);
}

static void allocate(struct aob_hits *hits, const struct aob_image *image)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    hits->width = image->width;
    hits->height = image->height;
    hits->primitive = AOB_NEW_ARRAY(uint32_t, count);
    hits->depth = AOB_NEW_ARRAY(float, count);
    hits->normal = aob_alloc(count, sizeof *hits->normal);
    hits->shading = aob_alloc(count, sizeof *hits->shading);
}

bool aob_capture_read(struct aob_capture *capture, const struct aob_capture_desc *desc,
                      struct aob_error *error)
{
    struct chosen chosen = {.desc = desc, .capture = capture};
    struct aob_image image;
    const float *normal[3] = {NULL}, *materials[AOB_MATERIAL_CHANNELS][3] = {{NULL}};
    bool known;
    *capture = (struct aob_capture){0};
    if (!aob_image_read_layers(&image, desc->file, choose_channels, &chosen, error))
        return false;
    for (int c = 0; c < 3 && chosen.has_normal; c++)
        normal[c] = aob_image_channel(&image, chosen.normal[c]);
    for (int m = 0; m < AOB_MATERIAL_CHANNELS; m++)
        for (int c = 0; c < 3 && *chosen.material[m][c]; c++)
            materials[m][c] = aob_image_channel(&image, chosen.material[m][c]);
    allocate(&capture->hits, &image);
    bool ok = find_camera(capture, desc, &image, &known, error) &&
              aob_capture_depth(capture, desc, aob_image_channel(&image, chosen.depth), error) &&
              aob_capture_normals(capture, desc, normal, known, error) &&
              aob_capture_materials(capture, desc, materials, error);
    aob_image_finish(&image);
    if (!ok)
        aob_capture_finish(capture);
    return ok;
}

void aob_capture_finish(struct aob_capture *capture)
{
    aob_hits_finish(&capture->hits);
    free(capture->albedo);
    free(capture->shine);
    *capture = (struct aob_capture){0};
}
