/* A module that counts how often each of its blocks is run. Each invocation counts its own in variables, and adds them to a
 * storage buffer where it ends, so that a loop does not cost an atomic operation a turn. Nothing else that the module does
 * changes. */
#ifndef AOB_SHADER_COUNTERS_H
#define AOB_SHADER_COUNTERS_H
#include "spirv.h"

/* Of the buffer, in words of 32 bits. The host sets all to 0 before a draw. No word of a block has wrapped while invocations
 * times most is below 2^32. (No invocation runs 2^32 blocks: drivers stop what takes so long.) */
enum aob_counters_word {
    AOB_COUNTERS_INVOCATIONS,      /* the lower half of 64 bits */
    AOB_COUNTERS_INVOCATIONS_HIGH, /* the upper one */
    AOB_COUNTERS_MOST,             /* blocks that any invocation ran */
    AOB_COUNTERS_BLOCKS = 4,       /* and on: runs of each block, by its number (blocks.h) */
};

/* Allocated words (free()) and their count. `storage` is the number of the buffer in set 0, which the module must not use.
 * The module may be of SPIR-V 1.0 or later; before 1.3 the buffer has the form that was in use then. */
uint32_t *aob_counters_insert(const struct aob_spirv *spirv, uint32_t storage, size_t *count);
#endif
