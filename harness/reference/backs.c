#include "backs.h"
#include <stdlib.h>
#include "base/memory.h"
#include "gather.h"

struct view {
    const struct aob_tracer *tracer;
    const struct aob_camera *camera;
    const struct aob_hits *hits;
    float reach; /* unit space */
    struct aob_sampler sampler;
};

static bool is_back(const struct aob_tracer *tracer, uint32_t triangle, struct aob_vec3 direction)
{
    struct aob_vec3 corner[3];
    return aob_vec_dot(aob_tracer_corners(tracer, triangle, corner), direction) > 0;
}

static size_t count_backs(const struct view *view, size_t pixel)
{
    struct aob_surface surface;
    float block[4][AOB_BACKS_RAYS], distance[AOB_BACKS_RAYS];
    uint32_t primitive[AOB_BACKS_RAYS];
    const struct aob_directions d = {block[0], block[1], block[2], block[3]};
    size_t backs = 0;
    aob_surface_at(view->tracer, view->camera, view->hits, pixel, &surface);
    aob_sampler_directions(&view->sampler, &surface.basis, aob_gather_seed(view->hits, pixel, 0, 0), &d);
    aob_gather_distances(view->tracer, surface.origin, &d, AOB_BACKS_RAYS, view->reach, distance, primitive);
    for (int i = 0; i < AOB_BACKS_RAYS; i++)
        backs += primitive[i] != AOB_NO_PRIMITIVE &&
                 is_back(view->tracer, view->tracer->triangle_of[primitive[i]],
                         aob_vec((double)d.x[i], (double)d.y[i], (double)d.z[i]));
    return backs;
}

double aob_tracer_backs(const struct aob_tracer *tracer, const struct aob_camera *camera,
                        const struct aob_hits *hits, double radius)
{
    struct view view = {tracer, camera, hits, (float)(radius * tracer->to_unit), {0}};
    size_t pixels = (size_t)hits->width * (size_t)hits->height, surfaces = 0, backs = 0;
    aob_sampler_init(&view.sampler, AOB_BACKS_RAYS, false);
    unsigned mode = aob_float_mode_begin();
    for (size_t i = 0; i < pixels; i++) {
        if (hits->primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        surfaces++;
        backs += count_backs(&view, i);
    }
    aob_float_mode_end(mode);
    aob_sampler_finish(&view.sampler);
    return surfaces ? (double)backs / ((double)surfaces * AOB_BACKS_RAYS) : 0;
}
