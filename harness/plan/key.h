/* For plan.c: the keys of the cases. */
#ifndef AOB_PLAN_KEY_H
#define AOB_PLAN_KEY_H
#include "plan.h"

/* Gives each case its key, and drops those whose key an earlier one has. The targets must be there. */
void aob_plan_make_keys(struct aob_plan *plan);
#endif
