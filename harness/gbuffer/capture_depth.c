#include "capture.h"
#include <math.h>
#include "base/half.h"

/* The limit is half of what shaders take for sky, so that rounding does not make a surface of the sky. */
static const double FARTHEST = 5e8;
static const float LARGEST_HALF = 65504;

static bool is_device(const struct aob_convention *c)
{
    return c->depth == AOB_DEPTH_DEVICE || c->depth == AOB_DEPTH_DEVICE_REVERSED;
}

/* Returns the distance along the view axis, or 0 for sky. `slant` is the length of the pixel's ray for a depth of 1. */
static double decode(const struct aob_convention *c, bool perspective, double z, double slant)
{
    if (!isfinite(z) || (c->depth != AOB_DEPTH_DEVICE && z <= 0))
        return 0;
    double depth = z;
    if (is_device(c)) {
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
    return !is_device(&desc->convention) || !isfinite(z) || (z >= -1e-3 && z <= 1 + 1e-3) ||
           aob_fail(error, "%s: pixel (%d, %d) is %g: a device depth lies within 0..1; is it planar?",
                    desc->file, x, y, z);
}

/* What the values of the file have in common. */
struct values {
    double low, high;   /* of the surfaces, as the file has them */
    double farthest;    /* the greatest distance that they stand for */
    bool half, unorm16; /* all surfaces are numbers of that format */
    size_t negative;    /* values below 0 */
};

static void add_value(struct values *values, float z, float depth)
{
    double steps = (double)z * 65535;
    values->negative += z < 0;
    if (!(depth > 0))
        return;
    values->low = fmin(values->low, (double)z);
    values->high = fmax(values->high, (double)z);
    values->farthest = fmax(values->farthest, (double)depth);
    values->half = values->half && aob_half_to_float(aob_half_from_float(z)) == z;
    values->unorm16 = values->unorm16 && z <= 1 && fabs(steps - nearbyint(steps)) < 0.01;
}

/* A step is that of 16 bits of 0..1, of a half (2^-10 of the value at most, and 2^-11 of 0..1), or of a float. The
 * values of a reversed depth buffer shrink with the distance, and their steps with them. */
static void set_grain(struct aob_capture_grain *grain, const struct aob_convention *c, bool perspective,
                      const struct values *values)
{
    double step = values->unorm16 ? 0x1p-16 : values->half ? 0x1p-11 : 0x1p-24;
    bool shrinks = c->depth == AOB_DEPTH_DEVICE_REVERSED && !values->unorm16;
    if (!is_device(c) || (perspective && shrinks))
        *grain = (struct aob_capture_grain){.relative = 2 * step};
    else if (perspective)
        *grain = (struct aob_capture_grain){.squared = step / c->near};
    else
        *grain = (struct aob_capture_grain){.flat = step * (c->far - c->near)};
}

/* What is no depth along the view, or one of another kind than is stated, gives images all the same. */
static void doubt_values(struct aob_capture *capture, const struct aob_capture_desc *desc,
                         const struct values *values)
{
    const struct aob_convention *c = &desc->convention;
    bool stated = c->depth_stated || capture->own;
    if (!stated && values->high <= 1)
        aob_capture_warn(
            capture,
            "%s: every depth lies within 0..1 (%.3g to %.3g), as a mist, a normalised depth or a "
            "depth buffer does; state depth planar if these are lengths along the view, or what "
            "else they are",
            desc->file, values->low, values->high);
    if (!is_device(c) && values->half && values->high >= 32768)
        aob_capture_warn(
            capture,
            "%s: its depths are halfs and reach %.5g: a half ends at 65504, and what lies beyond "
            "is sky",
            desc->file, values->high);
    if (is_device(c) && values->farthest < 2 * c->near)
        aob_capture_warn(capture, "%s: every depth lies within twice near (%.3g to %.3g): is it %s?",
                         desc->file, c->near, values->farthest,
                         c->depth == AOB_DEPTH_DEVICE ? "device_reversed" : "device");
}

static bool judge_surface(const struct aob_capture *capture, const struct aob_capture_desc *desc,
                          const struct values *values, struct aob_error *error)
{
    size_t pixels = (size_t)capture->hits.width * (size_t)capture->hits.height;
    if (capture->surface)
        return true;
    if (values->negative)
        return aob_fail(error,
                        "%s: no pixel has a surface: %zu of %zu depths are below 0: write the distance from "
                        "the camera, above 0",
                        desc->file, values->negative, pixels);
    return aob_fail(error, "%s: no pixel has a surface: all depths are sky", desc->file);
}

bool aob_capture_depth(struct aob_capture *capture, const struct aob_capture_desc *desc, const float *z,
                       struct aob_error *error)
{
    struct aob_hits *hits = &capture->hits;
    struct aob_projection view = aob_camera_projection(&capture->camera, hits->width, hits->height, 0);
    struct values values = {.low = INFINITY, .half = true, .unorm16 = true};
    if (is_device(&desc->convention) && !view.perspective && isinf(desc->convention.far))
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
            add_value(&values, z[i], hits->depth[i]);
        }
    set_grain(&capture->grain, &desc->convention, view.perspective, &values);
    if (!judge_surface(capture, desc, &values, error))
        return false;
    doubt_values(capture, desc, &values);
    return true;
}
