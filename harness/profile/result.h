/* What a simulation found, of each pass and of the frame. */
#ifndef AOB_PROFILE_RESULT_H
#define AOB_PROFILE_RESULT_H
#include <jansson.h>
#include <stdbool.h>
#include "curve.h"
#include "issue.h"
#include "operations.h"
#include "profile.h"

/* How many warps of a unit take turns, sample by sample. A device lies between the two, so a figure is always a band. */
enum aob_flight {
    AOB_FLIGHT_ONE,  /* one warp runs to its end: the fewest misses, as a rule */
    AOB_FLIGHT_MOST, /* as many as the profile's unit holds */
    AOB_FLIGHT_COUNT
};

/* Of all caches of a level together. */
struct aob_misses {
    uint64_t accesses;   /* texels of the first level; of the next what the one before missed */
    uint64_t misses;     /* a miss brings a sector, or a line where the level has none */
    uint64_t compulsory; /* those of what this cache had not yet held since it was empty */
    /* The rest of the misses in two, known where a curve was asked for. Fully associative caches of the same size miss
     * compulsory + capacity; what this one misses more is conflict, below 0 where it misses less. */
    int64_t capacity, conflict;
};

struct aob_cache_pass {
    char name[48];
    int index, width, height; /* as in trace.h */
    uint64_t pixels;          /* of its area */
    uint64_t invocations;     /* as many as pixels, but of fragments */
    uint64_t fetches;         /* operations on textures */
    uint64_t
        distinct; /* of those what an invocation asks for the first time: a compiler merges the others. Only these
                           * go on; a bilinear one is up to four texels */
    uint64_t texels;                     /* accesses of the first level */
    uint64_t bytes_asked, bytes_written; /* of those texels; of what the pass writes to its targets */
    uint64_t lanes_busy, lanes_issued;   /* of warps, summed over the fetches that they issue */
    uint64_t target_pixels;              /* written, those of each target */
    struct aob_issue issue;              /* of texture units; 0 where the profile has no rates */
    struct aob_operations operations;    /* where they are counted */
    bool counted;                        /* of the frame: of each pass */
    struct aob_misses levels[AOB_PROFILE_MAX_LEVEL][AOB_FLIGHT_COUNT];
    struct aob_curve
        curves[AOB_FLIGHT_COUNT]; /* of the first level, of all units together; empty if not asked for */
    float *
        map; /* misses of the first level, a number for each pixel of the area, row by row from the top; NULL if not
                 * asked for, and of the frame */
};

struct aob_cache_result {
    const struct aob_profile *profile; /* borrowed */
    bool split;                        /* capacity and conflict are known */
    struct aob_cache_pass *passes;     /* in the order that they ran in */
    size_t pass_count, pass_capacity;
    struct aob_cache_pass frame; /* all passes together; its area is the largest of theirs */
};
void aob_cache_result_add(struct aob_cache_result *result,
                          const struct aob_cache_pass *pass); /* to the frame */
/* What pass number `pass` executed, in place of what was said of it before. Once it is known of each, so it is of the frame. */
void aob_cache_result_count(struct aob_cache_result *result, size_t pass,
                            const struct aob_operations *operations);
void aob_cache_result_finish(struct aob_cache_result *result);

/* Bytes that the level brought, the last one from memory. */
uint64_t aob_cache_filled(const struct aob_cache_result *result, const struct aob_cache_pass *pass, int level,
                          enum aob_flight flight);

/* The document of docs/design.md, "Cache figures". */
json_t *aob_cache_result_to_json(const struct aob_cache_result *result);
#endif
