/* One cache of a level of a profile: its tags, what it has held, and the engines of its curve. */
#ifndef AOB_PROFILE_LEVEL_H
#define AOB_PROFILE_LEVEL_H
#include "result.h"
#include "simulate.h"

struct aob_level_desc {
    const struct aob_profile_level *level; /* borrowed */
    uint32_t numbers;                      /* of sectors, or lines: all are below it */
    enum aob_curve_kind curve;             /* AOB_CURVE_NONE: capacity and conflict are not told apart */
    bool own_size;                         /* the curve has the level's size only */
};

struct aob_level;
struct aob_level *aob_level_create(const struct aob_level_desc *desc);
void aob_level_destroy(struct aob_level *level);

/* Uses the numbers, adds to accesses, misses and compulsory, and writes the places of those that missed into `missed`,
 * which has room for `count`. Returns how many. */
size_t aob_level_access(struct aob_level *level, const uint32_t *numbers, size_t count, uint32_t *missed,
                        struct aob_misses *misses);

/* Misses of all accesses so far if the cache were fully associative; 0 without a curve. */
uint64_t aob_level_associative(const struct aob_level *level);
void aob_level_curve(const struct aob_level *level, struct aob_curve *curve); /* free with aob_curve_finish */

double aob_level_bytes(const struct aob_level_desc *desc); /* of memory, at most */
#endif
