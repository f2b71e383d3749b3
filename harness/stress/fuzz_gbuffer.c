#include <float.h>
#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "fuzz_frame.h"

enum shape { PLANE, STEPS, WAVES, NOISE, SHAPE_COUNT };

struct surface {
    enum shape shape;
    double scale, slope[2], height, wave[2];
};

static struct surface draw_surface(struct aob_chance *chance, double scale)
{
    struct surface s = {.shape = (enum shape)aob_chance_below(chance, SHAPE_COUNT), .scale = scale};
    for (int i = 0; i < 2; i++) {
        s.slope[i] = aob_chance_between(chance, -0.04, 0.04);
        s.wave[i] = aob_chance_between(chance, -2, 2);
    }
    s.height = aob_chance_log(chance, 1e-3, 0.9);
    return s;
}

/* Depth at an image position. 1/z of a plane is linear in the image of a perspective view; that it is bent in an orthographic
 * one does no harm. */
static double depth_at(const struct surface *s, double x, double y)
{
    double plane = s->scale / fmax(1 + s->slope[0] * x + s->slope[1] * y, 0.02);
    switch (s->shape) {
    case STEPS:
        return plane * (sin(floor(x / 3) * 2.3 + floor(y / 4) * 1.7) > 0 ? 1 : 1 + s->height);
    case WAVES:
        return plane * (1 + 0.5 * s->height * sin(s->wave[0] * x + s->wave[1] * y));
    default:
        return plane;
    }
}

static struct aob_vec3 position(const struct aob_projection *p, double x, double y, double depth)
{
    double s = p->perspective ? depth : 1;
    return aob_vec((x - p->cx) * p->sx * s, -(y - p->cy) * p->sy * s, -depth);
}

/* A unit normal of the surface, towards the camera as the G-buffer holds it. */
static struct aob_vec3 normal_at(const struct aob_projection *p, const struct surface *s, double x, double y)
{
    struct aob_vec3 at = position(p, x, y, depth_at(s, x, y));
    struct aob_vec3 u = aob_vec_sub(position(p, x + 0.25, y, depth_at(s, x + 0.25, y)), at);
    struct aob_vec3 v = aob_vec_sub(position(p, x, y - 0.25, depth_at(s, x, y - 0.25)), at);
    return aob_vec_normalize(aob_vec_cross(u, v));
}

static struct aob_vec3 faced(struct aob_vec3 n, struct aob_vec3 to_eye)
{
    double cosine = aob_vec_dot(n, to_eye);
    struct aob_vec3 turned = aob_vec_scale(n, cosine < 0 ? -1 : 1);
    return fabs(cosine) > AOB_LEAST_FACING ? turned : to_eye;
}

static void put(float *into, struct aob_vec3 n)
{
    into[0] = (float)n.x;
    into[1] = (float)n.y;
    into[2] = (float)n.z;
    into[3] = 0;
}

static void fill_pixel(struct aob_fuzz_frame *frame, struct aob_chance *chance, const struct surface *s,
                       size_t i)
{
    const struct aob_projection *p = &frame->gbuffer.projection;
    double x = (double)(i % (size_t)p->width) + 0.5, y = (double)(i / (size_t)p->width) + 0.5;
    double depth = depth_at(s, x, y);
    struct aob_vec3 n = normal_at(p, s, x, y);
    if (s->shape == NOISE) {
        depth *= aob_chance_log(chance, 1, 1 + 30 * s->height);
        n = aob_chance_direction(chance);
    }
    struct aob_vec3 to_eye =
        p->perspective ? aob_vec_normalize(aob_vec_scale(position(p, x, y, depth), -1)) : aob_vec(0, 0, 1);
    n = faced(n, to_eye);
    struct aob_vec3 leaning =
        aob_vec_normalize(aob_vec_add(n, aob_vec_scale(aob_chance_direction(chance), 0.3)));
    frame->gbuffer.depth[i] = (float)depth;
    put(&frame->gbuffer.normal[4 * i], n);
    put(&frame->gbuffer.shading[4 * i], faced(leaning, to_eye));
}

static void fill_sky(struct aob_fuzz_frame *frame, size_t i)
{
    frame->pixels[i] = AOB_FUZZ_SKY;
    frame->gbuffer.depth[i] = AOB_GBUFFER_SKY;
    memset(&frame->gbuffer.normal[4 * i], 0, 4 * sizeof(float));
    memset(&frame->gbuffer.shading[4 * i], 0, 4 * sizeof(float));
}

static void spoil_depth(float *depth, struct aob_chance *chance)
{
    const float values[] = {NAN,   -NAN,    INFINITY,     -INFINITY,     0,
                            -0.0f, -*depth, FLT_TRUE_MIN, -FLT_TRUE_MIN, FLT_MIN,
                            1e8f,  4.9e8f,  1e20f,        FLT_MAX,       -FLT_MAX};
    *depth = values[aob_chance_below(chance, AOB_COUNT(values))];
}

static void spoil_normal(float *n, struct aob_chance *chance)
{
    static const float factors[] = {0, -1, 2, 0.25f, 1e-20f, 1e20f, FLT_MAX, NAN, INFINITY};
    float factor = factors[aob_chance_below(chance, AOB_COUNT(factors))];
    if (aob_chance_once_in(chance, 3))
        n[aob_chance_below(chance, 3)] *= factor;
    else
        for (int c = 0; c < 3; c++)
            n[c] *= factor;
}

static void spoil(struct aob_fuzz_frame *frame, struct aob_chance *chance, size_t i)
{
    size_t what = aob_chance_below(chance, 3);
    frame->pixels[i] = AOB_FUZZ_HOSTILE;
    if (what != 0)
        spoil_depth(&frame->gbuffer.depth[i], chance);
    if (what != 1) {
        spoil_normal(&frame->gbuffer.normal[4 * i], chance);
        memcpy(&frame->gbuffer.shading[4 * i], &frame->gbuffer.normal[4 * i], 4 * sizeof(float));
    }
}

/* Half of the frames are what a renderer could have written. Of the others one pixel, a few, or all are hostile. */
static void spoil_some(struct aob_fuzz_frame *frame, struct aob_chance *chance)
{
    static const size_t one_in[] = {1, 2, 8, 64};
    size_t count = aob_fuzz_frame_pixels(frame);
    if (aob_chance_once_in(chance, 2))
        return;
    if (aob_chance_once_in(chance, 3)) {
        spoil(frame, chance, aob_chance_below(chance, count));
        return;
    }
    size_t share = one_in[aob_chance_below(chance, AOB_COUNT(one_in))];
    for (size_t i = 0; i < count; i++)
        if (aob_chance_once_in(chance, share))
            spoil(frame, chance, i);
}

void aob_fuzz_gbuffer_fill(struct aob_fuzz_frame *frame, struct aob_chance *chance, double scale)
{
    struct surface surface = draw_surface(chance, scale);
    size_t count = aob_fuzz_frame_pixels(frame);
    bool holes = aob_chance_once_in(chance, 3);
    size_t share = 1 + aob_chance_below(chance, 12);
    for (size_t i = 0; i < count; i++) {
        fill_pixel(frame, chance, &surface, i);
        if (holes && aob_chance_once_in(chance, share))
            fill_sky(frame, i);
    }
    memcpy(frame->calm_depth, frame->gbuffer.depth, count * sizeof(float));
    memcpy(frame->calm_normal, frame->gbuffer.normal, 4 * count * sizeof(float));
    spoil_some(frame, chance);
}
