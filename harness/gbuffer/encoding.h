/* Encodings of the G-buffer are what a renderer's depth and normal textures hold. They are made from the canonical
 * floats when these are uploaded, and the prelude undoes them in every read. Values are rounded to the nearest, as a
 * device's own stores round; so no software driver has to be trusted with it. */
#ifndef AOB_GBUFFER_ENCODING_H
#define AOB_GBUFFER_ENCODING_H
#include "base/error.h"
#include "base/text.h"
#include "gbuffer.h"
#include "technique/option.h"

struct aob_encoding {
    enum aob_depth_encoding depth;
    enum aob_normal_encoding normal;
    enum aob_normals normals;
    float near, far;  /* resolved; scene units */
    bool perspective; /* of the view */
};

/* Takes the encoding from the run options, and near and far from the view where they are 0. False after one line if
 * an orthographic view has an infinite far plane, or if near >= far. A surface beyond far (or before near) is held as
 * one at that plane. */
bool aob_encoding_init(struct aob_encoding *encoding, const struct aob_options *options,
                       const struct aob_gbuffer *gbuffer, struct aob_error *error);

enum aob_format aob_encoding_depth_format(const struct aob_encoding *encoding);
enum aob_format aob_encoding_normal_format(const struct aob_encoding *encoding);

/* Each returns texels of the whole G-buffer in that format; the caller frees them. If both are packed, one texture
 * serves both (aob_encoding_is_shared). With normals from_depth there is no normal texture, and NULL comes back. */
void *aob_encoding_depth_texels(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer);
void *aob_encoding_normal_texels(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer);
bool aob_encoding_is_shared(const struct aob_encoding *encoding);

/* They write GLSL: float aob_decode_depth(T texel), which gives AOB_SKY_Z for the sky, and vec3 aob_decode_normal(T
 * texel). T is float, vec2 or vec4 as the format has components. Both functions read near and far from
 * param.aob_range.xy. */
void aob_encoding_write_depth(const struct aob_encoding *encoding, struct aob_text *text);
void aob_encoding_write_normal(const struct aob_encoding *encoding, struct aob_text *text);
#endif
