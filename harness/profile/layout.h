/* Where the texels of a frame's textures lie in the memory of a profile's device. Each texture begins at a multiple of 64
 * KiB, in the order of aob_trace_frame; its levels lie behind each other, the finest first, each at a multiple of 512
 * bytes. */
#ifndef AOB_PROFILE_LAYOUT_H
#define AOB_PROFILE_LAYOUT_H
#include <stdbool.h>
#include <stdint.h>
#include "profile.h"
#include "trace.h"

enum {
    AOB_LAYOUT_MAX_LEVEL = 15,
    AOB_LAYOUT_ROW = 256, /* bytes: a linear row begins at a multiple of it */
    AOB_LAYOUT_GOB = 512, /* bytes of a GOB: 64 x 8 rows */
    AOB_LAYOUT_TEXTURE = 65536,
};

struct aob_placed { /* a level in memory */
    enum aob_layout layout;
    uint64_t base, size;  /* bytes */
    uint32_t texel_shift; /* log2 of the bytes of a texel */
    uint32_t pitch;       /* linear: bytes of a row; Morton: tiles in a row; block-linear: GOBs in a row */
    uint32_t block_shift; /* block-linear: log2 of the GOBs of a block */
};

struct aob_placed_frame {
    struct aob_placed levels[AOB_TRACE_MAX_TEXTURE][AOB_LAYOUT_MAX_LEVEL];
    int bytes[AOB_TRACE_MAX_TEXTURE]; /* of a texel */
    uint64_t size;                    /* of all of it */
};

/* False with a line if a texture has more levels than AOB_LAYOUT_MAX_LEVEL. */
bool aob_layout_place(const struct aob_profile *profile, const struct aob_trace_frame *frame,
                      struct aob_placed_frame *placed, struct aob_error *error);

/* False with a line if a plane or a target of the pass is no level of the frame's textures, or of another size. */
bool aob_layout_judge(const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                      struct aob_error *error);

/* One level of such a size, from `base` on. */
struct aob_placed aob_layout_level(const struct aob_profile *profile, int bytes, int width, int height,
                                   uint64_t base);

int aob_layout_texel_bytes(enum aob_format format);

static inline uint64_t aob_layout_morton(uint32_t x, uint32_t y) /* in a tile of 8 x 8 */
{
    return (x & 1) | (y & 1) << 1 | (x & 2) << 1 | (y & 2) << 2 | (x & 4) << 2 | (y & 4) << 3;
}

/* The order within a GOB, x in bytes: Tegra X1 Technical Reference Manual, 20.1; also in Mesa (nil) and
 * nouveau. */
static inline uint64_t aob_layout_in_gob(uint32_t x, uint32_t y)
{
    return (x & 32) << 3 | (y & 6) << 5 | (x & 16) << 1 | (y & 1) << 4 | (x & 15);
}

/* The address of a texel's first byte. */
static inline uint64_t aob_layout_address(const struct aob_placed *placed, uint32_t x, uint32_t y)
{
    uint64_t pitch = placed->pitch, byte = (uint64_t)x << placed->texel_shift;
    if (placed->layout == AOB_LAYOUT_LINEAR)
        return placed->base + y * pitch + byte;
    if (placed->layout == AOB_LAYOUT_MORTON)
        return placed->base +
               (((y / 8 * pitch + x / 8) * 64 + aob_layout_morton(x, y)) << placed->texel_shift);
    uint64_t gob_row = y / 8, block = gob_row >> placed->block_shift;
    uint64_t gob =
        ((block * pitch + byte / 64) << placed->block_shift) + (gob_row - (block << placed->block_shift));
    return placed->base + gob * AOB_LAYOUT_GOB + aob_layout_in_gob((uint32_t)byte, y);
}
#endif
