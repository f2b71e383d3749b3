/* A device as a cache simulation sees it: how its threads are ordered, how textures lie in memory, and its caches. A
 * profile is a YAML file; docs/cache.md says how to write one. Each number in it has a source, and is confirmed by it or
 * not. */
#ifndef AOB_PROFILE_PROFILE_H
#define AOB_PROFILE_PROFILE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/error.h"
#include "base/hash.h"
#include "rates.h"
#include "tags.h"

enum { AOB_PROFILE_MAX_LEVEL = 4, AOB_PROFILE_MAX_FACT = 96 };

enum aob_layout {                    /* how the texels of a plane lie in memory */
                  AOB_LAYOUT_LINEAR, /* rows, each beginning at a multiple of 256 bytes */
                  AOB_LAYOUT_MORTON, /* tiles of 8 x 8 texels, row by row; within one the bits of x and y alternate */
                  AOB_LAYOUT_BLOCK_LINEAR, /* NVIDIA's: GOBs of 64 bytes x 8 rows, piled up to blocks of `block_height` */
                  AOB_LAYOUT_COUNT
};

struct aob_profile_level {
    char name[16]; /* "L1" */
    uint64_t size; /* bytes of one */
    uint32_t line; /* bytes; a power of two */
    uint32_t
        sector; /* bytes that a miss brings: the line, or a power of two below it; never less than the level before
                      * brings */
    uint32_t ways;
    uint32_t sets; /* size / line / ways */
    enum aob_index index;
    int units;         /* that share one; 0: all do. The first level's is 1 */
    bool cold_at_pass; /* emptied when a pass begins; else it lasts the frame */
    /* With rates, of each level but the last, which memory fills: bytes a clock that bring its misses through one port,
     * and the ports of all its caches together. */
    uint32_t fill, ports;
};

struct aob_size2 {
    int width, height;
};

/* A number of the file, for people: where it stands, what it is, and how that is known. */
struct aob_profile_fact {
    char *key;    /* "levels.L1.size" */
    char *value;  /* as the file has it; of what the machine tells, what it told */
    char *source; /* a sentence, or where to read it */
    bool confirmed;
};

void aob_profile_fact_finish(struct aob_profile_fact *fact);

struct aob_profile {
    char *name; /* of the file, without folder and ending */
    char *path, *title;
    int units;     /* that have a first level of their own */
    int in_flight; /* warps at most that a unit takes turns with */
    /* In pixels, all powers of two. A tile goes to a unit; it consists of blocks, a block of warps, a warp of quads of
     * 2 x 2, each row by row. A tile's height divides AOB_TRACE_BAND_ROWS (trace.h). */
    struct aob_size2 tile, block, warp;
    enum aob_layout layout;
    int block_height; /* of AOB_LAYOUT_BLOCK_LINEAR, in GOBs: 1, 2, 4, 8 or 16 at most; less where a plane is lower */
    /* Bytes of a texel of the screen's depth and normal, in place of their formats'; 0: their own. `depth` may stand for
     * a position: a technique of a text that reads one reads depth here. */
    int depth_bytes, normal_bytes;
    struct aob_profile_level levels[AOB_PROFILE_MAX_LEVEL];
    int level_count;        /* from the one next to the texture units on */
    struct aob_rates rates; /* rates.clock is 0 where the file has none */
    struct aob_profile_fact facts[AOB_PROFILE_MAX_FACT];
    size_t fact_count;
};

/* Reads a file. False: one line FILE:LINE:COLUMN, and nothing to finish. */
bool aob_profile_read(struct aob_profile *profile, const char *path, struct aob_error *error);
void aob_profile_finish(struct aob_profile *profile); /* frees; a zeroed one too */

#define AOB_PROFILE_SHELF "profiles" /* where those lie that come with the program (base/shelf.h) */

/* Reads the profile of a name, which lies beside the program, or of a path. */
bool aob_profile_find(struct aob_profile *profile, const char *name, struct aob_error *error);

/* Of all its numbers and words, with what the machine tells; comments and sources do not count. Figures of one digest are
 * of one device. */
void aob_profile_digest(const struct aob_profile *profile, char digest[AOB_KEY_SIZE]);

const char *aob_layout_name(enum aob_layout layout); /* "linear", "morton", "block_linear" */
#endif
