/* `aobudget doctor`: which drivers, helpers and meshes are there, and the command that installs what is not. */
#ifndef AOB_COMMAND_DOCTOR_H
#define AOB_COMMAND_DOCTOR_H
#include <stdbool.h>
#include "base/error.h"
#include "run/dispatch.h"

/* OK: all is there. PART: something is missing, named with its cure. USAGE: no backend that draws works. */
enum aob_exit aob_doctor(const struct aob_dispatch *dispatch, const char *json, bool quiet,
                         struct aob_error *error);
#endif
