#include "screen.h"
#include <stdlib.h>
#include "gbuffer/material_texels.h"
#include "prelude.h"
#include "velocity_texels.h"

/* Makes the texture of these texels, or writes it again, and frees them. */
static bool put(struct aob_screen *screen, enum aob_format format, void *texels,
                struct aob_gpu_texture **texture, struct aob_error *error)
{
    const struct aob_projection *view = &screen->gbuffer->projection;
    const struct aob_gpu_texture_desc desc = {.format = format,
                                              .width = view->width,
                                              .height = view->height,
                                              .uses = screen->uses,
                                              .texels = texels};
    bool ok = true;
    if (*texture)
        ok = aob_gpu_texture_write(screen->gpu, *texture, texels, error);
    else {
        screen->unfit = !aob_gpu_texture_fits(screen->gpu, &desc, error);
        *texture = aob_gpu_texture_create(screen->gpu, &desc, error);
        ok = *texture;
    }
    free(texels);
    return ok;
}

static bool put_surfaces(struct aob_screen *screen, struct aob_error *error)
{
    const struct aob_encoding *encoding = &screen->encoding;
    bool shared = aob_encoding_is_shared(encoding);
    if (!put(screen, aob_encoding_depth_format(encoding),
             aob_encoding_depth_texels(encoding, screen->gbuffer), &screen->depth, error))
        return false;
    if (shared)
        screen->normal = screen->depth;
    return shared || encoding->normals == AOB_NORMALS_FROM_DEPTH ||
           put(screen, aob_encoding_normal_format(encoding),
               aob_encoding_normal_texels(encoding, screen->gbuffer), &screen->normal, error);
}

static bool put_materials(struct aob_screen *screen, struct aob_error *error)
{
    return (put(screen, AOB_RGBA8, aob_material_albedo_texels(screen->gbuffer), &screen->albedo, error) &&
            put(screen, AOB_RG8, aob_material_shine_texels(screen->gbuffer), &screen->shine, error)) ||
           aob_fail_in(error, "materials");
}

static bool put_velocity(struct aob_screen *screen, struct aob_error *error)
{
    return put(screen, AOB_RGBA16F, aob_velocity_texels(screen->gbuffer), &screen->velocity, error) ||
           aob_fail_in(error, "velocity");
}

bool aob_screen_init(struct aob_screen *screen, struct aob_gpu *gpu, const struct aob_gbuffer *gbuffer,
                     const struct aob_options *options, struct aob_error *error)
{
    bool storage = aob_prelude_is_storage((enum aob_fetch)options->fetch, AOB_NEAREST, 1);
    *screen = (struct aob_screen){.gpu = gpu,
                                  .gbuffer = gbuffer,
                                  .options = *options,
                                  .light = aob_light_uniform,
                                  .then = aob_affine_identity(),
                                  .uses = storage ? AOB_GPU_USE_STORAGE : AOB_GPU_USE_SAMPLED};
    if (!aob_encoding_init(&screen->encoding, options, gbuffer, error))
        return false;
    if (put_surfaces(screen, error))
        return true;
    const bool unfit = screen->unfit;
    aob_screen_finish(screen);
    screen->unfit = unfit;
    return false;
}

bool aob_screen_provide(struct aob_screen *screen, uint32_t reads, struct aob_error *error)
{
    if (reads & AOB_MATERIAL && !(screen->albedo && screen->shine) && !put_materials(screen, error))
        return false;
    return !(reads & AOB_VELOCITY) || screen->velocity || put_velocity(screen, error);
}

bool aob_screen_show(struct aob_screen *screen, const struct aob_screen_pose *pose, struct aob_error *error)
{
    screen->gbuffer = pose->gbuffer;
    screen->light = *pose->light;
    screen->then = pose->then;
    return aob_encoding_init(&screen->encoding, &screen->options, pose->gbuffer, error) &&
           put_surfaces(screen, error) && (!screen->albedo || put_materials(screen, error)) &&
           (!screen->velocity || put_velocity(screen, error));
}

void aob_screen_finish(struct aob_screen *screen)
{
    if (screen->gpu) {
        if (screen->normal != screen->depth)
            aob_gpu_texture_destroy(screen->gpu, screen->normal);
        aob_gpu_texture_destroy(screen->gpu, screen->depth);
        aob_gpu_texture_destroy(screen->gpu, screen->albedo);
        aob_gpu_texture_destroy(screen->gpu, screen->shine);
        aob_gpu_texture_destroy(screen->gpu, screen->velocity);
    }
    *screen = (struct aob_screen){0};
}
