/* Files that come with the program. A shelf is a folder of YAML files: share/aobudget/SHELF where the program is
 * installed, configs/SHELF in its tree. A file is called by its name without folder and ending, or by its path. */
#ifndef AOB_BASE_SHELF_H
#define AOB_BASE_SHELF_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

/* The shelf's path; free() it. */
char *aob_shelf_folder(const char *shelf);

/* Whether a text is the path of a file, and no name: it has a slash or ends in .yaml. */
bool aob_shelf_is_path(const char *text);

/* The file that a text means: itself if it is a path, else the one of that name. free() it. NULL: there is no file of
 * the name, and the line calls it a `noun` and names those there are. */
char *aob_shelf_find(const char *shelf, const char *noun, const char *text, struct aob_error *error);

/* A path's name: without folder and ending. free() it. */
char *aob_shelf_name(const char *path);

/* The names of a shelf, in order of the alphabet. */
struct aob_shelf_names {
    char **items;
    size_t count, capacity;
};
bool aob_shelf_list(const char *shelf, struct aob_shelf_names *names, struct aob_error *error);
void aob_shelf_names_finish(struct aob_shelf_names *names);
#endif
