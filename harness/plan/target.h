/* For plan.c: what the cases of a scene are compared with. */
#ifndef AOB_PLAN_TARGET_H
#define AOB_PLAN_TARGET_H
#include "plan.h"

/* The targets of all scenes: the config's, or each distinct radius of a scene's cases. */
void aob_plan_add_targets(struct aob_plan *plan);

/* Once the keys are made: whether they can be measured, and the radius of each case's own one. Without a measured error
 * there are none. */
bool aob_plan_settle_targets(struct aob_plan *plan, struct aob_error *error);
#endif
