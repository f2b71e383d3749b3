#include "facing.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"

/* What single precision may do to a unit vector, and to one that lies in the surface's horizon. */
static const double ROUNDING = 1e-6;

struct pixel {
    const struct aob_gbuffer *gbuffer;
    int x, y;
};

static struct aob_vec3 point(const struct aob_gbuffer *gbuffer, int x, int y)
{
    const struct aob_projection *view = &gbuffer->projection;
    double z = (double)gbuffer->depth[(size_t)y * (size_t)view->width + (size_t)x];
    double s = view->perspective ? z : 1;
    return aob_vec((x + 0.5 - view->cx) * view->sx * s, -(y + 0.5 - view->cy) * view->sy * s, -z);
}

/* The way over the surface along an axis of the image, towards the neighbour nearer in depth: as normal_from_depth.glsl. */
static struct aob_vec3 step_along(const struct pixel *p, int dx, int dy)
{
    const struct aob_projection *view = &p->gbuffer->projection;
    bool has_before = p->x >= dx && p->y >= dy,
         has_after = p->x + dx < view->width && p->y + dy < view->height;
    struct aob_vec3 c = point(p->gbuffer, p->x, p->y),
                    before = has_before ? point(p->gbuffer, p->x - dx, p->y - dy) : c,
                    after = has_after ? point(p->gbuffer, p->x + dx, p->y + dy) : c;
    bool forward = !has_before || (has_after && fabs(after.z - c.z) < fabs(c.z - before.z));
    return forward ? aob_vec_sub(after, c) : aob_vec_sub(c, before);
}

static struct aob_vec3 depth_normal(const struct pixel *p, struct aob_vec3 to_camera)
{
    struct aob_vec3 n = aob_vec_normalize(aob_vec_cross(step_along(p, 0, 1), step_along(p, 1, 0)));
    return aob_vec_dot(n, to_camera) > 0 ? n : to_camera; /* the one pixel of an image has no steps */
}

/* Of a pixel that shows a surface. */
static struct aob_vec3 facing_normal(const struct pixel *p, struct aob_vec3 n)
{
    struct aob_vec3 to_camera = p->gbuffer->projection.perspective
                                    ? aob_vec_normalize(aob_vec_scale(point(p->gbuffer, p->x, p->y), -1))
                                    : aob_vec(0, 0, 1);
    double length = aob_vec_length(n);
    if (!(length > ROUNDING) || !isfinite(length))
        return depth_normal(p, to_camera);
    if (fabs(length - 1) > ROUNDING)
        n = aob_vec_scale(n, 1 / length);
    if (aob_vec_dot(n, to_camera) >= -ROUNDING)
        return n;
    struct aob_vec3 surface = depth_normal(p, to_camera);
    if (aob_vec_dot(n, surface) < 0)
        return aob_vec_scale(n, -1);
    return aob_vec_bend(n, to_camera, fmin(AOB_LEAST_FACING, aob_vec_dot(surface, to_camera)));
}

float *aob_facing_normals(const struct aob_gbuffer *gbuffer, const float *normals)
{
    size_t width = (size_t)gbuffer->projection.width, count = width * (size_t)gbuffer->projection.height;
    float *facing = AOB_NEW_ARRAY(float, 4 * count);
    for (size_t i = 0; i < count; i++) {
        const float *n = &normals[4 * i];
        if (gbuffer->depth[i] >= 0.5f * AOB_GBUFFER_SKY)
            continue;
        struct aob_vec3 v = facing_normal(&(struct pixel){gbuffer, (int)(i % width), (int)(i / width)},
                                          aob_vec((double)n[0], (double)n[1], (double)n[2]));
        const float into[4] = {(float)v.x, (float)v.y, (float)v.z, 0};
        memcpy(&facing[4 * i], into, sizeof into);
    }
    return facing;
}
