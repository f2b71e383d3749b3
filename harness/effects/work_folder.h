/* A folder for the frames of a plan of effects, which goes with the plan. Where this process ends before that, by a signal or otherwise, a
 * process of its own removes it: it waits until this one and all its workers, which write there, are gone. */
#ifndef AOB_EFFECTS_WORK_FOLDER_H
#define AOB_EFFECTS_WORK_FOLDER_H
#include <stdbool.h>
#include <sys/types.h>
#include "base/error.h"

struct aob_work_folder {
    char *path;
    int alive; /* a pipe's end that closes with the last process of this program; -1: nobody keeps the folder */
    pid_t keeper; /* who waits for that */
};

/* In the folder that TMPDIR names, or where that cannot be written in /tmp; of this process alone. False after a line. */
bool aob_work_folder_create(struct aob_work_folder *folder, struct aob_error *error);

/* With all that is in it. */
void aob_work_folder_remove(struct aob_work_folder *folder);
#endif
