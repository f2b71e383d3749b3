#include "material.h"
#include <string.h>

const struct aob_material aob_material_default = {.base_colour = {0.8f, 0.8f, 0.8f}, .roughness = 1};

bool aob_material_equal(const struct aob_material *a, const struct aob_material *b)
{
    return memcmp(a, b, sizeof *a) == 0;
}

static bool is_share(float value)
{
    return value >= 0 && value <= 1;
}

bool aob_material_valid(const struct aob_material *material)
{
    for (int c = 0; c < 3; c++)
        if (!is_share(material->base_colour[c]))
            return false;
    return is_share(material->roughness) && is_share(material->metalness);
}
