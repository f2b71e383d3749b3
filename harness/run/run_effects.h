/* A run of a config with `effects: auto`: what can be judged is judged before the views are planned, which takes a while. */
#ifndef AOB_RUN_RUN_EFFECTS_H
#define AOB_RUN_RUN_EFFECTS_H
#include <jansson.h>
#include "run.h"
#include "sweep.h"

/* Judges filter, folder and document, then chooses the cases (aob_sweep_choose) and puts them into `info`, which was made of all that could
 * be chosen. Does nothing for a config without effects. False after a line. */
bool aob_run_effects_choose(const struct aob_run_desc *desc, struct aob_sweep *sweep, json_t *info,
                            struct aob_error *error);
#endif
