#include "capture_words.h"
#include "config/convention.h"

static const char *materials_of(unsigned materials)
{
    bool colour = materials & AOB_MATERIAL_BIT(AOB_MATERIAL_ALBEDO),
         rough = materials & AOB_MATERIAL_BIT(AOB_MATERIAL_ROUGHNESS);
    if (colour && rough)
        return "in its own materials";
    if (colour)
        return "in its base colour and matt, since it has no roughness";
    return rough ? "in its roughness and one base colour" : "in one white material";
}

void aob_effect_against(const struct aob_effect_answer *answer, int spp, struct aob_text *text)
{
    if (!answer->no_truth) {
        aob_text_add(text, "against %d rays a pixel", spp);
        return;
    }
    aob_text_add(text, "%s, against its own of full size with ", materials_of(answer->materials));
    aob_effect_set_print(answer->reference, text);
    aob_text_add(text, ", which no truth has judged");
}

void aob_effect_explain_lack(enum aob_effect_id id, struct aob_text *text)
{
    if (id == AOB_EFFECT_SPECULAR)
        aob_text_add(text,
                     "not known: the file has no roughness, and how wide a surface mirrors depends on it");
    else
        aob_text_add(text,
                     "not known: the file has no base colour (albedo.R .G .B), and bounces depend on it");
}
