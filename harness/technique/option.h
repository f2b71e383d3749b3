/* Run options: the same for every technique, written like parameters (`-p fetch=storage`, `options:`). */
#ifndef AOB_TECHNIQUE_OPTION_H
#define AOB_TECHNIQUE_OPTION_H
#include <aobudget/technique.h>

enum aob_fetch { AOB_FETCH_SAMPLED, AOB_FETCH_STORAGE };
enum aob_gbuffer_source { AOB_GBUFFER_CANONICAL, AOB_GBUFFER_RASTER };

/* How a texel of the depth holds the distance z along the view axis; n, f are the options near and far. */
enum aob_depth_encoding {
    AOB_DEPTH_R32F,
    AOB_DEPTH_R16F,
    AOB_DEPTH_UNORM16,           /* z / f in 16 bits */
    AOB_DEPTH_PACKED16,          /* the same in two of four 8-bit channels, beside a packed8 normal */
    AOB_DEPTH_DEVICE24,          /* (f / (f-n)) (1 - n/z) in 24 bits; orthographic (z-n) / (f-n) */
    AOB_DEPTH_DEVICE24_REVERSED, /* 1 - that */
    AOB_DEPTH_DEVICE24_INFINITE, /* n/z: reversed, the far plane at infinity; perspective only */
    AOB_DEPTH_DEVICE32,          /* the three as 32-bit floats */
    AOB_DEPTH_DEVICE32_REVERSED,
    AOB_DEPTH_DEVICE32_INFINITE,
};
enum aob_normal_encoding {
    AOB_NORMAL_RGBA32F,
    AOB_NORMAL_OCT_RG16F, /* octahedral map (Meyer et al. 2010), half floats */
    AOB_NORMAL_RGBA8,     /* n/2 + 1/2 in 8 bits each, normalised when read */
    AOB_NORMAL_PACKED8, /* x and y so, z >= 0 from them: StarCraft II's; normals that face away from +Z are lost */
    AOB_NORMAL_RGBA16F, /* half floats, normalised when read */
    AOB_NORMAL_OCT_RG8, /* the octahedral map in 8 bits each */
    AOB_NORMAL_RGB10,   /* n/2 + 1/2 in 10 bits each, in four bytes as RGB10A2 is; normalised when read */
    AOB_NORMAL_SPHERE_RG16F, /* equal-area map about +Z (CryEngine 3, Mittring 2009), half floats; -Z is its rim */
};
enum aob_normals {
    AOB_NORMALS_GEOMETRIC,
    AOB_NORMALS_SHADING,
    AOB_NORMALS_FROM_DEPTH, /* cross product of the smaller depth differences; no texture is read */
};

struct aob_options {
    int32_t guard_band; /* pixels rendered around the view and cropped before scoring */
    int32_t fetch;      /* enum aob_fetch */
    int32_t gbuffer;    /* enum aob_gbuffer_source */
    int32_t threads;    /* of a software driver; 0: the driver's default */
    int32_t depth_encoding, normal_encoding, normals;
    float near, far; /* of the depth encoding, scene units; 0: from the view's own depths */
    int32_t thrift;  /* what nothing can occlude is left out */
    int32_t bent_normal, visibility_rgb, specular, irradiance, lit; /* whether these outputs are wanted */
};
/* From the first switch on options are off unless they are asked for. From the first output on an option says whether an output
 * is wanted besides visibility; they are in the order of enum aob_output. */
enum {
    AOB_OPTION_FIRST_SWITCH = 9,
    AOB_OPTION_FIRST_OUTPUT = 10,
    AOB_OPTION_COUNT = AOB_OPTION_FIRST_OUTPUT + AOB_OUTPUT_COUNT - 1
};

extern const struct aob_param aob_option_params[AOB_OPTION_COUNT];

/* The outputs that they want besides visibility, bits 1 << enum aob_output, and AOB_WANT_THRIFT. */
uint32_t aob_options_wanted(const struct aob_options *options);
#endif
