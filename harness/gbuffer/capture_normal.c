#include "capture_surface.h"
#include <math.h>
#include <string.h>

static const double LEAN = 0.99905; /* the cosine of 2.5 degrees */

/* Below the one doubt the depth's word stands against the file's. Below the other it says which side of the surface is
 * seen, where the file's normal does not face the camera. */
static const double SURE = 1 / 128.0, LIKELY = 1 / 4.0;

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

/* Turns a unit vector of the file to the side that is seen. */
static struct aob_vec3 turn(struct aob_vec3 n, const struct aob_capture_surface *surface,
                            struct aob_vec3 to_camera)
{
    double faces = aob_vec_dot(n, to_camera);
    bool told = surface->doubt < (faces < 0 ? LIKELY : SURE);
    double side = told ? aob_vec_dot(n, surface->normal) : faces;
    return side < 0 ? aob_vec_scale(n, -1) : n;
}

static void store(float into[3], struct aob_vec3 n)
{
    const float normal[3] = {(float)n.x, (float)n.y, (float)n.z};
    memcpy(into, normal, sizeof normal);
}

static void set_normal(const struct context *context, const float *const planes[3], int x, int y)
{
    struct aob_capture *capture = context->capture;
    size_t i = (size_t)y * (size_t)capture->hits.width + (size_t)x;
    struct aob_capture_surface surface = aob_capture_surface_at(capture, &context->view, x, y);
    struct aob_vec3 n = planes[0] ? file_normal(context, planes, i) : aob_vec(0, 0, 0);
    double length = aob_vec_length(n);
    if (!(length > 1e-6) || !isfinite(length)) {
        n = surface.normal;
        capture->derived++;
    }
    if (!(fabs(aob_vec_length(n) - 1) < 1e-6)) /* a float's unit vector stays as it is */
        n = aob_vec_normalize(n);
    struct aob_vec3 to_camera = aob_capture_to_camera(&context->view, x, y);
    double least = fmin(AOB_LEAST_FACING, aob_vec_dot(surface.normal, to_camera));
    n = turn(n, &surface, to_camera);
    double faces = aob_vec_dot(n, to_camera);
    bool away = faces < least / 2 && surface.doubt < LIKELY; /* rounding is no lean */
    bool differs = surface.doubt < SURE && aob_vec_dot(n, surface.normal) < LEAN;
    bool leans = !capture->own && (away || differs); /* our own files have the normals of triangles */
    store(capture->hits.normal[i], leans ? surface.normal : n);
    store(capture->hits.shading[i], surface.doubt < LIKELY ? aob_vec_bend(n, to_camera, least) : n);
    capture->leaning += leans;
}

/* Where the file's normals do not serve in more than a few pixels, the user should know. */
static void tell(struct aob_capture *capture, const struct aob_capture_desc *desc, bool has_normals)
{
    size_t few = capture->surface / 20;
    if (has_normals && capture->derived > few)
        aob_capture_warn(capture, "%s: %zu of %zu pixels have no normal: theirs are derived from the depth",
                         desc->file, capture->derived, capture->surface);
    if (capture->leaning > few)
        aob_capture_warn(capture,
                         "%s: %zu of %zu normals lean more than 2.5 degrees away from the surface that the "
                         "depth shows, as bump-mapped ones do: that surface's serve; normals=shading gives a "
                         "technique the file's",
                         desc->file, capture->leaning, capture->surface);
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
            if (aob_capture_has_surface(capture, x, y))
                set_normal(&context, planes, x, y);
    tell(capture, desc, planes[0]);
    return true;
}
