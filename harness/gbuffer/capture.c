#include "capture.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "capture_channel.h"
#include "store/image.h"

const char aob_capture_version[] = "capture 1";

/* The limit is half of what shaders take for sky, so that rounding does not make a surface of the sky. */
static const double FARTHEST = 5e8;
static const float LARGEST_HALF = 65504;

struct chosen {
    const struct aob_capture_desc *desc;
    struct aob_capture *capture;
    char depth[64], normal[3][64];
    bool has_normal;
};

static void warn_other(struct chosen *chosen, const char *what, const char *const *names, int taken,
                       int other)
{
    char a[64], b[64];
    if (other < 0)
        return;
    aob_capture_channel_print(names[taken], a, sizeof a);
    aob_capture_channel_print(names[other], b, sizeof b);
    aob_fail(&chosen->capture->warnings[chosen->capture->warning_count++],
             "%s: reads %s as %s; %s would do as well: choose by %s_channel", chosen->desc->file, a, what, b,
             what);
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
    return true;
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
    if (!stated && !fov && !ortho)
        return aob_fail(error,
                        "%s: the file does not say its field of view: state fov_deg (vertical) or "
                        "ortho_height (--fov, --ortho)",
                        desc->file);
    return aob_camera_check(camera, error) || aob_fail_in(error, "%s", desc->file);
}

/* Returns the distance along the view axis, or 0 for sky. `slant` is the length of the pixel's ray for a depth of 1. */
static double decode(const struct aob_convention *c, bool perspective, double z, double slant)
{
    if (!isfinite(z) || (c->depth != AOB_DEPTH_DEVICE && z <= 0))
        return 0;
    double depth = z;
    if (c->depth == AOB_DEPTH_DEVICE || c->depth == AOB_DEPTH_DEVICE_REVERSED) {
        double t = fmax(c->depth == AOB_DEPTH_DEVICE ? z : 1 - z, 0), rest = 1 - t;
        if (c->depth == AOB_DEPTH_DEVICE_REVERSED)
            rest = fmin(z, 1);
        if (!(rest > 0))
            return 0;
        if (perspective)
            depth = c->near / (rest + (isinf(c->far) ? 0 : c->near / c->far * t));
        else
            depth = c->near + t * (c->far - c->near);
    } else if ((float)z == LARGEST_HALF || (c->far > 0 && z >= c->far))
        return 0;
    else if (c->depth == AOB_DEPTH_DISTANCE)
        depth = z / slant;
    return depth > 0 && depth < FARTHEST ? depth : 0;
}

static bool judge_device(const struct aob_capture_desc *desc, int x, int y, double z, struct aob_error *error)
{
    bool device =
        desc->convention.depth == AOB_DEPTH_DEVICE || desc->convention.depth == AOB_DEPTH_DEVICE_REVERSED;
    return !device || !isfinite(z) || (z >= -1e-3 && z <= 1 + 1e-3) ||
           aob_fail(error, "%s: pixel (%d, %d) is %g: a device depth lies within 0..1; is it planar?",
                    desc->file, x, y, z);
}

static bool decode_depth(struct aob_capture *capture, const struct aob_capture_desc *desc, const float *z,
                         struct aob_error *error)
{
    struct aob_hits *hits = &capture->hits;
    struct aob_projection view = aob_camera_projection(&capture->camera, hits->width, hits->height, 0);
    bool device =
        desc->convention.depth == AOB_DEPTH_DEVICE || desc->convention.depth == AOB_DEPTH_DEVICE_REVERSED;
    if (device && !view.perspective && isinf(desc->convention.far))
        return aob_fail(error, "%s: the device depth of an orthographic view needs a finite far", desc->file);
    for (int y = 0; y < hits->height; y++)
        for (int x = 0; x < hits->width; x++) {
            size_t i = (size_t)y * (size_t)hits->width + (size_t)x;
            double across = (x + 0.5 - view.cx) * view.sx, down = (y + 0.5 - view.cy) * view.sy;
            double slant = view.perspective ? sqrt(1 + across * across + down * down) : 1;
            if (!judge_device(desc, x, y, (double)z[i], error))
                return false;
            hits->depth[i] = (float)decode(&desc->convention, view.perspective, (double)z[i], slant);
            hits->primitive[i] = hits->depth[i] > 0 ? 0 : AOB_NO_PRIMITIVE;
            capture->surface += hits->depth[i] > 0;
        }
    return capture->surface || aob_fail(error, "%s: no pixel has a surface: all depths are sky", desc->file);
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
    const float *normal[3] = {NULL};
    bool known;
    *capture = (struct aob_capture){0};
    if (!aob_image_read_layers(&image, desc->file, choose_channels, &chosen, error))
        return false;
    for (int c = 0; c < 3 && chosen.has_normal; c++)
        normal[c] = aob_image_channel(&image, chosen.normal[c]);
    allocate(&capture->hits, &image);
    bool ok = find_camera(capture, desc, &image, &known, error) &&
              decode_depth(capture, desc, aob_image_channel(&image, chosen.depth), error) &&
              aob_capture_normals(capture, desc, normal, known, error);
    aob_image_finish(&image);
    if (!ok)
        aob_capture_finish(capture);
    return ok;
}

void aob_capture_finish(struct aob_capture *capture)
{
    aob_hits_finish(&capture->hits);
    *capture = (struct aob_capture){0};
}
