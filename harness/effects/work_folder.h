/* A folder for the frames of a plan of effects, which goes with the plan. */
#ifndef AOB_EFFECTS_WORK_FOLDER_H
#define AOB_EFFECTS_WORK_FOLDER_H
#include <stdbool.h>
#include "base/error.h"

enum { AOB_WORK_FOLDER = 64 }; /* bytes of its path */

/* In /tmp, of this process alone. False after a line. */
bool aob_work_folder_create(char path[AOB_WORK_FOLDER], struct aob_error *error);

/* With all that is in it. */
void aob_work_folder_remove(const char *path);
#endif
