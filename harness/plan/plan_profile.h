/* The profiles of a plan, whose caches its cases are simulated on. */
#ifndef AOB_PLAN_PLAN_PROFILE_H
#define AOB_PLAN_PLAN_PROFILE_H
#include "plan.h"

/* Reads and judges the config's; the line has their position in it, and the profile's own where that is at fault. */
bool aob_plan_choose_profiles(struct aob_plan *plan, struct aob_error *error);
void aob_plan_profiles_finish(struct aob_plan *plan);

/* Seconds that the figures of a case take on two cores, roughly. */
double aob_plan_estimate_cache_s(const struct aob_plan *plan, const struct aob_case *c);
#endif
