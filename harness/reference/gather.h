/* The rays of one pixel: where they start, and their closest hits. The inner part of aob_tracer_visibility,
 * apart so that the benchmark can trace the same rays. */
#ifndef AOB_REFERENCE_GATHER_H
#define AOB_REFERENCE_GATHER_H
#include "embree_mesh.h"
#include "sampler.h"

/* In unit space: the raised start of the rays, and the frame about the geometric normal. */
struct aob_surface {
    float origin[3];
    struct aob_basis basis;
};

/* `camera` is the one that cast the hits; the pixel must not be sky. */
void aob_surface_at(const struct aob_tracer *tracer, const struct aob_camera *camera,
                    const struct aob_hits *hits, size_t pixel, struct aob_surface *surface);

/* The scramble of one half (0 or 1) of a pixel's directions; `seed` is the trace's. */
uint64_t aob_gather_seed(const struct aob_hits *hits, size_t pixel, int half, uint32_t seed);

/* Finds the closest hits of `count` directions from `origin` within `reach` (unit space). distance[i] is less than
 * `reach` for a hit, and `reach` itself for a miss. primitive[i] is Embree's number of what is hit, or
 * AOB_NO_PRIMITIVE for a miss; `primitive` may be NULL. The arrays are padded like the sampler's. */
void aob_gather_distances(const struct aob_tracer *tracer, const float origin[3],
                          const struct aob_directions *directions, size_t count, float reach, float *distance,
                          uint32_t *primitive);
#endif
