/* The rays of one pixel: where they start, and their closest hits. The traces share it, and the benchmark traces the
 * same rays. */
#ifndef AOB_REFERENCE_GATHER_H
#define AOB_REFERENCE_GATHER_H
#include "embree_mesh.h"
#include "sampler.h"

/* In unit space: the raised start of the rays, the frame about the geometric normal, and the unit vector to where the
 * point is seen from. */
struct aob_surface {
    float origin[3];
    struct aob_basis basis;
    struct aob_vec3 back;
};

/* `camera` is the one that cast the hits; the pixel must not be sky. */
void aob_surface_at(const struct aob_tracer *tracer, const struct aob_camera *camera,
                    const struct aob_hits *hits, size_t pixel, struct aob_surface *surface);

/* The same where a ray has met something, for the ray that goes on from there. `origin` and `direction` are of the
 * ray, in unit space, and `primitive` is Embree's number of what it met. The point is found in double precision on the
 * triangle, and is raised towards where the ray came from. The normal is on that side as well. */
void aob_surface_met(const struct aob_tracer *tracer, const float origin[3], const float direction[3],
                     uint32_t primitive, struct aob_surface *surface);

/* The scramble of one half (0 or 1) of a pixel's directions; `seed` is the trace's. */
uint64_t aob_gather_seed(const struct aob_hits *hits, size_t pixel, int half, uint32_t seed);

/* Finds the closest hits of `count` directions from `origin` within `reach` (unit space). distance[i] is less than
 * `reach` for a hit, and `reach` itself for a miss. primitive[i] is Embree's number of what is hit, or
 * AOB_NO_PRIMITIVE for a miss; `primitive` may be NULL. The arrays are padded like the sampler's. */
void aob_gather_distances(const struct aob_tracer *tracer, const float origin[3],
                          const struct aob_directions *directions, size_t count, float reach, float *distance,
                          uint32_t *primitive);

/* The same of one ray, with the same second look at near hits. `primitive` must not be NULL. */
float aob_gather_distance(const struct aob_tracer *tracer, const float origin[3], const float direction[3],
                          float reach, uint32_t *primitive);

/* Arrays for the rays of one half, in a thread's scratch. */
struct aob_rays {
    struct aob_directions directions;
    float *distance;
    uint32_t *primitive; /* NULL unless they are wanted */
};
void aob_rays_init(struct aob_rays *rays, const struct aob_sampler *sampler, bool primitives);
void aob_rays_finish(struct aob_rays *rays);
#endif
