#include "case_image.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/hash.h"
#include "base/memory.h"
#include "effects.h"
#include "scene/material.h"
#include "score/bent.h"
#include "store/image.h"

void aob_case_image_finish(struct aob_case_image *image)
{
    free(image->depth);
    free(image->ao);
    free(image->bent);
    free(image->normal);
    free(image->open);
    free(image->truth);
    free(image->se);
    free(image->definition);
    free(image->screen);
    aob_case_effects_finish(image);
    *image = (struct aob_case_image){0};
}

void aob_case_image_crop(const struct aob_block *block, const float *from, int stride, float *into)
{
    const struct aob_job_view *view = &block->job.drawing.view;
    for (int y = 0; y < view->height; y++)
        for (int x = 0; x < view->width; x++)
            into[y * view->width + x] =
                from[((size_t)(y + view->guard) * (size_t)block->drawing.gbuffer.projection.width +
                      (size_t)(x + view->guard)) *
                     (size_t)stride];
}

bool aob_case_image_is_sky(const struct aob_case_image *image, size_t i)
{
    return image->depth[i] >= 0.5f * AOB_GBUFFER_SKY;
}

static void add_plane(struct aob_image *file, const char *name, const float *pixels)
{
    if (pixels)
        memcpy(aob_image_add(file, name), pixels, (size_t)file->width * (size_t)file->height * sizeof(float));
}

static void add_vectors(struct aob_image *file, const char *stem, const float (*vectors)[3])
{
    for (int c = 0; c < 3 && vectors; c++) {
        char name[64];
        snprintf(name, sizeof name, "%s.%c", stem, 'X' + c);
        aob_image_add_part(file, name, vectors[0] + c, 3);
    }
}

static void add_camera(struct aob_image *file, const struct aob_camera *camera)
{
    aob_image_set_number(file, "aobudget.fov_deg", camera->fov_deg);
    aob_image_set_number(file, "aobudget.ortho_height", camera->ortho_height);
    aob_image_set_vec3(file, "aobudget.shift", (double[3]){camera->shift[0], camera->shift[1], 0});
    aob_image_set_vec3(file, "aobudget.eye", (double[3]){camera->eye.x, camera->eye.y, camera->eye.z});
    aob_image_set_vec3(file, "aobudget.target",
                       (double[3]){camera->target.x, camera->target.y, camera->target.z});
}

/* What is known of the view without a technique. */
static void add_surface(struct aob_image *file, const struct aob_block *block,
                        const struct aob_case_image *image)
{
    static const char *const normals[3] = {"N.X", "N.Y", "N.Z"}, *const velocities[3] = {"V.X", "V.Y", "V.Z"},
                             *const albedo[3] = {"albedo.R", "albedo.G", "albedo.B"};
    static const char *const shine[2] = {"roughness", "metalness"};
    const struct aob_gbuffer *gbuffer = &block->drawing.gbuffer;
    float *z = aob_image_add(file, "Z");
    for (size_t i = 0; i < (size_t)file->width * (size_t)file->height; i++)
        z[i] = aob_case_image_is_sky(image, i) ? INFINITY : image->depth[i];
    for (int n = 0; n < 3; n++)
        aob_case_image_crop(block, gbuffer->normal + n, 4, aob_image_add(file, normals[n]));
    for (int a = 0; a < 3 && gbuffer->albedo; a++)
        aob_case_image_crop(block, gbuffer->albedo + a, 3, aob_image_add(file, albedo[a]));
    for (int s = 0; s < 2 && gbuffer->shine; s++)
        aob_case_image_crop(block, gbuffer->shine + s, 2, aob_image_add(file, shine[s]));
    for (int v = 0; v < 3 && gbuffer->velocity; v++)
        aob_case_image_crop(block, gbuffer->velocity + v, 3, aob_image_add(file, velocities[v]));
}

