/* The captures of a config, brought into the cache by workers before the plan is made: their size and camera are
 * known only then. */
#ifndef AOB_RUN_CAPTURES_H
#define AOB_RUN_CAPTURES_H
#include "base/error.h"
#include "config/config.h"
#include "dispatch.h"

/* Fills width, height, camera, gbuffer and digest of every capture of the config; prints the warnings. False with one
 * line (FILE:LINE:COLUMN where the config has a position) if a file cannot be read as a capture. */
bool aob_captures_load(struct aob_config *config, const struct aob_dispatch *dispatch,
                       struct aob_error *error);
#endif
