/* How many accesses miss in a fully associative cache of each size: the miss-ratio curve. */
#ifndef AOB_PROFILE_CURVE_H
#define AOB_PROFILE_CURVE_H
#include <stddef.h>
#include <stdint.h>

struct aob_curve {
    size_t count;
    uint64_t *
        lines; /* of the cache, rising; a curve of every size holds those at which something changes, from 1 on */
    uint64_t *misses; /* the last: those that miss in a cache of any size */
};

void aob_curve_finish(struct aob_curve *curve); /* frees; empty again */

/* Misses in a cache of that many lines: those of the greatest size of the curve that is no larger. 0 lines, or an empty
 * curve, give 0. */
uint64_t aob_curve_at(const struct aob_curve *curve, uint64_t lines);

/* Adds the misses of another one to each size: of either where sizes differ. */
void aob_curve_add(struct aob_curve *curve, const struct aob_curve *other);
#endif
