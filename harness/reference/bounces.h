/* What comes along a ray in the near field: the distant light, or what surfaces within the radius reflect diffusely. The
 * inner part of the traces of light, for their threads. */
#ifndef AOB_REFERENCE_BOUNCES_H
#define AOB_REFERENCE_BOUNCES_H
#include "incident.h"
#include "sampler.h"

struct aob_bounces {
    const struct aob_tracer *tracer;
    const struct aob_light *light; /* world space; NULL: radiance 1 from everywhere */
    float reach;                   /* unit space */
    int count;                     /* reflections */
};

/* A ray in unit space, what it has met, and the share of the light on it that counts. */
struct aob_bounce_path {
    float origin[3], direction[3];
    uint32_t primitive; /* Embree's number, or AOB_NO_PRIMITIVE */
    double share[3];
};

/* Adds to `sum` what comes along the path, times its share. Where it is blocked it goes on in one random direction at a
 * time, until it is open, has been reflected `count` times and is blocked again, or nothing is reflected. `seed` is the
 * path's own. */
void aob_bounces_follow(const struct aob_bounces *bounces, struct aob_bounce_path *path, uint64_t seed,
                        double sum[3]);

/* False after a line that begins with `name` if the count is not 0..AOB_MOST_BOUNCES or the light is not finite. */
bool aob_bounces_check(int count, const struct aob_light *light, const char *name, struct aob_error *error);
#endif
