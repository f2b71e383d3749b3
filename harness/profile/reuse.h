/* Misses of fully associative LRU caches of every size, from the exact reuse distance of each access: how many distinct
 * lines were used since this one was (Bennett and Kruskal: LRU Stack Processing, IBM Journal of Research and Development
 * 19, 1975). A bit for each point in time says whether a line was used there last; blocks of 512 bits are summed by a
 * tree. Sectors are as in tags.h. Threads: one at a time for each object. */
#ifndef AOB_PROFILE_REUSE_H
#define AOB_PROFILE_REUSE_H
#include <stddef.h>
#include <stdint.h>
#include "curve.h"

struct aob_reuse *aob_reuse_create(uint32_t numbers,
                                   uint32_t sectors); /* all numbers are below it; 0 sectors means 1 */
double aob_reuse_bytes(uint32_t numbers,
                       uint32_t sectors); /* of memory at most, without the curves taken of it */
void aob_reuse_destroy(struct aob_reuse *reuse);
void aob_reuse_access(struct aob_reuse *reuse, const uint32_t *numbers, size_t count);

/* Free with aob_curve_finish. */
void aob_reuse_curve(const struct aob_reuse *reuse, struct aob_curve *curve);
#endif
