/* What the run of a night lacks of its plan. */
#ifndef AOB_NIGHTLY_LACKS_H
#define AOB_NIGHTLY_LACKS_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

/* *asked: cases of the plan that the run was asked for; *missing: those of them that its journal has no record of. False after a
 * line if the folder is no run's. */
bool aob_run_lacks(const char *run, size_t *asked, size_t *missing, struct aob_error *error);
#endif
