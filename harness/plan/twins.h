/* A plan that keeps some of its cases and has each of them with another build of its technique as well. */
#ifndef AOB_PLAN_TWINS_H
#define AOB_PLAN_TWINS_H
#include "plan.h"

/* `kept`: of each case. `module`: of the other build, as the plan's list of techniques has it. The other build's case has
 * the parameters of the kept one by their names, as far as it has them, and else its own defaults. The scenes' targets stay
 * what they were. False with a line if the module lacks a technique or refuses a value. */
bool aob_plan_take_twins(struct aob_plan *plan, const bool *kept, const char *module,
                         struct aob_error *error);
#endif
