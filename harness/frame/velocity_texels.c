#include "velocity_texels.h"
#include <math.h>
#include "base/half.h"
#include "base/memory.h"

static bool holds(float value)
{
    return fabsf(value) <= AOB_HALF_MAX;
}

static void store(const float velocity[3], float depth, uint16_t texel[4])
{
    bool was = velocity[2] > 0 && velocity[2] < 0.5f * AOB_GBUFFER_SKY;
    float deeper = was ? velocity[2] - depth : 0;
    if (!was || !holds(velocity[0]) || !holds(velocity[1]) || !holds(deeper))
        return;
    texel[0] = aob_half_from_float(velocity[0]);
    texel[1] = aob_half_from_float(velocity[1]);
    texel[2] = aob_half_from_float(deeper);
    texel[3] = aob_half_from_float(1);
}

void *aob_velocity_texels(const struct aob_gbuffer *gbuffer)
{
    size_t count = (size_t)gbuffer->projection.width * (size_t)gbuffer->projection.height;
    uint16_t(*texels)[4] = aob_alloc(count, sizeof *texels);
    for (size_t i = 0; i < count; i++) {
        bool sky = gbuffer->depth[i] >= 0.5f * AOB_GBUFFER_SKY;
        const float still[3] = {0, 0, sky ? AOB_GBUFFER_SKY : gbuffer->depth[i]};
        store(gbuffer->velocity ? &gbuffer->velocity[3 * i] : still, gbuffer->depth[i], texels[i]);
    }
    return texels;
}
