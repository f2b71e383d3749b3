/* A frame of the fuzzer: values, options, a small G-buffer, a light and a few triangles, all drawn by lot. The frame of a seed, a
 * technique, a backend and a number is the same everywhere, so that one frame can be drawn alone. Threads: one at a time. */
#ifndef AOB_STRESS_FUZZ_FRAME_H
#define AOB_STRESS_FUZZ_FRAME_H
#include <jansson.h>
#include "chance.h"
#include "gbuffer/gbuffer.h"
#include "scene/light.h"
#include "technique/option.h"

/* What a pixel of the G-buffer shows. Of a hostile one depth or normal are what no renderer should write. */
enum aob_fuzz_pixel { AOB_FUZZ_SURFACE, AOB_FUZZ_SKY, AOB_FUZZ_HOSTILE };

enum { AOB_FUZZ_SIDE = 24, AOB_FUZZ_GUARD = 4, AOB_FUZZ_TRIANGLES = 12 };

struct aob_fuzz_frame {
    const struct aob_technique *technique;
    double params[AOB_MAX_PARAM], options[AOB_OPTION_COUNT];
    struct aob_gbuffer gbuffer;
    unsigned char *pixels;           /* enum aob_fuzz_pixel of each, guard band included */
    float *calm_depth, *calm_normal; /* the G-buffer before anything hostile was put in */
    struct aob_light light;
    struct aob_vec3 corners[AOB_FUZZ_TRIANGLES][3]; /* view space; the view is the world */
    size_t triangle_count;
};

/* Frames of so many numbers in a row share what compiles: constants, options, kind of view, and which sides are powers of two,
 * for which software drivers compile other code. Half a second of compiling is as long as drawing so many frames. */
enum { AOB_FUZZ_SHARED = 512 };
struct aob_fuzz_name {
    const struct aob_technique *technique;
    const char *backend;
    uint64_t seed, index;
};
void aob_fuzz_frame_init(struct aob_fuzz_frame *frame, const struct aob_fuzz_name *name);
void aob_fuzz_frame_copy(struct aob_fuzz_frame *into, const struct aob_fuzz_frame *from); /* a new one */
void aob_fuzz_frame_finish(struct aob_fuzz_frame *frame);

/* Pixels of the image, without the guard band, and the place of pixel i of it in the arrays. */
int aob_fuzz_frame_width(const struct aob_fuzz_frame *frame);
int aob_fuzz_frame_height(const struct aob_fuzz_frame *frame);
size_t aob_fuzz_frame_place(const struct aob_fuzz_frame *frame, size_t i);
size_t aob_fuzz_frame_pixels(const struct aob_fuzz_frame *frame);  /* guard band included */
size_t aob_fuzz_frame_hostile(const struct aob_fuzz_frame *frame); /* how many of them are hostile */

/* The values as the technique's own struct, 4 * AOB_MAX_PARAM bytes, and the options. */
void aob_fuzz_frame_pack(const struct aob_fuzz_frame *frame, void *values, struct aob_options *options);

/* Fills pixels, depth and normals (fuzz_gbuffer.c). `scale` is about how far the surfaces are. */
void aob_fuzz_gbuffer_fill(struct aob_fuzz_frame *frame, struct aob_chance *chance, double scale);

/* Paints the pixels, and draws the light (fuzz_light.c). */
void aob_fuzz_light_fill(struct aob_fuzz_frame *frame, struct aob_chance *chance);

/* Values of the parameters by lot (fuzz_values.c): those that compile or lay passes, and the others. What check() refuses
 * is drawn again a few times. */
void aob_fuzz_values_fixed(struct aob_fuzz_frame *frame, struct aob_chance *chance);
void aob_fuzz_values_free(struct aob_fuzz_frame *frame, struct aob_chance *chance, double scale);

/* Everything but the pixels, for a reader. */
json_t *aob_fuzz_frame_to_json(const struct aob_fuzz_frame *frame);
#endif
