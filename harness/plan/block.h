/* Which cases of a plan are measured together. Pure functions of the plan; no state. */
#ifndef AOB_PLAN_BLOCK_H
#define AOB_PLAN_BLOCK_H
#include "plan.h"

/* The block that begins at case *at, of the cases that are `wanted` (one entry a case; NULL: all): at most AOB_BLOCK_MAX that may lie in one
 * (aob_case_same_block). Builds of one case are not parted, as they are what is compared, unless they are too many. *at moves
 * behind them. Returns how many they are, with their places in `indices`; 0 where none is wanted there. */
size_t aob_plan_next_block(const struct aob_plan *plan, const bool *wanted, size_t *at,
                           size_t indices[AOB_BLOCK_MAX]);
#endif
