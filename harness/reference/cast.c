#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "embree_mesh.h"
#include "sampler.h"
#include "triangle.h"

enum { LANES = AOB_PACKET };

/* A primary ray in local space. The distance along it is the depth. */
struct primary {
    struct aob_vec3 origin, direction;
    double entry; /* where it enters the mesh's box; < 0: it misses it */
};

struct cast {
    const struct aob_tracer *tracer;
    const struct aob_camera *camera;
    const struct aob_projection *projection;
    struct aob_frame_axes axes;
    struct aob_hits *hits;
    struct aob_camera previous;
    struct aob_frame_axes previous_axes;
};

static void clip(double origin, double direction, double half, double *near, double *far)
{
    double a = (-half - origin) / direction, b = (half - origin) / direction;
    if (direction == 0) {
        a = fabs(origin) <= half ? -INFINITY : INFINITY;
        b = -a;
    }
    *near = fmax(*near, fmin(a, b));
    *far = fmin(*far, fmax(a, b));
}

/* Rays start at the box, so that a camera far outside costs no precision. */
static double box_entry(const struct aob_tracer *tracer, const struct primary *ray)
{
    double slack = 1e-4 / tracer->to_unit, near = 0, far = INFINITY;
    clip(ray->origin.x, ray->direction.x, tracer->half.x + slack, &near, &far);
    clip(ray->origin.y, ray->direction.y, tracer->half.y + slack, &near, &far);
    clip(ray->origin.z, ray->direction.z, tracer->half.z + slack, &near, &far);
    return near <= far ? near : -1;
}

static struct primary primary_ray(const struct cast *cast, int x, int y)
{
    struct primary ray;
    aob_camera_ray(cast->camera, cast->projection, x + 0.5, y + 0.5, &ray.origin, &ray.direction);
    ray.origin = aob_vec_sub(ray.origin, cast->tracer->centre);
    ray.entry = box_entry(cast->tracer, &ray);
    return ray;
}

static void set_lane(const struct cast *cast, const struct primary *ray, struct RTCRayHit16 *packet,
                     int *valid, int k)
{
    double scale = cast->tracer->to_unit;
    struct aob_vec3 start = aob_vec_add(ray->origin, aob_vec_scale(ray->direction, fmax(ray->entry, 0)));
    packet->ray.org_x[k] = (float)(start.x * scale);
    packet->ray.org_y[k] = (float)(start.y * scale);
    packet->ray.org_z[k] = (float)(start.z * scale);
    packet->ray.dir_x[k] = (float)ray->direction.x;
    packet->ray.dir_y[k] = (float)ray->direction.y;
    packet->ray.dir_z[k] = (float)ray->direction.z;
    packet->ray.tfar[k] = INFINITY;
    packet->ray.mask[k] = ~0u;
    packet->hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
    valid[k] = ray->entry >= 0 ? -1 : 0;
}

static void to_view(const struct aob_frame_axes *axes, struct aob_vec3 n, float out[3])
{
    out[0] = (float)aob_vec_dot(n, axes->right);
    out[1] = (float)aob_vec_dot(n, axes->up);
    out[2] = (float)aob_vec_dot(n, axes->back);
}

static struct aob_vec3 blend(const struct aob_vec3 *values, const uint32_t *index, double u, double v)
{
    struct aob_vec3 ab =
        aob_vec_add(aob_vec_scale(values[index[0]], 1 - u - v), aob_vec_scale(values[index[1]], u));
    return aob_vec_add(ab, aob_vec_scale(values[index[2]], v));
}

/* The shading normal on the camera's side of the surface. */
static struct aob_vec3 shading_normal(const struct aob_tracer *tracer, uint32_t triangle, double u, double v,
                                      struct aob_vec3 geometric)
{
    if (!tracer->normals)
        return geometric;
    struct aob_vec3 n = aob_vec_normalize(blend(tracer->normals, tracer->triangles[triangle], u, v));
    if (!(aob_vec_length(n) > 0.5))
        return geometric;
    return aob_vec_dot(n, geometric) < 0 ? aob_vec_scale(n, -1) : n;
}

/* The same, not turned away from the camera (tracer.h). The geometric normal stays as it is. */
static struct aob_vec3 face_camera(struct aob_vec3 n, struct aob_vec3 geometric, struct aob_vec3 direction)
{
    struct aob_vec3 to_camera = aob_vec_scale(aob_vec_normalize(direction), -1);
    return aob_vec_bend(n, to_camera, fmin(AOB_LEAST_FACING, aob_vec_dot(geometric, to_camera)));
}

/* How a world position less the previous eye, or a direction to the sky, was seen then. */
static void store_velocity(const struct cast *cast, struct aob_vec3 from_eye, double depth, size_t pixel)
{
    float *velocity = cast->hits->velocity[pixel];
    size_t width = (size_t)cast->hits->width;
    double then[2];
    if (!(depth > 0) || !aob_camera_project(&cast->previous, cast->projection, from_eye, then)) {
        velocity[0] = velocity[1] = velocity[2] = AOB_NO_VELOCITY;
        return;
    }
    velocity[0] = (float)((double)(pixel % width) + 0.5 - then[0]);
    velocity[1] = (float)((double)(pixel / width) + 0.5 - then[1]);
    velocity[2] = (float)depth;
}

