#include "gather.h"
#include <float.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "triangle.h"

/* Rays start so far above their surface, in unit space. It is twice what the rounding of the start (half an ulp of at
 * most 0.5) and of a curved surface's corners asks for. */
#define LIFT FLT_EPSILON

/* The start is raised by moving it towards the camera, or towards where the ray before came from. From there the point
 * is seen, so it stays in front of every surface meeting there; a step along the normal may lead behind the other side of a crease. The step is at most 1024
 * times the lift, and the rest goes along the normal. */
static const double least_cosine = 1 / 1024.0;

/* Embree's triangle test errs by an ulp of the distance to the triangle's corners, so a triangle as large as the
 * scene can seem to lie above a start on its own plane. Such a false hit is nearer than error / least cosine; hits
 * nearer than this are checked again in double precision. */
static const float near_hit = 1 / 1024.f;

/* Duff et al. 2017, "Building an Orthonormal Basis, Revisited". */
static void build_basis(struct aob_vec3 n, struct aob_basis *basis)
{
    double sign = copysign(1, n.z), a = -1 / (sign + n.z), b = n.x * n.y * a;
    *basis = (struct aob_basis){
        .tangent = {(float)(1 + sign * n.x * n.x * a), (float)(sign * b), (float)(-sign * n.x)},
        .bitangent = {(float)b, (float)(sign + n.y * n.y * a), (float)-n.y},
        .normal = {(float)n.x, (float)n.y, (float)n.z},
    };
}

/* The direction towards the camera from a point in local space. */
static struct aob_vec3 sight(const struct aob_tracer *tracer, const struct aob_camera *camera,
                             const struct aob_frame_axes *axes, struct aob_vec3 local)
{
    if (camera->ortho_height > 0)
        return axes->back;
    return aob_vec_normalize(aob_vec_sub(aob_vec_sub(camera->eye, tracer->centre), local));
}

static struct aob_vec3 on_triangle(const struct aob_vec3 c[3], double u, double v)
{
    return aob_vec_add(aob_vec_scale(c[0], 1 - u - v),
                       aob_vec_add(aob_vec_scale(c[1], u), aob_vec_scale(c[2], v)));
}

static struct aob_vec3 hit_point(const struct aob_tracer *tracer, const struct aob_hits *hits, size_t pixel)
{
    struct aob_vec3 c[3];
    aob_tracer_corners(tracer, hits->primitive[pixel], c);
    return on_triangle(c, hits->u[pixel], hits->v[pixel]);
}

/* `back` points to where the point, in local space, is seen from; both vectors are unit. */
static void start_at(const struct aob_tracer *tracer, struct aob_vec3 local, struct aob_vec3 n,
                     struct aob_vec3 back, struct aob_surface *surface)
{
    double cosine = aob_vec_dot(n, back), pull = LIFT / fmax(cosine, least_cosine);
    struct aob_vec3 lift = aob_vec_add(aob_vec_scale(back, pull), aob_vec_scale(n, LIFT - pull * cosine));
    struct aob_vec3 p = aob_vec_add(aob_vec_scale(local, tracer->to_unit), lift);
    surface->origin[0] = (float)p.x;
    surface->origin[1] = (float)p.y;
    surface->origin[2] = (float)p.z;
    surface->back = back;
    build_basis(n, &surface->basis);
}

void aob_surface_at(const struct aob_tracer *tracer, const struct aob_camera *camera,
                    const struct aob_hits *hits, size_t pixel, struct aob_surface *surface)
{
    struct aob_frame_axes axes = aob_camera_axes(camera);
    const float *seen = hits->normal[pixel];
    struct aob_vec3 n =
        aob_vec_add(aob_vec_scale(axes.right, seen[0]),
                    aob_vec_add(aob_vec_scale(axes.up, seen[1]), aob_vec_scale(axes.back, seen[2])));
    n = aob_vec_normalize(n);
    struct aob_vec3 local = hit_point(tracer, hits, pixel);
    struct aob_vec3 back = sight(tracer, camera, &axes, local);
    start_at(tracer, local, n, back, surface);
}

static double side(const struct aob_vec3 corner[3], int a, int b)
{
    return aob_vec_length(aob_vec_sub(corner[b], corner[a]));
}

/* Moves a place that is nearer than two lifts to an edge away from it, within the triangle. A ray along a wall may meet
 * the floor so near to the wall that the rounding of the start, which the way back does not outdo, puts it behind: 6 in
 * 200 million rays within closed rooms left them. `area` is the normal's length, twice the triangle's area. */
