#include "seen.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "lobe.h"
#include "scene/material.h"
#include "store/image.h"

/* Channels of the image; NULL where it has none. */
struct planes {
    const float *z, *normal[3], *albedo[3], *roughness, *metalness, *visible, *truth[3], *se[3];
};

static void find_three(const struct aob_image *image, const char *const names[3], const float *planes[3])
{
    for (int c = 0; c < 3; c++)
        planes[c] = aob_image_channel(image, names[c]);
}

static struct planes find_planes(const struct aob_image *image)
{
    struct planes p = {.z = aob_image_channel(image, "Z"),
                       .roughness = aob_image_channel(image, "roughness"),
                       .metalness = aob_image_channel(image, "metalness"),
                       .visible = aob_image_channel(image, "reference.AO")};
    find_three(image, (const char *const[]){"N.X", "N.Y", "N.Z"}, p.normal);
    find_three(image, (const char *const[]){"albedo.R", "albedo.G", "albedo.B"}, p.albedo);
    find_three(image, (const char *const[]){"reference.lit.R", "reference.lit.G", "reference.lit.B"},
               p.truth);
    find_three(image, (const char *const[]){"reference.SE.lit.R", "reference.SE.lit.G", "reference.SE.lit.B"},
               p.se);
    return p;
}

static double of_byte(double share)
{
    return rint(255 * share) / 255;
}

/* As a pass reads it (gbuffer/material_texels.h). */
static struct aob_material material_at(const struct planes *p, size_t i)
{
    struct aob_material m = aob_material_default;
    for (int c = 0; c < 3; c++) {
        double root = of_byte(sqrt((double)(p->albedo[c] ? p->albedo[c][i] : m.base_colour[c])));
        m.base_colour[c] = (float)(root * root);
    }
    m.roughness = (float)of_byte((double)(p->roughness ? p->roughness[i] : m.roughness));
    m.metalness = (float)of_byte((double)(p->metalness ? p->metalness[i] : m.metalness));
    return m;
}

struct reader {
    struct aob_seen *seen;
    struct planes planes;
    struct aob_projection projection;
    const struct aob_lobe_table *table;
};

static struct aob_vec3 view_vector(const struct reader *r, size_t i)
{
    const struct aob_projection *p = &r->projection;
    double x = (double)(i % (size_t)p->width) + 0.5, y = (double)(i / (size_t)p->width) + 0.5;
    if (!p->perspective)
        return aob_vec(0, 0, 1);
    return aob_vec_normalize(aob_vec(-(x - p->cx) * p->sx, (y - p->cy) * p->sy, 1));
}

static void take_truth(const struct planes *p, size_t i, struct aob_seen_surface *s)
{
    s->visible = p->visible ? p->visible[i] : NAN;
    for (int c = 0; c < 3; c++) {
        s->truth[c] = p->truth[c] ? p->truth[c][i] : NAN;
        s->se[c] = p->se[c] ? p->se[c][i] : NAN;
    }
}

static void take_surface(const struct reader *r, size_t i, struct aob_seen_surface *s)
{
    const struct planes *p = &r->planes;
    struct aob_material m = material_at(p, i);
    struct aob_lobe_surface lobe = {
        aob_vec((double)p->normal[0][i], (double)p->normal[1][i], (double)p->normal[2][i]),
        view_vector(r, i),
        (double)m.roughness,
        {0}};
    double light[3], open[3], even[3], metal = (double)m.metalness;
    for (int c = 0; c < 3; c++)
        lobe.f0[c] = 0.04 * (1 - metal) + (double)m.base_colour[c] * metal;
    aob_light_irradiance(&r->seen->light, lobe.normal, light);
    aob_lobe_mirror(r->table, &lobe, &r->seen->light, open, even);
    s->apart = (float)aob_lobe_apart(r->table, lobe.roughness, fabs(aob_vec_dot(lobe.normal, lobe.view)));
    for (int c = 0; c < 3; c++) {
        s->normal[c] = p->normal[c][i];
        s->diffuse[c] = (float)((1 - metal) * (double)m.base_colour[c]);
        s->light[c] = (float)light[c];
        s->mirror[c] = (float)open[c];
        s->even[c] = (float)even[c];
    }
    take_truth(p, i, s);
}

static void take_all(const struct reader *r)
{
    struct aob_seen *seen = r->seen;
    size_t pixels = (size_t)seen->width * (size_t)seen->height;
    for (size_t i = 0; i < pixels; i++)
        seen->count += isfinite(r->planes.z[i]);
    seen->pixel = AOB_NEW_ARRAY(size_t, seen->count + 1);
    seen->surfaces = AOB_NEW_ARRAY(struct aob_seen_surface, seen->count + 1);
    for (size_t i = 0, at = 0; i < pixels; i++)
        if (isfinite(r->planes.z[i]))
            seen->pixel[at++] = i;
#pragma omp parallel for
    for (size_t at = 0; at < seen->count; at++)
        take_surface(r, seen->pixel[at], &seen->surfaces[at]);
}

void aob_seen_find_mean(struct aob_seen *seen)
{
    double sum = 0;
    for (size_t i = 0; i < seen->count; i++)
        for (int c = 0; c < 3; c++) {
            double t = (double)seen->surfaces[i].truth[c], se = (double)seen->surfaces[i].se[c];
            sum += t * t - se * se;
        }
    seen->mean_light = sqrt(fmax(sum, 0) / (3 * (double)seen->count));
}

bool aob_seen_read(struct aob_seen *seen, const struct aob_seen_desc *desc, struct aob_error *error)
{
    struct aob_image image = {0};
    struct aob_frame_axes axes = aob_camera_axes(desc->camera);
    *seen = (struct aob_seen){0};
    if (!aob_image_read(&image, desc->image, error))
        return false;
    struct aob_lobe_table *table = aob_lobe_table_create();
    struct reader r = {seen, find_planes(&image),
                       aob_camera_projection(desc->camera, image.width, image.height, 0), table};
    bool ok = r.planes.z && r.planes.normal[0] && r.planes.normal[1] && r.planes.normal[2];
    seen->width = image.width;
    seen->height = image.height;
    seen->has_truth = r.planes.truth[0] && r.planes.truth[1] && r.planes.truth[2];
    seen->has_material = r.planes.albedo[0];
    aob_light_turn(desc->light, &axes, &seen->light);
    if (ok) {
        take_all(&r);
        aob_seen_find_mean(seen);
    }
    free(table);
    aob_image_finish(&image);
    return ok || aob_fail(error, "%s: it has no depth or no normals", desc->image);
}

void aob_seen_finish(struct aob_seen *seen)
{
    free(seen->pixel);
    free(seen->surfaces);
    *seen = (struct aob_seen){0};
}
