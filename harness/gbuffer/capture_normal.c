#include "capture.h"
#include <math.h>
#include <string.h>

struct context {
    struct aob_capture *capture;
    struct aob_projection view;
    struct aob_vec3 right, up, back; /* of the view, in the space of the file's normals */
};

static bool set_axes(struct context *context, const struct aob_capture_desc *desc, struct aob_error *error)
{
    const struct aob_convention *c = &desc->convention;
    double hand = c->left_handed ? -1 : 1;
    context->right = aob_vec(1, 0, 0);
    context->up = aob_vec(0, 1, 0);
    context->back = aob_vec(0, 0, hand);
    if (c->normals != AOB_NORMALS_WORLD)
        return true;
    const struct aob_camera *camera = &context->capture->camera;
    bool stated = c->up[0] != 0 || c->up[1] != 0 || c->up[2] != 0;
    struct aob_vec3 up = stated ? aob_vec(c->up[0], c->up[1], c->up[2]) : aob_vec(0, 1, 0);
    context->back = aob_vec_normalize(aob_vec_sub(camera->eye, camera->target));
    struct aob_vec3 right = aob_vec_scale(aob_vec_cross(aob_vec_normalize(up), context->back), hand);
    if (!(aob_vec_length(right) > 1e-6))
        return aob_fail(error, "%s: the camera looks along the world's up: state another up", desc->file);
    context->right = aob_vec_normalize(right);
    context->up = aob_vec_scale(aob_vec_cross(context->back, context->right), hand);
    return true;
}

static struct aob_vec3 position(const struct context *context, int x, int y)
{
    const struct aob_hits *hits = &context->capture->hits;
    double depth = (double)hits->depth[(size_t)y * (size_t)hits->width + (size_t)x];
    double scale = context->view.perspective ? depth : 1;
    return aob_vec((x + 0.5 - context->view.cx) * context->view.sx * scale,
                   -(y + 0.5 - context->view.cy) * context->view.sy * scale, -depth);
}

static bool is_surface(const struct context *context, int x, int y)
{
    const struct aob_hits *hits = &context->capture->hits;
    return x >= 0 && y >= 0 && x < hits->width && y < hits->height &&
           hits->depth[(size_t)y * (size_t)hits->width + (size_t)x] > 0;
}

/* Finds the tangent along +(dx, dy) by the neighbour nearer in depth. False if both neighbours are sky. */
static bool slope(const struct context *context, int x, int y, int dx, int dy, struct aob_vec3 *step)
{
    struct aob_vec3 here = position(context, x, y);
    bool ahead = is_surface(context, x + dx, y + dy), behind = is_surface(context, x - dx, y - dy);
    struct aob_vec3 a = {0, 0, INFINITY}, b = {0, 0, INFINITY};
    if (ahead)
        a = aob_vec_sub(position(context, x + dx, y + dy), here);
    if (behind)
        b = aob_vec_sub(here, position(context, x - dx, y - dy));
    *step = fabs(a.z) <= fabs(b.z) ? a : b;
    return ahead || behind;
}

static struct aob_vec3 to_camera(const struct context *context, int x, int y)
{
    return context->view.perspective ? aob_vec_scale(position(context, x, y), -1) : aob_vec(0, 0, 1);
}

/* A pixel that stands alone faces the camera. */
static struct aob_vec3 derive(const struct context *context, int x, int y)
{
    struct aob_vec3 across, up;
    if (!slope(context, x, y, 1, 0, &across) || !slope(context, x, y, 0, -1, &up))
        return to_camera(context, x, y);
    return aob_vec_cross(across, up);
}

static struct aob_vec3 file_normal(const struct context *context, const float *const planes[3], size_t i)
{
    struct aob_vec3 n = aob_vec((double)planes[0][i], (double)planes[1][i], (double)planes[2][i]);
    return aob_vec(aob_vec_dot(n, context->right), aob_vec_dot(n, context->up),
                   aob_vec_dot(n, context->back));
}

/* Packed or otherwise coded vectors would pass for normals and spoil every figure, so they are refused. */
static bool judge_lengths(const struct aob_capture *capture, const struct aob_capture_desc *desc,
                          const float *const planes[3], struct aob_error *error)
{
    size_t count = 0, odd = 0;
    for (size_t i = 0; i < (size_t)capture->hits.width * (size_t)capture->hits.height; i++) {
        double length =
            aob_vec_length(aob_vec((double)planes[0][i], (double)planes[1][i], (double)planes[2][i]));
        if (!(capture->hits.depth[i] > 0) || !(length > 1e-6))
            continue;
        count++;
        odd += fabs(length - 1) > 0.1;
    }
    return odd <= count / 4 ||
           aob_fail(error,
                    "%s: %zu of %zu normals are not unit vectors; if they are packed into 0..1, unpack them "
                    "or state normals derived",
                    desc->file, odd, count);
}

static void set_normal(const struct context *context, const float *const planes[3], int x, int y)
{
    struct aob_hits *hits = &context->capture->hits;
    size_t i = (size_t)y * (size_t)hits->width + (size_t)x;
    struct aob_vec3 n = planes[0] ? file_normal(context, planes, i) : aob_vec(0, 0, 0);
    double length = aob_vec_length(n);
    if (!(length > 1e-6) || !isfinite(length)) {
        n = derive(context, x, y);
        context->capture->derived++;
    }
    if (!(fabs(aob_vec_length(n) - 1) < 1e-6)) /* a float's unit vector stays as it is */
        n = aob_vec_normalize(n);
    if (aob_vec_dot(n, to_camera(context, x, y)) < 0)
        n = aob_vec_scale(n, -1);
    float normal[3] = {(float)n.x, (float)n.y, (float)n.z};
    memcpy(hits->normal[i], normal, sizeof normal);
    memcpy(hits->shading[i], normal, sizeof normal);
}

bool aob_capture_normals(struct aob_capture *capture, const struct aob_capture_desc *desc,
                         const float *const planes[3], bool camera_known, struct aob_error *error)
{
    const struct aob_hits *hits = &capture->hits;
    struct context context = {.capture = capture};
    context.view = aob_camera_projection(&capture->camera, hits->width, hits->height, 0);
    if (planes[0] && desc->convention.normals == AOB_NORMALS_WORLD && !camera_known)
        return aob_fail(error,
                        "%s: normals in world space need the camera: state eye and target, or normals "
                        "derived",
                        desc->file);
    if (planes[0] && (!set_axes(&context, desc, error) || !judge_lengths(capture, desc, planes, error)))
        return false;
    for (int y = 0; y < hits->height; y++)
        for (int x = 0; x < hits->width; x++)
            if (is_surface(&context, x, y))
                set_normal(&context, planes, x, y);
    return true;
}
