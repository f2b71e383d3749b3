/* For plan.c: the scenes of a plan, one a choice of the config, in its order. */
#ifndef AOB_PLAN_PLAN_SCENE_H
#define AOB_PLAN_PLAN_SCENE_H
#include "plan.h"

/* Everything but the targets. False with a line that has the choice's position. */
bool aob_plan_choose_scenes(struct aob_plan *plan, struct aob_error *error);
void aob_plan_scene_finish(struct aob_plan_scene *scene);
#endif
