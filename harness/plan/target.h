/* For plan.c: what the cases of a scene are compared with. */
#ifndef AOB_PLAN_TARGET_H
#define AOB_PLAN_TARGET_H
#include "plan.h"

/* The targets of all scenes: the config's, or each distinct radius of a scene's cases. False after a line if there are
 * more than can be measured; it comes before the keys, whose texts have them all. */
bool aob_plan_add_targets(struct aob_plan *plan, struct aob_error *error);

/* Once the keys are made: the radius of each case's own target. Without a measured error there are none. */
void aob_plan_settle_targets(struct aob_plan *plan);
#endif
