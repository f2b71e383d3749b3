/* For plan.c: what varies in a plan, so that a case can be described by it. */
#ifndef AOB_PLAN_DESCRIBE_H
#define AOB_PLAN_DESCRIBE_H
#include "plan.h"

void aob_plan_vary(struct aob_plan *plan);
#endif
