#include "fuzz_shrink.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "scene/material.h"
#include "technique/param.h"

/* Drawings that it may take in all; what compiles anew costs half a second. */
enum { MOST_DRAWINGS = 400 };

struct shrinking {
    struct aob_fuzz_artist *artist;
    struct aob_fuzz_frame *frame;
    struct aob_fuzz_sight *sight;
    int drawings;
};

/* Takes the candidate, and keeps it if it fails in the same way. */
static bool keep_if_alike(struct shrinking *s, struct aob_fuzz_frame *candidate)
{
    struct aob_fuzz_sight sight = {.fault = AOB_FUZZ_FINE};
    if (s->drawings < MOST_DRAWINGS) {
        s->drawings++;
        aob_fuzz_draw(s->artist, candidate, &sight);
    }
    bool alike = sight.fault == s->sight->fault;
    struct aob_fuzz_frame gone = alike ? *s->frame : *candidate;
    struct aob_fuzz_sight unseen = alike ? *s->sight : sight;
    if (alike) {
        *s->frame = *candidate;
        *s->sight = sight;
    }
    aob_fuzz_frame_finish(&gone);
    aob_fuzz_sight_finish(&unseen);
    return alike;
}

static void move_pixel(struct aob_fuzz_frame *frame, size_t to, size_t from)
{
    frame->pixels[to] = frame->pixels[from];
    frame->gbuffer.depth[to] = frame->gbuffer.depth[from];
    frame->calm_depth[to] = frame->calm_depth[from];
    memmove(&frame->gbuffer.normal[4 * to], &frame->gbuffer.normal[4 * from], 4 * sizeof(float));
    memmove(&frame->gbuffer.shading[4 * to], &frame->gbuffer.shading[4 * from], 4 * sizeof(float));
    memmove(&frame->calm_normal[4 * to], &frame->calm_normal[4 * from], 4 * sizeof(float));
    memmove(&frame->gbuffer.albedo[3 * to], &frame->gbuffer.albedo[3 * from], 3 * sizeof(float));
    memmove(&frame->gbuffer.shine[2 * to], &frame->gbuffer.shine[2 * from], 2 * sizeof(float));
}

/* The part of the frame that begins at (x, y), guard bands included, seen by the same camera. */
static void crop(struct aob_fuzz_frame *frame, int x, int y, int width, int height)
{
    struct aob_projection *p = &frame->gbuffer.projection;
    for (int row = 0; row < height; row++)
        for (int column = 0; column < width; column++)
            move_pixel(frame, (size_t)row * (size_t)width + (size_t)column,
                       (size_t)(row + y) * (size_t)p->width + (size_t)(column + x));
    p->width = width;
    p->height = height;
    p->cx -= x;
    p->cy -= y;
}

static bool try_crop(struct shrinking *s, int left, int top, int right, int bottom)
{
    struct aob_fuzz_frame candidate;
    int width = s->frame->gbuffer.projection.width - left - right;
    int height = s->frame->gbuffer.projection.height - top - bottom;
    if (width <= 2 * s->frame->gbuffer.guard || height <= 2 * s->frame->gbuffer.guard)
        return false;
    aob_fuzz_frame_copy(&candidate, s->frame);
    crop(&candidate, left, top, width, height);
    return keep_if_alike(s, &candidate);
}

/* By halves, then by single rows and columns. */
static bool shrink_size(struct shrinking *s)
{
    bool any = false;
    for (int by = AOB_FUZZ_SIDE / 2; by > 0; by /= 2) {
        while (try_crop(s, by, 0, 0, 0) || try_crop(s, 0, by, 0, 0) || try_crop(s, 0, 0, by, 0) ||
               try_crop(s, 0, 0, 0, by))
            any = true;
    }
    return any;
}

/* Without its guard band, or else with that as a part of the image, which can be cropped then. */
static bool shrink_guard(struct shrinking *s)
{
    struct aob_fuzz_frame candidate;
    int guard = s->frame->gbuffer.guard;
    if (guard == 0)
        return false;
    aob_fuzz_frame_copy(&candidate, s->frame);
    candidate.gbuffer.guard = 0;
    crop(&candidate, guard, guard, aob_fuzz_frame_width(s->frame), aob_fuzz_frame_height(s->frame));
    if (keep_if_alike(s, &candidate))
        return true;
    aob_fuzz_frame_copy(&candidate, s->frame);
    candidate.gbuffer.guard = 0;
    return keep_if_alike(s, &candidate);
}

static void calm(struct aob_fuzz_frame *frame, size_t i)
{
    if (frame->pixels[i] != AOB_FUZZ_HOSTILE)
        return;
    frame->pixels[i] = frame->calm_depth[i] < AOB_GBUFFER_SKY ? AOB_FUZZ_SURFACE : AOB_FUZZ_SKY;
    frame->gbuffer.depth[i] = frame->calm_depth[i];
    memcpy(&frame->gbuffer.normal[4 * i], &frame->calm_normal[4 * i], 4 * sizeof(float));
    memcpy(&frame->gbuffer.shading[4 * i], &frame->calm_normal[4 * i], 4 * sizeof(float));
}

