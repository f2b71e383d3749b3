#include "effect_row.h"

const struct aob_effect_row aob_effect_rows[AOB_EFFECT_COUNT] = {
    {"visibility", NULL, NULL, "what stands in the light's way within the radius"},
    {"multi_bounce", "visibility_rgb", "bounces", "light that goes from surface to surface"},
    {"bent_normal", "bent_normal", NULL, "the light looked up along the mean open direction"},
    {"directional", "irradiance", "irradiance", "the light with what is closed taken out of it by direction"},
    {"specular", "specular", "specular", "the open share of what a polished surface mirrors"},
    {"half_size", NULL, NULL, "occlusion at half the image's width and height, sampled up"},
};

bool aob_effect_has(unsigned set, enum aob_effect_id id)
{
    return set & AOB_EFFECT_BIT(id);
}

bool aob_effect_set_bends(unsigned set)
{
    return set & (AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL) | AOB_EFFECT_BIT(AOB_EFFECT_DIRECTIONAL) |
                  AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR));
}

static bool is_sound(unsigned set)
{
    return !set ||
           (aob_effect_has(set, AOB_EFFECT_VISIBILITY) &&
            !(aob_effect_has(set, AOB_EFFECT_BENT_NORMAL) && aob_effect_has(set, AOB_EFFECT_DIRECTIONAL)));
}

size_t aob_effect_sets(unsigned open, unsigned sets[AOB_EFFECT_SETS])
{
    size_t count = 0;
    for (unsigned set = 0; set <= AOB_EFFECT_ALL; set++)
        if (!(set & ~open) && is_sound(set))
            sets[count++] = set;
    return count;
}

void aob_effect_set_print(unsigned set, struct aob_text *text)
{
    const char *between = "";
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        if (aob_effect_has(set, (enum aob_effect_id)id)) {
            aob_text_add(text, "%s%s", between, aob_effect_rows[id].name);
            between = " + ";
        }
    if (!set)
        aob_text_add(text, "nothing");
}
