/* Materials as a renderer's G-buffer holds them: base colour in 8 bits a channel, as its square root, because the eye and
 * the light between surfaces tell dark colours apart by ratios; roughness and metalness in 8 bits each. Where the G-buffer
 * has no materials, all is aob_material_default. Sky is 0. */
#ifndef AOB_GBUFFER_MATERIAL_TEXELS_H
#define AOB_GBUFFER_MATERIAL_TEXELS_H
#include "gbuffer.h"

/* Each returns a texel for each pixel of the whole G-buffer; the caller frees them. */
unsigned char *aob_material_albedo_texels(const struct aob_gbuffer *gbuffer); /* AOB_RGBA8; a is 0 */
unsigned char *aob_material_shine_texels(const struct aob_gbuffer *gbuffer);  /* AOB_RG8 */
#endif
