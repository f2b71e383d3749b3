/* A file while it is written. It lies beside its place under a name that no other file has, .aobudget-RANDOM.part, made
 * exclusively and through no link; its writer holds a lock on it. When it is whole and on disk, it is renamed. Whatever
 * ends the writer leaves the old file or none, and a part that aob_part_clean removes. Threads: one part each. */
#ifndef AOB_BASE_PART_H
#define AOB_BASE_PART_H
#include <stdbool.h>
#include <stddef.h>
#include "error.h"

struct aob_part {
    int file;           /* open for writing */
    char *path;         /* of the part */
    const char *target; /* what it becomes; borrowed */
};

/* False after the line "TARGET: cannot write: ...". A part that was created ends by aob_part_keep or aob_part_drop. */
bool aob_part_create(struct aob_part *part, const char *target, struct aob_error *error);
bool aob_part_write(struct aob_part *part, const void *bytes, size_t size, struct aob_error *error);

/* Flushes the part to disk, gives it the target's name, and flushes the folder. If that fails, the part is dropped. */
bool aob_part_keep(struct aob_part *part, struct aob_error *error);

/* Gives the part the target's name and flushes nothing: after a loss of power the target may be there and hold less. If that fails,
 * the part is dropped. */
bool aob_part_name(struct aob_part *part, struct aob_error *error);
void aob_part_drop(struct aob_part *part);

/* Removes the parts in a folder whose writers are gone. Nothing else is touched, and a folder that cannot be read is
 * left as it is. */
void aob_part_clean(const char *folder);
#endif
