/* Puts the invocations of a capture into the order of a profile's threads, warp by warp, and gives each texel that they
 * ask for the number of its sector, or of its line, in memory. */
#ifndef AOB_PROFILE_GATHER_H
#define AOB_PROFILE_GATHER_H
#include "layout.h"
#include "result.h"

struct aob_warp {
    int unit; /* that it runs on */
    int slots;
    const uint32_t
        *start; /* slots + 1: fetch s of all lanes asks for numbers[start[s]] .. numbers[start[s + 1] - 1] */
    const uint32_t *numbers; /* addresses / the bytes that the first level brings */
    const uint32_t *pixels;  /* of each number its pixel, y * width + x; NULL if not asked for */
};

struct aob_gather_desc { /* all borrowed */
    const struct aob_profile *profile;
    const struct aob_placed_frame *placed;
    const struct aob_trace_pass *pass;
    struct aob_cache_pass *
        counts; /* invocations, fetches, distinct, texels, bytes_asked, issue and the lanes are added up here */
    bool pixels;
    void *self;
    void (*take)(void *self, const struct aob_warp *warp); /* what it points to lives for the call */
};

struct aob_gather;
struct aob_gather *aob_gather_create(const struct aob_gather_desc *desc);
void aob_gather_destroy(struct aob_gather *gather);
/* False with a line where a word names no texel of the pass. */
bool aob_gather_band(struct aob_gather *gather, const struct aob_trace_band *band, struct aob_error *error);
bool aob_gather_end(struct aob_gather *gather,
                    struct aob_error *error); /* the last fragments may fill no warp */
#endif
