#include "exhibit.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

bool aob_exhibit_init(struct aob_exhibit *exhibit, const struct aob_exhibit_desc *desc,
                      struct aob_error *error)
{
    struct aob_projection projection =
        aob_camera_projection(&desc->camera, desc->width, desc->height, desc->guard);
    *exhibit = (struct aob_exhibit){.mesh = *desc->mesh,
                                    .camera = desc->camera,
                                    .width = desc->width,
                                    .height = desc->height,
                                    .guard = desc->guard};
    *desc->mesh = (struct aob_mesh){0};
    exhibit->tracer = aob_tracer_create(&exhibit->mesh, error);
    if (!exhibit->tracer) {
        aob_exhibit_finish(exhibit);
        return false;
    }
    aob_tracer_cast(exhibit->tracer, &exhibit->camera, &projection, &exhibit->hits);
    aob_gbuffer_init(&exhibit->gbuffer, &exhibit->hits, &projection, exhibit->guard);
    aob_geometry_init(&exhibit->geometry, &exhibit->mesh, &exhibit->camera);
    return true;
}

void aob_exhibit_finish(struct aob_exhibit *exhibit)
{
    aob_geometry_finish(&exhibit->geometry);
    aob_gbuffer_finish(&exhibit->gbuffer);
    aob_hits_finish(&exhibit->hits);
    aob_tracer_destroy(exhibit->tracer);
    aob_mesh_finish(&exhibit->mesh);
    *exhibit = (struct aob_exhibit){0};
}

size_t aob_exhibit_pixels(const struct aob_exhibit *exhibit)
{
    return (size_t)exhibit->width * (size_t)exhibit->height;
}

size_t aob_exhibit_place(const struct aob_exhibit *exhibit, size_t i)
{
    size_t width = (size_t)exhibit->width, guard = (size_t)exhibit->guard;
    return (i / width + guard) * (width + 2 * guard) + i % width + guard;
}

float aob_exhibit_depth(const struct aob_exhibit *exhibit, size_t i)
{
    return exhibit->gbuffer.depth[aob_exhibit_place(exhibit, i)];
}

bool aob_exhibit_is_surface(const struct aob_exhibit *exhibit, size_t i)
{
    return aob_exhibit_depth(exhibit, i) < 0.5f * AOB_GBUFFER_SKY;
}

struct aob_vec3 aob_exhibit_position(const struct aob_exhibit *exhibit, size_t i)
{
    struct aob_vec3 origin, direction;
    size_t width = (size_t)exhibit->width;
    double x = (double)(i % width) + exhibit->guard + 0.5, y = (double)(i / width) + exhibit->guard + 0.5;
    aob_camera_ray(&exhibit->camera, &exhibit->gbuffer.projection, x, y, &origin, &direction);
    return aob_vec_add(origin, aob_vec_scale(direction, (double)aob_exhibit_depth(exhibit, i)));
}

void aob_exhibit_paint(struct aob_exhibit *exhibit, const float albedo[3], const float shine[2])
{
    struct aob_gbuffer *gbuffer = &exhibit->gbuffer;
    size_t count = (size_t)gbuffer->projection.width * (size_t)gbuffer->projection.height;
    if (!gbuffer->albedo) {
        gbuffer->albedo = AOB_NEW_ARRAY(float, 3 * count);
        gbuffer->shine = AOB_NEW_ARRAY(float, 2 * count);
    }
    for (size_t i = 0; i < count; i++) {
        memcpy(&gbuffer->albedo[3 * i], albedo, 3 * sizeof(float));
        memcpy(&gbuffer->shine[2 * i], shine, 2 * sizeof(float));
    }
}

struct aob_visibility_desc aob_exhibit_rays(const struct aob_exhibit *exhibit,
                                            const struct aob_visibility_term *term, int spp)
{
    return (struct aob_visibility_desc){.terms = term,
                                        .term_count = 1,
                                        .x0 = exhibit->guard,
                                        .y0 = exhibit->guard,
                                        .width = exhibit->width,
                                        .height = exhibit->height,
                                        .spp = spp};
}

bool aob_exhibit_trace(const struct aob_exhibit *exhibit, double radius, int spp, float *visibility,
                       struct aob_error *error)
{
    struct aob_visibility_term term = {.radius = radius};
    struct aob_visibility_desc desc = aob_exhibit_rays(exhibit, &term, spp);
    struct aob_visibility traced;
    if (!aob_tracer_visibility(exhibit->tracer, &exhibit->camera, &exhibit->hits, &desc, &traced, error))
        return false;
    memcpy(visibility, traced.ao, aob_exhibit_pixels(exhibit) * sizeof *visibility);
    aob_visibility_finish(&traced);
    return true;
}
