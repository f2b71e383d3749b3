#include "encoding.h"
#include "gbuffer/texts.h"
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/half.h"
#include "base/memory.h"
#include "gpu/gpu.h"

static bool is_device(enum aob_depth_encoding depth)
{
    return depth >= AOB_DEPTH_DEVICE24;
}

static bool is_infinite(enum aob_depth_encoding depth)
{
    return depth == AOB_DEPTH_DEVICE24_INFINITE || depth == AOB_DEPTH_DEVICE32_INFINITE;
}

static bool is_forward(enum aob_depth_encoding depth)
{
    return depth == AOB_DEPTH_DEVICE24 || depth == AOB_DEPTH_DEVICE32;
}

static size_t pixel_count(const struct aob_gbuffer *gbuffer)
{
    return (size_t)gbuffer->projection.width * (size_t)gbuffer->projection.height;
}

static bool is_sky(float depth)
{
    return depth >= 0.5f * AOB_GBUFFER_SKY;
}

static void find_range(const struct aob_gbuffer *gbuffer, float *nearest, float *farthest)
{
    *nearest = INFINITY;
    *farthest = 0;
    for (size_t i = 0; i < pixel_count(gbuffer); i++)
        if (!is_sky(gbuffer->depth[i])) {
            *nearest = fminf(*nearest, gbuffer->depth[i]);
            *farthest = fmaxf(*farthest, gbuffer->depth[i]);
        }
    if (!(*farthest > 0)) /* nothing but sky: any range will do */
        *nearest = *farthest = 1;
}

bool aob_encoding_init(struct aob_encoding *encoding, const struct aob_options *options,
                       const struct aob_gbuffer *gbuffer, struct aob_error *error)
{
    float nearest, farthest;
    find_range(gbuffer, &nearest, &farthest);
    *encoding = (struct aob_encoding){.depth = (enum aob_depth_encoding)options->depth_encoding,
                                      .normal = (enum aob_normal_encoding)options->normal_encoding,
                                      .normals = (enum aob_normals)options->normals,
                                      .near = options->near > 0 ? options->near : 0.5f * nearest,
                                      .far = options->far > 0 ? options->far : 1.01f * farthest,
                                      .perspective = gbuffer->projection.perspective};
    if (is_infinite(encoding->depth) && !encoding->perspective)
        return aob_fail(error, "depth_encoding: an infinite far plane needs a perspective view");
    if (is_device(encoding->depth) && !is_infinite(encoding->depth) && !(encoding->near < encoding->far))
        return aob_fail(error, "depth_encoding: near %g is not below far %g", (double)encoding->near,
                        (double)encoding->far);
    return true;
}

enum aob_format aob_encoding_depth_format(const struct aob_encoding *encoding)
{
    switch (encoding->depth) {
    case AOB_DEPTH_R16F:
        return AOB_R16F;
    case AOB_DEPTH_UNORM16:
        return AOB_R16;
    case AOB_DEPTH_PACKED16:
        return AOB_RGBA8;
    default:
        return AOB_R32F;
    }
}

enum aob_format aob_encoding_normal_format(const struct aob_encoding *encoding)
{
    static const enum aob_format formats[] = {
        [AOB_NORMAL_RGBA32F] = AOB_RGBA32F, [AOB_NORMAL_OCT_RG16F] = AOB_RG16F,
        [AOB_NORMAL_RGBA8] = AOB_RGBA8,     [AOB_NORMAL_PACKED8] = AOB_RGBA8,
        [AOB_NORMAL_RGBA16F] = AOB_RGBA16F, [AOB_NORMAL_OCT_RG8] = AOB_RG8,
        [AOB_NORMAL_RGB10] = AOB_RGBA8,     [AOB_NORMAL_SPHERE_RG16F] = AOB_RG16F};
    return formats[encoding->normal];
}

bool aob_encoding_is_shared(const struct aob_encoding *encoding)
{
    return encoding->depth == AOB_DEPTH_PACKED16 && encoding->normal == AOB_NORMAL_PACKED8 &&
           encoding->normals != AOB_NORMALS_FROM_DEPTH;
}