static void add_error(struct aob_image *file, const struct aob_case_image *image)
{
    float *error = image->truth ? aob_image_add(file, "error.AO") : NULL,
          *angle = image->open ? aob_image_add(file, "error.bent") : NULL;
    for (size_t i = 0; i < (size_t)file->width * (size_t)file->height; i++) {
        if (error)
            error[i] = aob_case_image_is_sky(image, i) ? 0 : image->ao[i] - image->truth[i];
        if (angle)
            angle[i] = aob_case_image_is_sky(image, i) || !aob_bent_counts(image->open[i])
                           ? 0
                           : (float)aob_bent_angle(image->bent[i], image->open[i]);
    }
}

float (*aob_case_image_normals(const struct aob_block *block))[3]
{
    const struct aob_gbuffer *gbuffer = &block->drawing.gbuffer;
    const struct aob_job_view *view = &block->job.drawing.view;
    float(*normals)[3] = aob_alloc((size_t)view->width * (size_t)view->height, sizeof *normals);
    size_t at = 0, stride = (size_t)gbuffer->projection.width, guard = (size_t)view->guard;
    for (size_t y = guard; y < guard + (size_t)view->height; y++)
        for (size_t x = guard; x < guard + (size_t)view->width; x++, at++)
            for (int c = 0; c < 3; c++)
                normals[at][c] = gbuffer->normal[4 * (y * stride + x) + (size_t)c];
    return normals;
}

float *aob_case_image_albedo(const struct aob_block *block)
{
    const struct aob_gbuffer *gbuffer = &block->drawing.gbuffer;
    const struct aob_job_view *view = &block->job.drawing.view;
    float *albedo = AOB_NEW_ARRAY(float, 3 * (size_t)view->width * (size_t)view->height), *into = albedo;
    size_t stride = (size_t)gbuffer->projection.width, guard = (size_t)view->guard;
    for (size_t y = guard; y < guard + (size_t)view->height; y++)
        for (size_t x = guard; x < guard + (size_t)view->width; x++)
            for (size_t c = 0; c < 3; c++) {
                size_t i = y * stride + x;
                float diffuse =
                    1 - (gbuffer->shine ? gbuffer->shine[2 * i + 1] : aob_material_default.metalness);
                *into++ = diffuse * (gbuffer->albedo ? gbuffer->albedo[3 * i + c]
                                                     : aob_material_default.base_colour[c]);
            }
    return albedo;
}

void aob_case_image_digest(const struct aob_block *block, const struct aob_case_image *image,
                           char digest[AOB_KEY_SIZE])
{
    struct aob_hash hash;
    aob_hash_begin(&hash);
    for (size_t i = 0; i < (size_t)block->job.drawing.view.width * (size_t)block->job.drawing.view.height;
         i++) {
        if (aob_case_image_is_sky(image, i))
            continue;
        aob_hash_add(&hash, &image->ao[i], sizeof image->ao[i]);
        if (image->bent)
            aob_hash_add(&hash, image->bent[i], sizeof image->bent[i]);
        for (int which = 0; which < AOB_OUTPUT_COUNT; which++) {
            const struct aob_case_effect *effect = &image->effects[which];
            size_t stride = (size_t)effect->components;
            if (effect->image)
                aob_hash_add(&hash, effect->image + i * stride, stride * sizeof *effect->image);
        }
    }
    aob_hash_end(&hash, digest);
}

bool aob_case_image_write(const struct aob_block *block, const struct aob_block_case *c,
                          const struct aob_case_image *image, struct aob_error *error)
{
    struct aob_image file = {.width = block->job.drawing.view.width,
                             .height = block->job.drawing.view.height};
    add_surface(&file, block, image);
    add_plane(&file, "technique.AO", image->ao);
    add_plane(&file, "reference.AO", image->truth);
    add_plane(&file, "reference.SE", image->se);
    add_vectors(&file, "technique.bent", (const float(*)[3])image->bent);
    add_vectors(&file, "reference.bent", (const float(*)[3])image->open);
    aob_case_effects_store(image, &file);
    add_plane(&file, "definition.AO", image->definition);
    add_plane(&file, "screen.AO", image->screen);
    add_error(&file, image);
    add_camera(&file, &block->job.drawing.view.camera);
    aob_image_set_text(&file, "aobudget.technique", c->frame.technique.technique);
    bool ok = aob_image_write(&file, c->image, error);
    aob_image_finish(&file);
    return ok;
}
