#include "bounces.h"
#include <math.h>
#include <string.h>
#include "gather.h"

static void add_light(const struct aob_bounces *bounces, const struct aob_bounce_path *path, double sum[3])
{
    double radiance[3] = {1, 1, 1};
    if (bounces->light)
        aob_light_radiance(bounces->light,
                           aob_vec(path->direction[0], path->direction[1], path->direction[2]), radiance);
    for (int c = 0; c < 3; c++)
        sum[c] += path->share[c] * radiance[c];
}

/* False if nothing is reflected. */
static bool absorb(const struct aob_bounces *bounces, struct aob_bounce_path *path)
{
    const struct aob_material *m =
        aob_tracer_material(bounces->tracer, bounces->tracer->triangle_of[path->primitive]);
    bool any = false;
    for (int c = 0; c < 3; c++) {
        path->share[c] *= (double)m->base_colour[c] * (1 - (double)m->metalness);
        any |= path->share[c] > 0;
    }
    return any;
}

void aob_bounces_follow(const struct aob_bounces *bounces, struct aob_bounce_path *path, uint64_t seed,
                        double sum[3])
{
    for (int bounce = 0; path->primitive != AOB_NO_PRIMITIVE; bounce++) {
        if (bounce == bounces->count || !absorb(bounces, path))
            return;
        struct aob_surface surface;
        aob_surface_met(bounces->tracer, path->origin, path->direction, path->primitive, &surface);
        memcpy(path->origin, surface.origin, sizeof path->origin);
        aob_sampler_direction(&surface.basis, aob_sampler_mix(seed, (uint64_t)bounce), path->direction);
        aob_gather_distance(bounces->tracer, path->origin, path->direction, bounces->reach, &path->primitive);
    }
    add_light(bounces, path, sum);
}

bool aob_bounces_check(int count, const struct aob_light *light, const char *name, struct aob_error *error)
{
    if (count < 0 || count > AOB_MOST_BOUNCES)
        return aob_fail(error, "%s: %d bounces: must be 0 to %d", name, count, AOB_MOST_BOUNCES);
    for (int i = 0; light && i < 9; i++)
        for (int c = 0; c < 3; c++)
            if (!isfinite(light->sh[i][c]))
                return aob_fail(error, "%s: coefficient %d of channel %d is not finite", name, i, c);
    return true;
}
