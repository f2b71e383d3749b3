#include "gbuffer.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

const char aob_gbuffer_version[] = "3";

static const char *const normal_names[3] = {"N.X", "N.Y", "N.Z"};
static const char *const shading_names[3] = {"S.X", "S.Y", "S.Z"};

static const char *const velocity_names[3] = {"V.X", "V.Y", "V.Z"};
static const char *const albedo_names[3] = {"albedo.R", "albedo.G", "albedo.B"};
static const char *const shine_names[2] = {"roughness", "metalness"};

/* `count` channels of `count` floats a pixel; none of NULL. */
static void add_parts(struct aob_image *image, const char *const *names, const float *from, size_t count)
{
    for (size_t c = 0; c < count && from; c++)
        aob_image_add_part(image, names[c], from + c, count);
}

static void add_materials(struct aob_image *image, const struct aob_hits *hits, const struct aob_mesh *mesh,
                          size_t count)
{
    struct aob_gbuffer painted = {0};
    if (!mesh->materials)
        return;
    float *index = aob_image_add(image, "material");
    for (size_t i = 0; i < count; i++)
        index[i] = hits->primitive[i] == AOB_NO_PRIMITIVE
                       ? -1.0f
                       : (float)aob_mesh_material_index(mesh, hits->primitive[i]);
    aob_gbuffer_paint(&painted, hits, mesh);
    add_parts(image, albedo_names, painted.albedo, 3);
    add_parts(image, shine_names, painted.shine, 2);
    aob_gbuffer_finish(&painted);
}

/* A mesh or the materials of each pixel; NULL: not these. */
struct painted {
    const struct aob_mesh *mesh;
    const float *albedo, *shine;
};

static bool store(const struct aob_hits *hits, const struct painted *painted, const char *path,
                  struct aob_error *error)
{
    struct aob_image image = {.width = hits->width, .height = hits->height};
    size_t count = (size_t)hits->width * (size_t)hits->height;
    memcpy(aob_image_add(&image, "Z"), hits->depth, count * sizeof(float));
    add_parts(&image, normal_names, hits->normal[0], 3);
    add_parts(&image, shading_names, hits->shading[0], 3);
    add_parts(&image, velocity_names, hits->velocity ? hits->velocity[0] : NULL, 3);
    if (painted->mesh)
        add_materials(&image, hits, painted->mesh, count);
    add_parts(&image, albedo_names, painted->albedo, 3);
    add_parts(&image, shine_names, painted->shine, 2);
    float *primitive = aob_image_add(&image, "primitive");
    for (size_t i = 0; i < count; i++)
        primitive[i] = hits->primitive[i] == AOB_NO_PRIMITIVE ? -1.0f : (float)hits->primitive[i];
    bool ok = aob_image_write(&image, path, error);
    aob_image_finish(&image);
    return ok;
}

bool aob_gbuffer_store(const struct aob_hits *hits, const struct aob_mesh *mesh, const char *path,
                       struct aob_error *error)
{
    return store(hits, &(struct painted){.mesh = mesh}, path, error);
}

bool aob_gbuffer_store_capture(const struct aob_hits *hits, const float *albedo, const float *shine,
                               const char *path, struct aob_error *error)
{
    return store(hits, &(struct painted){.albedo = albedo, .shine = shine}, path, error);
}

void aob_gbuffer_init(struct aob_gbuffer *gbuffer, const struct aob_hits *hits,
                      const struct aob_projection *projection, int guard)
{
    size_t count = (size_t)hits->width * (size_t)hits->height;
    *gbuffer = (struct aob_gbuffer){.projection = *projection, .guard = guard};
    gbuffer->depth = AOB_NEW_ARRAY(float, count);
    gbuffer->normal = AOB_NEW_ARRAY(float, 4 * count);
    gbuffer->shading = AOB_NEW_ARRAY(float, 4 * count);
    for (size_t i = 0; i < count; i++) {
        gbuffer->depth[i] = hits->depth[i] > 0 ? hits->depth[i] : AOB_GBUFFER_SKY;
        memcpy(&gbuffer->normal[4 * i], hits->normal[i], sizeof hits->normal[i]);
        memcpy(&gbuffer->shading[4 * i], hits->shading[i], sizeof hits->shading[i]);
    }
    if (!hits->velocity)
        return;
    gbuffer->velocity = AOB_NEW_ARRAY(float, 3 * count);
    memcpy(gbuffer->velocity, hits->velocity, count * sizeof *hits->velocity);
}

