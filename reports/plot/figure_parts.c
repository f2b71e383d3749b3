#include "figure_parts.h"
#include "base/memory.h"
#include <math.h>
#include <stdlib.h>

bool aob_parts_exist(const struct aob_image *image)
{
    return aob_image_channel(image, "definition.AO") && aob_image_channel(image, "screen.AO");
}

/* A part is one of these less the one before it. */
static bool find_stages(const struct aob_figure_image *from, const float *stages[AOB_PARTS + 1],
                        struct aob_error *error)
{
    static const char *const names[] = {"reference.AO", "definition.AO", "screen.AO", "technique.AO"};
    stages[0] = from->reference;
    stages[1] = aob_image_channel(from->image, names[1]);
    stages[2] = aob_image_channel(from->image, names[2]);
    stages[3] = from->technique;
    for (size_t k = 0; k < AOB_COUNT(names); k++)
        if (!stages[k])
            return aob_fail(error, "has no channel %s", names[k]);
    return true;
}

bool aob_parts_init(struct aob_parts *parts, const struct aob_figure_image *from, struct aob_error *error)
{
    const float *stages[AOB_PARTS + 1], *z = aob_image_channel(from->image, "Z");
    size_t count = (size_t)from->image->width * (size_t)from->image->height;
    *parts = (struct aob_parts){0};
    if (!find_stages(from, stages, error))
        return false;
    for (int k = 0; k < AOB_PARTS; k++) {
        parts->maps[k] = AOB_NEW_ARRAY(float, count);
        for (size_t i = 0; i < count; i++)
            parts->maps[k][i] = z && isinf(z[i]) ? 0 : stages[k + 1][i] - stages[k][i];
    }
    return true;
}

void aob_parts_finish(struct aob_parts *parts)
{
    for (int k = 0; k < AOB_PARTS; k++)
        free(parts->maps[k]);
    *parts = (struct aob_parts){0};
}
