#include "figure_parts.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>

/* A part is one of these less the one before it. */
static const char *const stages[AOB_PARTS + 1] = {"reference.AO", "definition.AO", "screen.AO",
                                                  "technique.AO"};

bool aob_parts_exist(const struct aob_image *image)
{
    return aob_image_channel(image, stages[1]) && aob_image_channel(image, stages[2]);
}

bool aob_parts_init(struct aob_parts *parts, const struct aob_image *image, struct aob_error *error)
{
    const float *stage[AOB_PARTS + 1], *z = aob_image_channel(image, "Z");
    size_t count = (size_t)image->width * (size_t)image->height;
    *parts = (struct aob_parts){0};
    for (int k = 0; k <= AOB_PARTS; k++) {
        stage[k] = aob_image_channel(image, stages[k]);
        if (!stage[k])
            return aob_fail(error, "has no channel %s", stages[k]);
    }
    for (int k = 0; k < AOB_PARTS; k++) {
        parts->maps[k] = AOB_NEW_ARRAY(float, count);
        for (size_t i = 0; i < count; i++)
            parts->maps[k][i] = z && isinf(z[i]) ? 0 : stage[k + 1][i] - stage[k][i];
    }
    return true;
}

void aob_parts_finish(struct aob_parts *parts)
{
    for (int k = 0; k < AOB_PARTS; k++)
        free(parts->maps[k]);
    *parts = (struct aob_parts){0};
}