void aob_gbuffer_paint(struct aob_gbuffer *gbuffer, const struct aob_hits *hits, const struct aob_mesh *mesh)
{
    size_t count = (size_t)hits->width * (size_t)hits->height;
    if (!mesh->materials)
        return;
    gbuffer->albedo = AOB_NEW_ARRAY(float, 3 * count);
    gbuffer->shine = AOB_NEW_ARRAY(float, 2 * count);
    for (size_t i = 0; i < count; i++) {
        if (hits->primitive[i] == AOB_NO_PRIMITIVE)
            continue;
        const struct aob_material *material = aob_mesh_material(mesh, hits->primitive[i]);
        memcpy(&gbuffer->albedo[3 * i], material->base_colour, sizeof material->base_colour);
        gbuffer->shine[2 * i] = material->roughness;
        gbuffer->shine[2 * i + 1] = material->metalness;
    }
}

static bool copy_channels(struct aob_gbuffer *gbuffer, const struct aob_image *image, size_t count)
{
    const float *z = aob_image_channel(image, "Z");
    if (!z)
        return false;
    gbuffer->depth = AOB_NEW_ARRAY(float, count);
    for (size_t i = 0; i < count; i++)
        gbuffer->depth[i] = z[i] > 0 ? z[i] : AOB_GBUFFER_SKY;
    gbuffer->normal = aob_image_interleaved(image, normal_names, 3, 4);
    gbuffer->shading = aob_image_interleaved(image, shading_names, 3, 4);
    return gbuffer->normal && gbuffer->shading;
}

bool aob_gbuffer_load(struct aob_gbuffer *gbuffer, const char *path, const struct aob_gbuffer_desc *desc,
                      struct aob_error *error)
{
    struct aob_image image = {0};
    *gbuffer = (struct aob_gbuffer){
        .projection = aob_camera_projection(desc->camera, desc->width, desc->height, desc->guard),
        .guard = desc->guard};
    if (!aob_image_read(&image, path, error))
        return false;
    bool moves = desc->camera->moves || desc->objects_move;
    bool fits = image.width == gbuffer->projection.width && image.height == gbuffer->projection.height;
    size_t count = (size_t)image.width * (size_t)image.height;
    if (fits) {
        gbuffer->albedo = aob_image_interleaved(&image, albedo_names, 3, 3);
        gbuffer->shine = aob_image_interleaved(&image, shine_names, 2, 2);
        gbuffer->velocity = moves ? aob_image_interleaved(&image, velocity_names, 3, 3) : NULL;
    }
    bool ok = fits && copy_channels(gbuffer, &image, count) && !gbuffer->albedo == !gbuffer->shine &&
              !gbuffer->velocity == !moves;
    aob_image_finish(&image);
    if (!ok) {
        aob_gbuffer_finish(gbuffer);
        return aob_fail(error, "%s: it is not a G-buffer of %dx%d with a guard band of %d", path, desc->width,
                        desc->height, desc->guard);
    }
    return true;
}

void aob_gbuffer_hits(const struct aob_gbuffer *gbuffer, struct aob_hits *hits)
{
    size_t count = (size_t)gbuffer->projection.width * (size_t)gbuffer->projection.height;
    *hits = (struct aob_hits){.width = gbuffer->projection.width, .height = gbuffer->projection.height};
    hits->primitive = AOB_NEW_ARRAY(uint32_t, count);
    hits->depth = AOB_NEW_ARRAY(float, count);
    hits->normal = aob_alloc(count, sizeof *hits->normal);
    for (size_t i = 0; i < count; i++) {
        bool sky = gbuffer->depth[i] >= 0.5f * AOB_GBUFFER_SKY;
        hits->primitive[i] = sky ? AOB_NO_PRIMITIVE : 0;
        hits->depth[i] = sky ? 0 : gbuffer->depth[i];
        memcpy(hits->normal[i], &gbuffer->normal[4 * i], sizeof hits->normal[i]);
    }
}

void aob_gbuffer_finish(struct aob_gbuffer *gbuffer)
{
    free(gbuffer->depth);
    free(gbuffer->normal);
    free(gbuffer->shading);
    free(gbuffer->albedo);
    free(gbuffer->shine);
    free(gbuffer->velocity);
    *gbuffer = (struct aob_gbuffer){0};
}