static bool try_calm(struct shrinking *s, size_t from, size_t count)
{
    struct aob_fuzz_frame candidate;
    size_t hostile = aob_fuzz_frame_hostile(s->frame), all = aob_fuzz_frame_pixels(s->frame);
    aob_fuzz_frame_copy(&candidate, s->frame);
    for (size_t i = from; i < from + count && i < all; i++)
        calm(&candidate, i);
    if (aob_fuzz_frame_hostile(&candidate) != hostile)
        return keep_if_alike(s, &candidate);
    aob_fuzz_frame_finish(&candidate);
    return false;
}

static bool shrink_hostile(struct shrinking *s)
{
    bool any = false;
    size_t all = aob_fuzz_frame_pixels(s->frame);
    for (size_t count = all; count > 0; count /= 2)
        for (size_t from = 0; from < all; from += count)
            any = try_calm(s, from, count) || any;
    return any;
}

/* One number of a table to its default. */
static bool try_default(struct shrinking *s, const struct aob_param *param, size_t offset)
{
    struct aob_fuzz_frame candidate;
    double *value = (double *)(void *)((char *)s->frame + offset);
    if (*value == param->initial)
        return false;
    aob_fuzz_frame_copy(&candidate, s->frame);
    *(double *)(void *)((char *)&candidate + offset) = param->initial;
    return keep_if_alike(s, &candidate);
}

static bool shrink_values(struct shrinking *s)
{
    const struct aob_technique *t = s->frame->technique;
    bool any = false;
    for (uint32_t i = 0; i < t->param_count; i++)
        any = try_default(s, &t->params[i], offsetof(struct aob_fuzz_frame, params) + i * sizeof(double)) ||
              any;
    for (size_t i = 0; i < AOB_OPTION_COUNT; i++)
        any = try_default(s, &aob_option_params[i],
                          offsetof(struct aob_fuzz_frame, options) + i * sizeof(double)) ||
              any;
    return any;
}

/* All calm surfaces at the depth of the first, facing the camera. */
static bool shrink_surface(struct shrinking *s)
{
    struct aob_fuzz_frame candidate;
    const float towards[4] = {0, 0, 1, 0};
    float depth = 0;
    aob_fuzz_frame_copy(&candidate, s->frame);
    for (size_t i = 0; i < aob_fuzz_frame_pixels(&candidate); i++) {
        if (candidate.pixels[i] != AOB_FUZZ_SURFACE)
            continue;
        depth = depth > 0 ? depth : candidate.gbuffer.depth[i];
        candidate.gbuffer.depth[i] = candidate.calm_depth[i] = depth;
        memcpy(&candidate.gbuffer.normal[4 * i], towards, sizeof towards);
        memcpy(&candidate.gbuffer.shading[4 * i], towards, sizeof towards);
        memcpy(&candidate.calm_normal[4 * i], towards, sizeof towards);
    }
    return keep_if_alike(s, &candidate);
}

/* One plain material throughout, and one radiance. */
static void shrink_light(struct shrinking *s)
{
    struct aob_fuzz_frame candidate;
    aob_fuzz_frame_copy(&candidate, s->frame);
    for (size_t i = 0; i < aob_fuzz_frame_pixels(&candidate); i++) {
        memcpy(&candidate.gbuffer.albedo[3 * i], aob_material_default.base_colour, 3 * sizeof(float));
        candidate.gbuffer.shine[2 * i] = aob_material_default.roughness;
        candidate.gbuffer.shine[2 * i + 1] = aob_material_default.metalness;
    }
    keep_if_alike(s, &candidate);
    aob_fuzz_frame_copy(&candidate, s->frame);
    candidate.light = aob_light_uniform;
    keep_if_alike(s, &candidate);
}

static bool shrink_triangles(struct shrinking *s)
{
    bool any = false;
    for (size_t i = s->frame->triangle_count;
         s->artist->triangles && i-- > 0 && s->frame->triangle_count > 1;) {
        struct aob_fuzz_frame candidate;
        aob_fuzz_frame_copy(&candidate, s->frame);
        memmove(candidate.corners[i], candidate.corners[i + 1],
                (candidate.triangle_count - i - 1) * sizeof candidate.corners[0]);
        candidate.triangle_count--;
        any = keep_if_alike(s, &candidate) || any;
    }
    return any;
}

/* What costs no compiling first. What is always another frame is tried once. */
void aob_fuzz_shrink(struct aob_fuzz_artist *artist, struct aob_fuzz_frame *frame,
                     struct aob_fuzz_sight *sight)
{
    struct shrinking s = {artist, frame, sight, 0};
    shrink_surface(&s);
    shrink_light(&s);
    for (bool any = true; any && s.drawings < MOST_DRAWINGS;) {
        any = shrink_guard(&s);
        any = shrink_size(&s) || any;
        any = shrink_hostile(&s) || any;
        any = shrink_triangles(&s) || any;
        any = shrink_values(&s) || any;
    }
}
