/* The light probes of a config, read by workers before the plan is made, whose keys depend on them. */
#ifndef AOB_RUN_LIGHTS_H
#define AOB_RUN_LIGHTS_H
#include "base/error.h"
#include "config/config.h"
#include "dispatch.h"

/* Fills in the coefficients of each scene's probe, and notes what nine coefficients lose of it. False with one line
 * (FILE:LINE:COLUMN where the config has a position) if a file cannot be read as a probe. */
bool aob_lights_load(struct aob_config *config, const struct aob_dispatch *dispatch, struct aob_error *error);
#endif
