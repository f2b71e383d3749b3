/* For plan.c: the order of the cases. */
#ifndef AOB_PLAN_GATHER_H
#define AOB_PLAN_GATHER_H
#include "plan.h"

/* Cases of one block lie together, each block where its first case was; within it builds of one case (aob_case_same_but_build)
 * lie beside each other. Otherwise each case stays in its order. Fills in `block`. */
void aob_plan_gather(struct aob_plan *plan);
#endif
