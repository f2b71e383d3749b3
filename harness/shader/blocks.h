/* The basic blocks of a module, and what one run of each takes. Blocks are numbered in the order of their labels, through all
 * functions. Run the words through aob_shader_optimise first: what is counted is what stands there. */
#ifndef AOB_SHADER_BLOCKS_H
#define AOB_SHADER_BLOCKS_H
#include "profile/operations.h"
#include "spirv.h"

struct aob_blocks {
    struct aob_operations *each; /* by the number of the block */
    size_t count;
    size_t first; /* number of the block that an invocation begins with: it is run once an invocation */
};

/* A product that nothing but one sum or difference uses is free, as both are one instruction, and so is what is the same for
 * all invocations (uniform.h). False after one line, which
 * names the instruction that operation.h does not know; leaves nothing behind then. */
bool aob_blocks_init(struct aob_blocks *blocks, const struct aob_spirv *spirv, struct aob_error *error);
void aob_blocks_finish(struct aob_blocks *blocks);
#endif