/* What is no number is `low`, as a device makes it 0. */
static double clamp(double x, double low, double high)
{
    return !(x >= low) ? low : x > high ? high : x;
}

/* The last value is the sky's. */
static uint16_t unorm16(const struct aob_encoding *encoding, float depth)
{
    double scaled = (double)depth / (double)encoding->far * 65535;
    return is_sky(depth) ? 65535 : (uint16_t)(clamp(scaled, 0, 65534) + 0.5);
}

/* Device depth of a surface in double precision, 0..1. */
static double device_depth(const struct aob_encoding *encoding, double z)
{
    double n = (double)encoding->near, f = (double)encoding->far, forward;
    if (is_infinite(encoding->depth))
        return n / fmax(z, n);
    z = clamp(z, n, f);
    forward = encoding->perspective ? f / (f - n) * (1 - n / z) : (z - n) / (f - n);
    return is_forward(encoding->depth) ? forward : 1 - forward;
}

/* 24 bits are held in the float that a shader would read them as. The value that clears the buffer is the sky's. */
static float device(const struct aob_encoding *encoding, float depth)
{
    const double steps = (1 << 24) - 1;
    bool forward = is_forward(encoding->depth);
    if (is_sky(depth))
        return forward ? 1 : 0;
    double d = device_depth(encoding, (double)depth);
    if (encoding->depth >= AOB_DEPTH_DEVICE32)
        return forward ? fminf((float)d, nextafterf(1, 0)) : fmaxf((float)d, FLT_TRUE_MIN);
    double k = floor(d * steps + 0.5);
    return (float)(clamp(k, forward ? 0 : 1, forward ? steps - 1 : steps) / steps);
}

static unsigned char unorm8(float x)
{
    return (unsigned char)(clamp((double)x * 0.5 + 0.5, 0, 1) * 255 + 0.5);
}

static const float *normals_of(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer)
{
    return encoding->normals == AOB_NORMALS_SHADING ? gbuffer->shading : gbuffer->normal;
}

static void *packed_texels(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer)
{
    const float *normal = normals_of(encoding, gbuffer);
    unsigned char *texels = aob_alloc(pixel_count(gbuffer), 4);
    for (size_t i = 0; i < pixel_count(gbuffer); i++) {
        uint16_t depth = unorm16(encoding, gbuffer->depth[i]);
        texels[4 * i] = unorm8(normal[4 * i]);
        texels[4 * i + 1] = unorm8(normal[4 * i + 1]);
        texels[4 * i + 2] = (unsigned char)(depth >> 8);
        texels[4 * i + 3] = (unsigned char)(depth & 255);
    }
    return texels;
}

void *aob_encoding_depth_texels(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer)
{
    size_t count = pixel_count(gbuffer);
    if (encoding->depth == AOB_DEPTH_PACKED16)
        return packed_texels(encoding, gbuffer);
    float *whole = AOB_NEW_ARRAY(float, count);
    uint16_t *half = (uint16_t *)(void *)whole;
    for (size_t i = 0; i < count; i++) {
        float depth = gbuffer->depth[i];
        if (encoding->depth == AOB_DEPTH_R32F)
            whole[i] = depth;
        else if (encoding->depth == AOB_DEPTH_R16F)
            half[i] = aob_half_from_float(is_sky(depth) ? INFINITY : fminf(depth, AOB_HALF_MAX));
        else if (encoding->depth == AOB_DEPTH_UNORM16)
            half[i] = unorm16(encoding, depth);
        else
            whole[i] = device(encoding, depth);
    }
    return whole;
}

