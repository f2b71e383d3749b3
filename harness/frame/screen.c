#include "screen.h"
#include <stdlib.h>
#include "gbuffer/material_texels.h"
#include "prelude.h"

static struct aob_gpu_texture *upload(struct aob_screen *screen, enum aob_format format, void *texels,
                                      struct aob_error *error)
{
    const struct aob_projection *view = &screen->gbuffer->projection;
    const struct aob_gpu_texture_desc desc = {.format = format,
                                              .width = view->width,
                                              .height = view->height,
                                              .uses = screen->uses,
                                              .texels = texels};
    screen->unfit = !aob_gpu_texture_fits(screen->gpu, &desc, error);
    struct aob_gpu_texture *texture = aob_gpu_texture_create(screen->gpu, &desc, error);
    free(texels);
    return texture;
}

bool aob_screen_init(struct aob_screen *screen, struct aob_gpu *gpu, const struct aob_gbuffer *gbuffer,
                     const struct aob_options *options, struct aob_error *error)
{
    bool storage = aob_prelude_is_storage((enum aob_fetch)options->fetch, AOB_NEAREST, 1);
    *screen = (struct aob_screen){.gpu = gpu,
                                  .gbuffer = gbuffer,
                                  .light = aob_light_uniform,
                                  .uses = storage ? AOB_GPU_USE_STORAGE : AOB_GPU_USE_SAMPLED};
    struct aob_encoding *encoding = &screen->encoding;
    if (!aob_encoding_init(encoding, options, gbuffer, error))
        return false;
    screen->depth = upload(screen, aob_encoding_depth_format(encoding),
                           aob_encoding_depth_texels(encoding, gbuffer), error);
    if (aob_encoding_is_shared(encoding))
        screen->normal = screen->depth;
    else if (screen->depth && encoding->normals != AOB_NORMALS_FROM_DEPTH)
        screen->normal = upload(screen, aob_encoding_normal_format(encoding),
                                aob_encoding_normal_texels(encoding, gbuffer), error);
    if (screen->depth && (screen->normal || encoding->normals == AOB_NORMALS_FROM_DEPTH))
        return true;
    const bool unfit = screen->unfit;
    aob_screen_finish(screen);
    screen->unfit = unfit;
    return false;
}

bool aob_screen_provide(struct aob_screen *screen, uint32_t reads, struct aob_error *error)
{
    if (!(reads & AOB_MATERIAL) || (screen->albedo && screen->shine))
        return true;
    if (!screen->albedo)
        screen->albedo = upload(screen, AOB_RGBA8, aob_material_albedo_texels(screen->gbuffer), error);
    if (screen->albedo)
        screen->shine = upload(screen, AOB_RG8, aob_material_shine_texels(screen->gbuffer), error);
    return screen->shine || aob_fail_in(error, "materials");
}

void aob_screen_finish(struct aob_screen *screen)
{
    if (screen->gpu) {
        if (screen->normal != screen->depth)
            aob_gpu_texture_destroy(screen->gpu, screen->normal);
        aob_gpu_texture_destroy(screen->gpu, screen->depth);
        aob_gpu_texture_destroy(screen->gpu, screen->albedo);
        aob_gpu_texture_destroy(screen->gpu, screen->shine);
    }
    *screen = (struct aob_screen){0};
}
