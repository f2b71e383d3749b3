#include "capture_surface.h"
#include <math.h>

static const double STRAIGHT = 1 / 4.0;

struct place {
    const struct aob_capture *capture;
    const struct aob_projection *view;
    int x, y, dx, dy; /* the axis on which it looks about */
};

static double depth_at(const struct aob_capture *capture, int x, int y)
{
    return (double)capture->hits.depth[(size_t)y * (size_t)capture->hits.width + (size_t)x];
}

bool aob_capture_has_surface(const struct aob_capture *capture, int x, int y)
{
    return x >= 0 && y >= 0 && x < capture->hits.width && y < capture->hits.height &&
           depth_at(capture, x, y) > 0;
}

static struct aob_vec3 position(const struct aob_projection *view, int x, int y, double depth)
{
    double scale = view->perspective ? depth : 1;
    return aob_vec((x + 0.5 - view->cx) * view->sx * scale, -(y + 0.5 - view->cy) * view->sy * scale, -depth);
}

struct aob_vec3 aob_capture_to_camera(const struct aob_projection *view, int x, int y)
{
    if (!view->perspective)
        return aob_vec(0, 0, 1);
    return aob_vec_normalize(aob_vec_scale(position(view, x, y, 1), -1));
}

static bool has(const struct place *p, int k)
{
    return aob_capture_has_surface(p->capture, p->x + k * p->dx, p->y + k * p->dy);
}

static struct aob_vec3 point(const struct place *p, int k)
{
    int x = p->x + k * p->dx, y = p->y + k * p->dy;
    return position(p->view, x, y, depth_at(p->capture, x, y));
}

/* What runs linearly over the image on a plane. */
static double linear(const struct place *p, int k)
{
    double depth = depth_at(p->capture, p->x + k * p->dx, p->y + k * p->dy);
    return p->view->perspective ? 1 / depth : depth;
}

/* By how much the two pixels on side k (1 or -1) of the axis miss the pixel's own depth if they foretell it. */
static double miss(const struct place *p, int k)
{
    if (!has(p, k) || !has(p, 2 * k))
        return INFINITY;
    double told = 2 * linear(p, k) - linear(p, 2 * k);
    if (!(told > 0))
        return INFINITY;
    return fabs((p->view->perspective ? 1 / told : told) - depth_at(p->capture, p->x, p->y));
}

struct tangent {
    struct aob_vec3 step; /* to the neighbour, along the axis */
    bool known;
    double doubt;
};

/* Of the step to side k. */
static double doubt_of(const struct place *p, int k, struct aob_vec3 step)
{
    const struct aob_capture_grain *grain = &p->capture->grain;
    double depth = depth_at(p->capture, p->x, p->y);
    double rounding = grain->flat + depth * (grain->relative + depth * grain->squared);
    double slant = aob_vec_length(position(p->view, p->x, p->y, 1));
    return fmax(miss(p, k), rounding) * (p->view->perspective ? slant : 1) / aob_vec_length(step);
}

static struct tangent tangent_along(const struct place *p)
{
    struct aob_vec3 here = point(p, 0);
    struct tangent ahead = {.known = has(p, 1), .doubt = INFINITY},
                   behind = {.known = has(p, -1), .doubt = INFINITY};
    if (ahead.known) {
        ahead.step = aob_vec_sub(point(p, 1), here);
        ahead.doubt = doubt_of(p, 1, ahead.step);
    }
    if (behind.known) {
        behind.step = aob_vec_sub(here, point(p, -1));
        behind.doubt = doubt_of(p, -1, behind.step);
    }
    if (!ahead.known || !behind.known)
        return ahead.known ? ahead : behind;
    if (ahead.doubt != behind.doubt && fmin(ahead.doubt, behind.doubt) < STRAIGHT)
        return ahead.doubt < behind.doubt ? ahead : behind;
    return fabs(ahead.step.z) <= fabs(behind.step.z) ? ahead : behind;
}

struct aob_capture_surface aob_capture_surface_at(const struct aob_capture *capture,
                                                  const struct aob_projection *view, int x, int y)
{
    struct tangent across = tangent_along(&(struct place){capture, view, x, y, 1, 0});
    struct tangent up = tangent_along(&(struct place){capture, view, x, y, 0, -1});
    struct aob_vec3 to_camera = aob_capture_to_camera(view, x, y);
    if (!across.known || !up.known)
        return (struct aob_capture_surface){to_camera, INFINITY};
    return (struct aob_capture_surface){aob_vec_normalize(aob_vec_cross(across.step, up.step)),
                                        fmax(across.doubt, up.doubt)};
}
