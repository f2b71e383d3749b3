/* What the invocations of a pass fetched, as numbers: what a capture (frame/trace.h) gives and a simulation takes. No
 * order of threads is in it: a profile imposes one when it gathers the words.
 *
 * Every level of every texture that a pass may read is a plane of texels, and the planes of a pass are numbered through:
 * texel (x, y) of a plane has the number first + y * width + x. So one 32-bit word names a texture, a level and a texel.
 * A pass has AOB_TRACE_MAX_TEXEL texels at most, so that no word of one texel has the bits of the flags. */
#ifndef AOB_PROFILE_TRACE_H
#define AOB_PROFILE_TRACE_H
#include <aobudget/technique.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"

enum {
    AOB_TRACE_BAND_ROWS =
        64, /* a band begins at a multiple of it, so tiles of up to 64 rows lie whole in one */
    AOB_TRACE_MAX_TEXTURE =
        2 * AOB_MAX_TEXTURE +
        7, /* the graph's, the same of the frame before, and depth, normal, velocity, materials and
                                    triangles of the screen */
    AOB_TRACE_MAX_PLANE =
        113, /* levels of AOB_MAX_IN inputs and of an own depth, depth, normal, velocity, materials */
};
#define AOB_TRACE_NONE UINT32_MAX /* the slot was not used; it is no word of texels, whatever its bits say */

/* A bilinear sample: the word has the number of the upper left one of 2 x 2 texels, which end at the plane's right and
 * lower edge. At the left and the upper edge a sampler that clamps to the edge reads the first column, or row, twice: then
 * the word says that there is only one. The flags of the edges come with AOB_TRACE_BILINEAR only. */
#define AOB_TRACE_BILINEAR   0x80000000u
#define AOB_TRACE_ONE_COLUMN 0x40000000u
#define AOB_TRACE_ONE_ROW    0x20000000u
#define AOB_TRACE_MAX_TEXEL  0x1fffffffu /* numbers are below it; it is the mask of a bilinear word's, too */

/* The number that a word has, which is not AOB_TRACE_NONE. */
static inline uint32_t aob_trace_texel(uint32_t word)
{
    return word & AOB_TRACE_BILINEAR ? word & AOB_TRACE_MAX_TEXEL : word;
}

enum aob_trace_role {                       /* whose a texture is */
                      AOB_TRACE_ROLE_GRAPH, /* the technique's, or the scene's triangles */
                      AOB_TRACE_ROLE_DEPTH, /* the screen's depth, also where normals are packed beside it */
                      AOB_TRACE_ROLE_NORMAL /* the screen's normals */
};

struct aob_trace_texture { /* one of the frame, whatever passes read or write it */
    char name
        [64]; /* the graph's name for it, "NAME before" of what the frame before left; the screen's are "depth", "normal"
                      and "triangles", which a graph may have as well */
    enum aob_format format;
    int width, height, levels; /* in texels, of level 0, as it lies in memory */
    enum aob_trace_role role;
};
struct aob_trace_plane {
    uint32_t first;     /* number of its texel (0, 0) in the pass */
    int width, height;  /* in texels, of this level, as it lies in memory */
    int texture, level; /* index into aob_trace_frame.textures; two bindings may show one texture */
};
struct aob_trace_write { /* of each texel of the pass's area, once an invocation */
    int texture, level;
};

struct aob_trace_pass {
    char name[48];     /* the graph's */
    int index;         /* in the graph */
    int width, height; /* of its area, in pixels */
    bool fragments;    /* it draws triangles: a pixel has any number of invocations, also none */
    struct aob_trace_plane planes[AOB_TRACE_MAX_PLANE]; /* by first, rising */
    int plane_count;
    struct aob_trace_write writes[AOB_MAX_OUT];
    int write_count;
};

/* Invocations of a pass. Without fragments they are those of rows row .. row + rows - 1, left to right, then downward.
 * With fragments they come in the order of their triangles, any number in each band. */
struct aob_trace_band {
    int row,
        rows; /* without fragments: a multiple of AOB_TRACE_BAND_ROWS; that many, fewer in the last band */
    size_t count;           /* of invocations */
    const uint32_t *pixels; /* of fragments: x | y << 16; else NULL */
    int slots;              /* words of an invocation, the same in all bands of a pass; may be 0 */
    const uint32_t
        *words; /* count x slots: in the order in which the invocation fetched, then AOB_TRACE_NONE */
};

struct aob_trace_frame {
    struct aob_trace_texture textures[AOB_TRACE_MAX_TEXTURE];
    int texture_count;
};

/* Who takes a capture. For each pass that ran, in order: begin, its bands from the first to the last, end. What the
 * pointers lead to lives for the call only, `frame` until the last pass has ended. A call that gives false stops the
 * capture, and its error is the capture's. */
struct aob_trace_sink {
    void *self;
    bool (*begin)(void *self, const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                  struct aob_error *error);
    bool (*band)(void *self, const struct aob_trace_band *band, struct aob_error *error);
    bool (*end)(void *self, struct aob_error *error);
};
#endif
