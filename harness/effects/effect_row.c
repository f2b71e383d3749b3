#include "effect_row.h"
#include <string.h>

const struct aob_effect_row aob_effect_rows[AOB_EFFECT_COUNT] = {
    {.name = "visibility", .is = "what stands in the light's way within the radius"},
    {.name = "multi_bounce",
     .is = "light that goes from surface to surface",
     .option = "visibility_rgb",
     .passes = {"bounces"}},
    {.name = "bent_normal",
     .is = "the light looked up along the mean open direction",
     .option = "bent_normal"},
    {.name = "directional",
     .is = "the light with what is closed taken out of it by direction",
     .option = "irradiance",
     .passes = {"irradiance"}},
    {.name = "specular",
     .is = "the open share of what a polished surface mirrors",
     .option = "specular",
     .passes = {"specular"}},
    {.name = "temporal",
     .is = "the mean over the frames before",
     .param = {"history", "0", "16"},
     .passes = {"changes", "change_groups", "changed", "change_spread", "temporal"}},
    {.name = "half_size",
     .is = "occlusion at half the image's width and height, sampled up",
     .param = {"divisor", "1", "2"}},
};

static bool is_named(const char *own, const char *name)
{
    return own && strcmp(own, name) == 0;
}

bool aob_effect_is_choice(const char *name)
{
    bool is = strcmp(name, "lit") == 0;
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        is = is || is_named(aob_effect_rows[id].option, name) ||
             is_named(aob_effect_rows[id].param.name, name);
    return is;
}

bool aob_effect_has(unsigned set, enum aob_effect_id id)
{
    return set & AOB_EFFECT_BIT(id);
}

bool aob_effect_set_bends(unsigned set)
{
    return set & (AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL) | AOB_EFFECT_BIT(AOB_EFFECT_DIRECTIONAL) |
                  AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR));
}

size_t aob_effect_image_of(unsigned set)
{
    return aob_effect_has(set, AOB_EFFECT_HALF_SIZE) + 2u * aob_effect_has(set, AOB_EFFECT_TEMPORAL);
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