/* Meyer, Suessmuth, Sussner, Stamminger, Greiner: On Floating-Point Normal Vectors, EGSR 2010. */
static void octahedral(const float n[3], float into[2])
{
    float sum = fabsf(n[0]) + fabsf(n[1]) + fabsf(n[2]);
    float x = sum > 0 ? n[0] / sum : 0, y = sum > 0 ? n[1] / sum : 0;
    into[0] = n[2] >= 0 ? x : copysignf(1 - fabsf(y), x);
    into[1] = n[2] >= 0 ? y : copysignf(1 - fabsf(x), y);
}

/* Lambert's azimuthal equal-area map about +Z, onto the unit disc: the distance from its middle is the sine of half the
 * angle to +Z. Mittring: A bit more Deferred - CryEngine 3, 2009. All of the rim is -Z; that takes (1, 0). */
static void equal_area(const float n[3], float into[2])
{
    double x = (double)n[0], y = (double)n[1], z = (double)n[2];
    double across = hypot(x, y), length = hypot(across, z);
    double middle = length > 0 ? sqrt((length - z) / (2 * length)) : 0;
    into[0] = (float)(across > 0 ? x / across * middle : middle);
    into[1] = (float)(across > 0 ? y / across * middle : 0);
}

/* Ten bits in the lower byte of x, y, z, and two in w for each. */
static void ten_bits(const float n[3], unsigned char into[4])
{
    into[3] = 0;
    for (int c = 0; c < 3; c++) {
        unsigned k = (unsigned)(clamp((double)n[c] * 0.5 + 0.5, 0, 1) * 1023 + 0.5);
        into[c] = (unsigned char)(k & 255);
        into[3] = (unsigned char)(into[3] | k >> 8 << 2 * c);
    }
}

static void half_floats(const float *from, size_t count, uint16_t *into)
{
    for (size_t c = 0; c < count; c++)
        into[c] = aob_half_from_float(from[c]);
}

static void unorm_bytes(const float *from, size_t count, unsigned char *into)
{
    for (size_t c = 0; c < count; c++)
        into[c] = unorm8(from[c]);
}

static void write_normal(enum aob_normal_encoding encoding, const float n[4], void *texel)
{
    float map[2];
    switch (encoding) {
    case AOB_NORMAL_OCT_RG16F:
        octahedral(n, map);
        half_floats(map, 2, texel);
        return;
    case AOB_NORMAL_OCT_RG8:
        octahedral(n, map);
        unorm_bytes(map, 2, texel);
        return;
    case AOB_NORMAL_SPHERE_RG16F:
        equal_area(n, map);
        half_floats(map, 2, texel);
        return;
    case AOB_NORMAL_RGBA8:
        unorm_bytes(n, 4, texel);
        return;
    case AOB_NORMAL_RGBA16F:
        half_floats(n, 4, texel);
        return;
    case AOB_NORMAL_RGB10:
        ten_bits(n, texel);
        return;
    default:
        memcpy(texel, n, 4 * sizeof *n);
    }
}

void *aob_encoding_normal_texels(const struct aob_encoding *encoding, const struct aob_gbuffer *gbuffer)
{
    size_t count = pixel_count(gbuffer), size = aob_gpu_texel_size(aob_encoding_normal_format(encoding));
    if (encoding->normals == AOB_NORMALS_FROM_DEPTH)
        return NULL;
    if (encoding->normal == AOB_NORMAL_PACKED8)
        return packed_texels(encoding, gbuffer);
    const float *normal = normals_of(encoding, gbuffer);
    unsigned char *texels = aob_alloc(count, size);
    for (size_t i = 0; i < count; i++)
        write_normal(encoding->normal, &normal[4 * i], texels + i * size);
    return texels;
}

void aob_encoding_write_depth(const struct aob_encoding *encoding, struct aob_text *text)
{
    aob_text_add(text, "#define AOB_DEPTH_ENCODING %d\n%s", (int)encoding->depth,
                 aob_text_gbuffer_decode_depth);
}

void aob_encoding_write_normal(const struct aob_encoding *encoding, struct aob_text *text)
{
    aob_text_add(text, "#define AOB_NORMAL_ENCODING %d\n%s", (int)encoding->normal,
                 aob_text_gbuffer_decode_normal);
}
