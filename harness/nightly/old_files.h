/* Where the file of an old build is: among those that the user gave, else in the history. */
#ifndef AOB_NIGHTLY_OLD_FILES_H
#define AOB_NIGHTLY_OLD_FILES_H
#include "history/line.h"
#include "history/night.h"

struct aob_old_files {
    struct aob_history *history;
    const char *given;  /* a module, or a folder of modules; NULL: none */
    const char *folder; /* files from the history are written here; made where one is */
};

/* The file of the build that `old` was measured with, for the module of `now`; free() it. What the user gave
 * stands for it, whatever the history says: of a folder the file at the module's path there, or else of its name; a single file for all
 * modules. NULL after a line where there is none, or where it is the new build itself. */
char *aob_old_files_find(const struct aob_old_files *files, const struct aob_point *old,
                         const struct aob_point *now, struct aob_error *error);
#endif
