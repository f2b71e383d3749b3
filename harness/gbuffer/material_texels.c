#include "material_texels.h"
#include <math.h>
#include "base/memory.h"
#include "scene/material.h"

static size_t pixels_of(const struct aob_gbuffer *gbuffer)
{
    return (size_t)gbuffer->projection.width * (size_t)gbuffer->projection.height;
}

static bool is_sky(const struct aob_gbuffer *gbuffer, size_t i)
{
    return gbuffer->depth[i] >= 0.5f * AOB_GBUFFER_SKY;
}

static unsigned char byte_of(float share)
{
    return (unsigned char)lrintf(255 * share);
}

unsigned char *aob_material_albedo_texels(const struct aob_gbuffer *gbuffer)
{
    size_t count = pixels_of(gbuffer);
    unsigned char *texels = aob_alloc(count, 4);
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3 && !is_sky(gbuffer, i); c++)
            texels[4 * i + c] = byte_of(
                sqrtf(gbuffer->albedo ? gbuffer->albedo[3 * i + c] : aob_material_default.base_colour[c]));
    return texels;
}

unsigned char *aob_material_shine_texels(const struct aob_gbuffer *gbuffer)
{
    const float plain[2] = {aob_material_default.roughness, aob_material_default.metalness};
    size_t count = pixels_of(gbuffer);
    unsigned char *texels = aob_alloc(count, 2);
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 2 && !is_sky(gbuffer, i); c++)
            texels[2 * i + c] = byte_of(gbuffer->shine ? gbuffer->shine[2 * i + c] : plain[c]);
    return texels;
}
