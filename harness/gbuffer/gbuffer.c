#include "gbuffer.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

const char aob_gbuffer_version[] = "2";

static const char *const normal_names[3] = {"N.X", "N.Y", "N.Z"};
static const char *const shading_names[3] = {"S.X", "S.Y", "S.Z"};

static void add_vectors(struct aob_image *image, const char *const names[3], const float (*vectors)[3],
                        size_t count)
{
    for (int c = 0; c < 3; c++) {
        float *channel = aob_image_add(image, names[c]);
        for (size_t i = 0; i < count; i++)
            channel[i] = vectors[i][c];
    }
}

static const char *const velocity_names[2] = {"V.X", "V.Y"};

static void add_velocity(struct aob_image *image, const struct aob_hits *hits, size_t count)
{
    for (int c = 0; c < 2 && hits->velocity; c++) {
        float *channel = aob_image_add(image, velocity_names[c]);
        for (size_t i = 0; i < count; i++)
            channel[i] = hits->velocity[i][c];
    }
}

static const char *const albedo_names[3] = {"albedo.R", "albedo.G", "albedo.B"};
static const char *const shine_names[2] = {"roughness", "metalness"};

/* One float of each material over the pixels: the float `at` bytes into it. */
static void add_property(struct aob_image *image, const char *name, size_t at, const struct aob_hits *hits,
                         const struct aob_mesh *mesh)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    float *channel = aob_image_add(image, name);
    for (size_t i = 0; i < count; i++)
        if (hits->primitive[i] != AOB_NO_PRIMITIVE)
            memcpy(&channel[i], (const char *)aob_mesh_material(mesh, hits->primitive[i]) + at,
                   sizeof channel[i]);
}

static void add_materials(struct aob_image *image, const struct aob_hits *hits, const struct aob_mesh *mesh,
                          size_t count)
{
    if (!mesh->materials)
        return;
    float *index = aob_image_add(image, "material");
    for (size_t i = 0; i < count; i++)
        index[i] = hits->primitive[i] == AOB_NO_PRIMITIVE
                       ? -1.0f
                       : (float)aob_mesh_material_index(mesh, hits->primitive[i]);
    for (size_t c = 0; c < 3; c++)
        add_property(image, albedo_names[c], offsetof(struct aob_material, base_colour) + c * sizeof(float),
                     hits, mesh);
    add_property(image, shine_names[0], offsetof(struct aob_material, roughness), hits, mesh);
    add_property(image, shine_names[1], offsetof(struct aob_material, metalness), hits, mesh);
}

bool aob_gbuffer_store(const struct aob_hits *hits, const struct aob_mesh *mesh, const char *path,
                       struct aob_error *error)
{
    struct aob_image image = {.width = hits->width, .height = hits->height};
    size_t count = (size_t)hits->width * (size_t)hits->height;
    memcpy(aob_image_add(&image, "Z"), hits->depth, count * sizeof(float));
    add_vectors(&image, normal_names, (const float(*)[3])hits->normal, count);
    add_vectors(&image, shading_names, (const float(*)[3])hits->shading, count);
    add_velocity(&image, hits, count);
    add_materials(&image, hits, mesh, count);
    float *primitive = aob_image_add(&image, "primitive");
    for (size_t i = 0; i < count; i++)
        primitive[i] = hits->primitive[i] == AOB_NO_PRIMITIVE ? -1.0f : (float)hits->primitive[i];
    bool ok = aob_image_write(&image, path, error);
    aob_image_finish(&image);
    return ok;
}

/* Returns `size` channels side by side with `stride` floats a pixel, the rest 0; NULL unless all channels are there. */
static float *interleave(const struct aob_image *image, const char *const *names, size_t size, size_t stride)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t c = 0; c < size; c++)
        if (!aob_image_channel(image, names[c]))
            return NULL;
    float *into = AOB_NEW_ARRAY(float, stride *count);
    for (size_t c = 0; c < size; c++) {
        const float *from = aob_image_channel(image, names[c]);
        for (size_t i = 0; i < count; i++)
            into[stride * i + c] = from[i];
    }
    return into;
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
    gbuffer->normal = interleave(image, normal_names, 3, 4);
    gbuffer->shading = interleave(image, shading_names, 3, 4);
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
    bool fits = image.width == gbuffer->projection.width && image.height == gbuffer->projection.height;
    size_t count = (size_t)image.width * (size_t)image.height;
    if (fits) {
        gbuffer->albedo = interleave(&image, albedo_names, 3, 3);
        gbuffer->shine = interleave(&image, shine_names, 2, 2);
        gbuffer->velocity = desc->camera->moves ? interleave(&image, velocity_names, 2, 2) : NULL;
    }
    bool ok = fits && copy_channels(gbuffer, &image, count) && !gbuffer->albedo == !gbuffer->shine &&
              !gbuffer->velocity == !desc->camera->moves;
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
