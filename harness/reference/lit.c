#include "lit.h"
#include <math.h>
#include "embree_mesh.h"
#include "specular.h"

const char aob_lit_version[] = "2";

/* The two parts have directions of their own, so that their errors are independent. */
static const uint32_t other_seed = 0x9e3779b9u;

static void add_pixel(const struct aob_material *material, const struct aob_specular *mirrored, size_t at,
                      struct aob_incident *sum)
{
    for (int c = 0; c < 3; c++) {
        float diffuse = (1 - material->metalness) * material->base_colour[c];
        sum->rgb[at][c] = diffuse * sum->rgb[at][c] + mirrored->rgb[at][c];
        sum->se[at][c] = hypotf(diffuse * sum->se[at][c], mirrored->rgb_se[at][c]);
    }
}

static void add(const struct aob_tracer *tracer, const struct aob_hits *hits,
                const struct aob_incident_desc *desc, const struct aob_specular *mirrored,
                struct aob_incident *sum)
{
    int width = desc->width ? desc->width : hits->width, height = desc->height ? desc->height : hits->height;
    for (int y = 0; y < height; y++)
        for (int x = 0; x < width; x++) {
            size_t pixel = (size_t)(y + desc->y0) * (size_t)hits->width + (size_t)(x + desc->x0);
            if (hits->primitive[pixel] != AOB_NO_PRIMITIVE)
                add_pixel(aob_tracer_material(tracer, hits->primitive[pixel]), mirrored,
                          (size_t)y * (size_t)width + (size_t)x, sum);
        }
}

bool aob_tracer_lit(const struct aob_tracer *tracer, const struct aob_camera *camera,
                    const struct aob_hits *hits, const struct aob_incident_desc *desc,
                    struct aob_incident *result, struct aob_error *error)
{
    const struct aob_specular_desc lobe = {.radius = desc->radius,
                                           .roughness = -1,
                                           .radiance = true,
                                           .fresnel = true,
                                           .bounces = desc->bounces,
                                           .light = desc->light,
                                           .x0 = desc->x0,
                                           .y0 = desc->y0,
                                           .width = desc->width,
                                           .height = desc->height,
                                           .spp = desc->spp,
                                           .seed = desc->seed ^ other_seed};
    struct aob_specular mirrored = {0};
    if (!aob_tracer_incident(tracer, camera, hits, desc, result, error))
        return false;
    bool ok = aob_tracer_specular(tracer, camera, hits, &lobe, &mirrored, error);
    if (ok)
        add(tracer, hits, desc, &mirrored, result);
    else
        aob_incident_finish(result);
    aob_specular_finish(&mirrored);
    return ok;
}
