/* Which channels of a capture are base colour, roughness and metalness, by their names, as capture_channel.h compares them.
 *
 * Base colour: ALBEDO.R .G .B, where ALBEDO is one of albedo, basecolor, basecolour, diffcol (Blender), diffusecolor,
 *   diffusecolour and diffusefilter (V-Ray), else ends with one of these. A plain `diffuse` is none: most renderers call so what
 *   is lit.
 * Roughness, metalness: a channel whose last part is the word (the harness's own images), else WORD.V, .R, .Y or .X. WORD is
 *   roughness, or metalness or metallic, else ends with one of these.
 *
 * A name is none of them if the part with the word holds "denois", or the name of another lobe: "spec", "coat", "sheen", "transmi",
 * "refract", "sss" or "subsurface".
 *
 * Of several the ones of the depth's layer go first, of these the exact word, and of these the first of the file. */
#ifndef AOB_GBUFFER_CAPTURE_MATERIAL_CHANNEL_H
#define AOB_GBUFFER_CAPTURE_MATERIAL_CHANNEL_H
#include "capture_channel.h"

struct aob_capture_material_channel {
    int at
        [3]; /* indexes among the names: R G B of the base colour, else the first alone; AOB_CHANNEL_NONE: there is none */
    int other;  /* another of the same layer that would do as well; else AOB_CHANNEL_NONE */
    bool mixed; /* it is of another layer than the depth, and the convention does not name it */
};
struct aob_capture_material_channels {
    struct aob_capture_material_channel of[AOB_MATERIAL_CHANNELS];
};

/* `layer`: the depth's. False after one line if the convention names channels that are not there, or if a base colour lacks one of its three. */
bool aob_capture_materials_choose(struct aob_capture_material_channels *channels, const char *const *names,
                                  size_t count, const char *layer, const struct aob_convention *convention,
                                  struct aob_error *error);
#endif
