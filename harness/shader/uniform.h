/* Values that are the same for all invocations of a draw: constants, what is read from a uniform block, sizes of images, and
 * what is computed of nothing else. A driver computes those once a draw and not in each invocation (docs/operations.md). */
#ifndef AOB_SHADER_UNIFORM_H
#define AOB_SHADER_UNIFORM_H
#include "spirv.h"

/* By the id of the value; free(). What comes from several blocks (OpPhi) is never among them, nor is what an image gives. */
bool *aob_uniform_values(const struct aob_spirv *spirv);
#endif
