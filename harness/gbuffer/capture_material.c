#include "capture.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "scene/material.h"

/* What rounding may add to 1. */
static const float slack = 1e-3f;

static const char *const whats[AOB_MATERIAL_CHANNELS] = {
    [AOB_MATERIAL_ALBEDO] = "base colour",
    [AOB_MATERIAL_ROUGHNESS] = "roughness",
    [AOB_MATERIAL_METALNESS] = "metalness",
};

/* One plane of the file, and where it goes. */
struct plane {
    const char *file;
    enum aob_material_channel which;
    const float *from; /* NULL: the file has none */
    float missing;     /* what it is then */
    float *into;
    size_t stride;
};

struct beyond { /* values that are no share */
    size_t count;
    double low, high;
};

static bool take_plane(struct aob_capture *capture, const struct plane *plane, struct beyond *beyond,
                       struct aob_error *error)
{
    const struct aob_hits *hits = &capture->hits;
    for (size_t i = 0; i < (size_t)hits->width * (size_t)hits->height; i++) {
        float value = plane->from ? plane->from[i] : plane->missing;
        if (hits->primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        if (!isfinite(value))
            return aob_fail(error,
                            "%s: pixel (%zu, %zu) has a surface, and its %s is %g: write a number within "
                            "0..1 there, or state materials none",
                            plane->file, i % (size_t)hits->width, i / (size_t)hits->width,
                            whats[plane->which], (double)value);
        if (value < -slack || value > 1 + slack) {
            beyond->count++;
            beyond->low = fmin(beyond->low, (double)value);
            beyond->high = fmax(beyond->high, (double)value);
        }
        plane->into[i * plane->stride] = fminf(fmaxf(value, 0), 1);
    }
    return true;
}

/* A few numbers beyond are clamped, as those of a mesh file are. Many are no shares at all: bytes, or light. */
static bool judge_beyond(struct aob_capture *capture, const char *file, enum aob_material_channel which,
                         const struct beyond *beyond, struct aob_error *error)
{
    size_t values = capture->surface * (which == AOB_MATERIAL_ALBEDO ? 3 : 1);
    if (beyond->count > values / 4)
        return aob_fail(error,
                        "%s: %zu of %zu numbers of its %s lie beyond 0..1 (%.4g to %.4g): write shares of 1 "
                        "without the light, or state materials none",
                        file, beyond->count, values, whats[which], beyond->low, beyond->high);
    if (beyond->count)
        aob_capture_warn(capture,
                         "%s: %zu of %zu numbers of its %s lie beyond 0..1 (%.4g to %.4g), and are clamped",
                         file, beyond->count, values, whats[which], beyond->low, beyond->high);
    return true;
}

static bool take(struct aob_capture *capture, const char *file, enum aob_material_channel which,
                 const float *const planes[3], struct aob_error *error)
{
    const bool colour = which == AOB_MATERIAL_ALBEDO;
    const struct aob_material *plain = &aob_material_default;
    struct beyond beyond = {0, INFINITY, -INFINITY};
    for (size_t c = 0; c < (colour ? 3 : 1); c++) {
        const struct plane plane = {.file = file,
                                    .which = which,
                                    .from = planes[c],
                                    .missing = colour                            ? plain->base_colour[c]
                                               : which == AOB_MATERIAL_ROUGHNESS ? plain->roughness
                                                                                 : plain->metalness,
                                    .into = colour ? capture->albedo + c
                                                   : capture->shine + (which == AOB_MATERIAL_METALNESS),
                                    .stride = colour ? 3 : 2};
        if (!take_plane(capture, &plane, &beyond, error))
            return false;
    }
    if (planes[0])
        capture->materials |= AOB_MATERIAL_BIT(which);
    return judge_beyond(capture, file, which, &beyond, error);
}

/* What is taken for granted where the other two are there. */
static void tell_missing(struct aob_capture *capture, const char *file)
{
    const unsigned seen = AOB_MATERIAL_BIT(AOB_MATERIAL_ALBEDO) | AOB_MATERIAL_BIT(AOB_MATERIAL_ROUGHNESS);
    if ((capture->materials & seen) == seen &&
        !(capture->materials & AOB_MATERIAL_BIT(AOB_MATERIAL_METALNESS)))
        aob_capture_warn(capture, "%s: it has no metalness, so all of it is taken for no metal", file);
}

bool aob_capture_materials(struct aob_capture *capture, const struct aob_capture_desc *desc,
                           const float *const planes[AOB_MATERIAL_CHANNELS][3], struct aob_error *error)
{
    size_t count = (size_t)capture->hits.width * (size_t)capture->hits.height;
    bool any = false, ok = true;
    for (int which = 0; which < AOB_MATERIAL_CHANNELS; which++)
        any = any || planes[which][0];
    if (!any)
        return true;
    capture->albedo = AOB_NEW_ARRAY(float, 3 * count);
    capture->shine = AOB_NEW_ARRAY(float, 2 * count);
    for (int which = 0; which < AOB_MATERIAL_CHANNELS && ok; which++)
        ok = take(capture, desc->file, (enum aob_material_channel)which, planes[which], error);
    if (ok)
        tell_missing(capture, desc->file);
    return ok;
}