/* `point` is in local space. */
static void store_point_velocity(const struct cast *cast, struct aob_vec3 point, uint32_t triangle,
                                 size_t pixel)
{
    const struct aob_tracer *tracer = cast->tracer;
    struct aob_vec3 from_eye = aob_vec_add(point, aob_vec_sub(tracer->centre, cast->previous.eye));
    if (triangle - tracer->moving_first < tracer->moving_count)
        from_eye = aob_vec_sub(from_eye, tracer->step);
    store_velocity(cast, from_eye, -aob_vec_dot(from_eye, cast->previous_axes.back), pixel);
}

static void store_sky_velocity(const struct cast *cast, const struct primary *ray, size_t pixel)
{
    float *velocity = cast->hits->velocity[pixel];
    velocity[2] = AOB_NO_VELOCITY;
    if (cast->projection->perspective)
        store_velocity(cast, ray->direction, AOB_NO_VELOCITY, pixel);
}

static void store_hit(const struct cast *cast, const struct primary *ray, uint32_t triangle, double u,
                      double v, size_t pixel)
{
    struct aob_vec3 corner[3];
    struct aob_vec3 normal = aob_tracer_corners(cast->tracer, triangle, corner);
    /* Embree's floats decide only which triangle it is. */
    aob_triangle_meet(ray->origin, ray->direction, corner, normal, &u, &v);
    struct aob_vec3 p = blend(cast->tracer->points, cast->tracer->triangles[triangle], u, v);
    normal = aob_vec_normalize(normal);
    if (aob_vec_dot(normal, ray->direction) > 0)
        normal = aob_vec_scale(normal, -1);
    struct aob_hits *hits = cast->hits;
    hits->primitive[pixel] = triangle;
    hits->u[pixel] = (float)u;
    hits->v[pixel] = (float)v;
    hits->depth[pixel] = (float)-aob_vec_dot(aob_vec_sub(p, ray->origin), cast->axes.back);
    to_view(&cast->axes, normal, hits->normal[pixel]);
    struct aob_vec3 shading = shading_normal(cast->tracer, triangle, u, v, normal);
    to_view(&cast->axes, face_camera(shading, normal, ray->direction), hits->shading[pixel]);
    if (hits->velocity)
        store_point_velocity(cast, p, triangle, pixel);
}

static void store_sky(const struct cast *cast, const struct primary *ray, size_t pixel)
{
    cast->hits->primitive[pixel] = AOB_NO_PRIMITIVE;
    if (cast->hits->velocity)
        store_sky_velocity(cast, ray, pixel);
}

static void cast_packet(const struct cast *cast, int x0, int y)
{
    int width = cast->hits->width, count = width - x0 < LANES ? width - x0 : LANES;
    struct primary rays[LANES];
    struct RTCRayHit16 packet __attribute__((aligned(64))) = {.ray.tnear = {0}};
    int valid[LANES] __attribute__((aligned(64))) = {0};
    for (int k = 0; k < count; k++) {
        rays[k] = primary_ray(cast, x0 + k, y);
        set_lane(cast, &rays[k], &packet, valid, k);
    }
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid, cast->tracer->scene, &context, &packet);
    for (int k = 0; k < count; k++) {
        size_t pixel = (size_t)y * (size_t)width + (size_t)(x0 + k);
        if (valid[k] && packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID)
            store_hit(cast, &rays[k], cast->tracer->triangle_of[packet.hit.primID[k]], packet.hit.u[k],
                      packet.hit.v[k], pixel);
        else
            store_sky(cast, &rays[k], pixel);
    }
}

static void hits_init(struct aob_hits *hits, int width, int height, bool moves)
{
    size_t pixels = (size_t)width * (size_t)height;
    *hits = (struct aob_hits){.width = width, .height = height};
    hits->primitive = aob_alloc(pixels, sizeof *hits->primitive);
    hits->u = aob_alloc(pixels, sizeof *hits->u);
    hits->v = aob_alloc(pixels, sizeof *hits->v);
    hits->depth = aob_alloc(pixels, sizeof *hits->depth);
    hits->normal = aob_alloc(pixels, sizeof *hits->normal);
    hits->shading = aob_alloc(pixels, sizeof *hits->shading);
    hits->velocity = moves ? aob_alloc(pixels, sizeof *hits->velocity) : NULL;
}

void aob_hits_finish(struct aob_hits *hits)
{
    free(hits->primitive);
    free(hits->u);
    free(hits->v);
    free(hits->depth);
    free(hits->normal);
    free(hits->shading);
    free(hits->velocity);
    *hits = (struct aob_hits){0};
}

void aob_tracer_cast(const struct aob_tracer *tracer, const struct aob_camera *camera,
                     const struct aob_projection *projection, struct aob_hits *hits)
{
    hits_init(hits, projection->width, projection->height, camera->moves || tracer->moving_count);
    struct cast cast = {.tracer = tracer,
                        .camera = camera,
                        .projection = projection,
                        .axes = aob_camera_axes(camera),
                        .hits = hits,
                        .previous = aob_camera_previous(camera)};
    cast.previous_axes = aob_camera_axes(&cast.previous);
#pragma omp parallel
    {
        unsigned mode = aob_float_mode_begin();
#pragma omp for schedule(dynamic)
        for (int y = 0; y < projection->height; y++)
            for (int x = 0; x < projection->width; x += LANES)
                cast_packet(&cast, x, y);
        aob_float_mode_end(mode);
    }
}
