/* Encodings of the G-buffer: what a renderer's depth and normal textures hold, made from the canonical floats
 * when they are uploaded, and undone by the prelude in every read. Rounding is to the nearest, as a device's own
 * stores do; software drivers do not have to be trusted with it. */
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

/* From the run options, near and far from the view where they are 0. False and one line: an infinite far plane of an
 * orthographic view, near >= far. A surface beyond far (or before near) is held as one at that plane. */
bool aob_encoding_init(struct aob_encoding *encoding, const struct aob_options *options,
                       const struct aob_gbuffer *gbuffer, struct aob_error *error);

enum aob_format aob_encoding_depth_format(const struct aob_encoding *encoding);
enum aob_format aob_encoding_normal_format(const struct aob_encoding *encoding);

/* Texels of the whole G-buffer in those formats; the caller frees them. One texture serves both where both are
 * packed: aob_encoding_is_shared. With normals from_depth there is no normal texture, and NULL comes back. */
void *aob_encoding_depth_texels(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer);
void *aob_encoding_normal_texels(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer);
bool aob_encoding_is_shared(const struct aob_encoding *encoding);

/* GLSL: float aob_decode_depth(T texel), which gives AOB_SKY_Z for the sky, and vec3 aob_decode_normal(T texel); T is
 * float, vec2 or vec4 as the format has components. They read near and far from param.aob_range.xy. */
void aob_encoding_write_depth(const struct aob_encoding *encoding, struct aob_text *text);
void aob_encoding_write_normal(const struct aob_encoding *encoding, struct aob_text *text);
#endif