static void keep_off_edges(const struct aob_tracer *tracer, const struct aob_vec3 corner[3], double area,
                           double *u, double *v)
{
    double part = 2 * LIFT / (tracer->to_unit * area), third = 1 / 3.0;
    double least_u = fmin(part * side(corner, 0, 2), third), least_v = fmin(part * side(corner, 0, 1), third);
    double most = 1 - fmin(part * side(corner, 1, 2), third) - least_u - least_v;
    double more_u = fmax(*u - least_u, 0), more_v = fmax(*v - least_v, 0);
    double scale = more_u + more_v > most ? most / (more_u + more_v) : 1;
    *u = least_u + more_u * scale;
    *v = least_v + more_v * scale;
}

void aob_surface_met(const struct aob_tracer *tracer, const float origin[3], const float direction[3],
                     uint32_t primitive, struct aob_surface *surface)
{
    struct aob_vec3 corner[3];
    struct aob_vec3 n = aob_tracer_corners(tracer, tracer->triangle_of[primitive], corner);
    struct aob_vec3 from = aob_vec_scale(aob_vec(origin[0], origin[1], origin[2]), 1 / tracer->to_unit);
    struct aob_vec3 along = aob_vec(direction[0], direction[1], direction[2]);
    double u = 1 / 3.0, v = 1 / 3.0;
    aob_triangle_meet(from, along, corner, n, &u, &v);
    keep_off_edges(tracer, corner, aob_vec_length(n), &u, &v);
    n = aob_vec_normalize(n);
    if (aob_vec_dot(n, along) > 0)
        n = aob_vec_scale(n, -1);
    start_at(tracer, on_triangle(corner, u, v), n, aob_vec_scale(along, -1), surface);
}

uint64_t aob_gather_seed(const struct aob_hits *hits, size_t pixel, int half, uint32_t seed)
{
    /* Places count from the middle, so that neither a guard band nor a part changes a pixel's rays. */
    size_t width = (size_t)hits->width;
    uint32_t across = (uint32_t)(pixel % width) - (uint32_t)(hits->width / 2);
    uint32_t down = (uint32_t)(pixel / width) - (uint32_t)(hits->height / 2);
    uint64_t place = (uint64_t)down << 32 | across;
    return aob_sampler_mix(place * 2 + (uint64_t)half, seed);
}

/* Whether a ray leaves the plane of the triangle that it is said to hit. */
static bool is_false_hit(const struct aob_tracer *tracer, const struct RTCRay *ray, unsigned primitive)
{
    struct aob_vec3 corner[3];
    struct aob_vec3 n = aob_tracer_corners(tracer, tracer->triangle_of[primitive], corner);
    struct aob_vec3 start = aob_vec(ray->org_x, ray->org_y, ray->org_z);
    double height = aob_vec_dot(n, aob_vec_sub(start, aob_vec_scale(corner[0], tracer->to_unit)));
    double climb = aob_vec_dot(n, aob_vec(ray->dir_x, ray->dir_y, ray->dir_z));
    return height * climb >= 0;
}

/* Replaces the near hit of a ray by its first true hit, or by `reach` if it has none. */
static void find_true_hit(const struct aob_tracer *tracer, struct RTCIntersectContext *context,
                          struct RTCRayHit *one, float near, float reach)
{
    while (one->ray.tfar < near && is_false_hit(tracer, &one->ray, one->hit.primID)) {
        one->ray.tnear = 2 * one->ray.tfar + FLT_EPSILON;
        one->ray.tfar = reach;
        one->hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(tracer->scene, context, one);
    }
}

/* The same for one ray of a packet. */
static void find_in_packet(const struct aob_tracer *tracer, struct RTCIntersectContext *context,
                           struct RTCRayHit16 *packet, int k, float near, float reach)
{
    struct RTCRayHit one = {
        .ray = {.org_x = packet->ray.org_x[k],
                .org_y = packet->ray.org_y[k],
                .org_z = packet->ray.org_z[k],
                .dir_x = packet->ray.dir_x[k],
                .dir_y = packet->ray.dir_y[k],
                .dir_z = packet->ray.dir_z[k],
                .tfar = packet->ray.tfar[k],
                .mask = ~0u},
        .hit = {.primID = packet->hit.primID[k], .geomID = packet->hit.geomID[k]},
    };
    find_true_hit(tracer, context, &one, near, reach);
    packet->ray.tfar[k] = one.ray.tfar;
    packet->hit.primID[k] = one.hit.primID;
    packet->hit.geomID[k] = one.hit.geomID;
}

static bool any_below(const float distance[AOB_PACKET], float near)
{
    int below = 0;
    for (int k = 0; k < AOB_PACKET; k++)
        below |= distance[k] < near;
    return below;
}

static void check_near_hits(const struct aob_tracer *tracer, struct RTCIntersectContext *context,
                            const int *valid, struct RTCRayHit16 *packet, float reach)
{
    float near = reach < near_hit ? reach : near_hit;
    if (!any_below(packet->ray.tfar, near))
        return;
    for (int k = 0; k < AOB_PACKET; k++)
        if (valid[k] && packet->ray.tfar[k] < near)
            find_in_packet(tracer, context, packet, k, near, reach);
}

static void fill(float lanes[AOB_PACKET], float value)
{
    for (int k = 0; k < AOB_PACKET; k++)
        lanes[k] = value;
}

/* rtcIntersect16 serves on every machine: with AVX2 alone it was measured at 0.92 of its speed with AVX-512.
 */
void aob_gather_distances(const struct aob_tracer *tracer, const float origin[3],
                          const struct aob_directions *directions, size_t count, float reach, float *distance,
                          uint32_t *primitive)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT; /* the sampler sees to it */
    struct RTCRayHit16 packet __attribute__((aligned(64)));
    int valid[AOB_PACKET] __attribute__((aligned(64)));
    memset(&packet, 0, sizeof packet);
    memset(packet.ray.mask, 0xff, sizeof packet.ray.mask);
    fill(packet.ray.org_x, origin[0]);
    fill(packet.ray.org_y, origin[1]);
    fill(packet.ray.org_z, origin[2]);
    for (size_t i = 0; i < count; i += AOB_PACKET) {
        memcpy(packet.ray.dir_x, directions->x + i, sizeof packet.ray.dir_x);
        memcpy(packet.ray.dir_y, directions->y + i, sizeof packet.ray.dir_y);
        memcpy(packet.ray.dir_z, directions->z + i, sizeof packet.ray.dir_z);
        fill(packet.ray.tfar, reach);
        memset(packet.hit.geomID, 0xff, sizeof packet.hit.geomID); /* RTC_INVALID_GEOMETRY_ID */
        for (int k = 0; k < AOB_PACKET; k++)
            valid[k] = i + (size_t)k < count ? -1 : 0;
        rtcIntersect16(valid, tracer->scene, &context, &packet);
        check_near_hits(tracer, &context, valid, &packet, reach);
        memcpy(distance + i, packet.ray.tfar, sizeof packet.ray.tfar);
        for (int k = 0; primitive && k < AOB_PACKET; k++)
            primitive[i + (size_t)k] =
                packet.hit.geomID[k] == RTC_INVALID_GEOMETRY_ID ? AOB_NO_PRIMITIVE : packet.hit.primID[k];
    }
}

float aob_gather_distance(const struct aob_tracer *tracer, const float origin[3], const float direction[3],
                          float reach, uint32_t *primitive)
{
    struct RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    struct RTCRayHit one = {
        .ray = {.org_x = origin[0],
                .org_y = origin[1],
                .org_z = origin[2],
                .dir_x = direction[0],
                .dir_y = direction[1],
                .dir_z = direction[2],
                .tfar = reach,
                .mask = ~0u},
        .hit = {.geomID = RTC_INVALID_GEOMETRY_ID},
    };
    rtcIntersect1(tracer->scene, &context, &one);
    find_true_hit(tracer, &context, &one, fminf(reach, near_hit), reach);
    *primitive = one.hit.geomID == RTC_INVALID_GEOMETRY_ID ? AOB_NO_PRIMITIVE : one.hit.primID;
    return one.ray.tfar;
}

void aob_rays_init(struct aob_rays *rays, const struct aob_sampler *sampler, bool primitives)
{
    size_t n = sampler->padded;
    float *b = aob_alloc(5 * n, sizeof *b);
    rays->directions = (struct aob_directions){b, b + n, b + 2 * n, b + 3 * n};
    rays->distance = b + 4 * n;
    rays->primitive = primitives ? aob_alloc(n, sizeof *rays->primitive) : NULL;
}

void aob_rays_finish(struct aob_rays *rays)
{
    free(rays->directions.x);
    free(rays->primitive);
    *rays = (struct aob_rays){0};
}
