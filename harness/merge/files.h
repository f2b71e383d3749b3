/* The files that the records of a set name: images, truths, raw rounds, pictures of pass graphs. */
#ifndef AOB_MERGE_FILES_H
#define AOB_MERGE_FILES_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "union.h"

struct aob_merge_files {
    size_t copied;
    json_t *lost; /* of files that no folder has whole: {file, folder, reason} */
    json_t *
        apart; /* of files of one name and other bytes: {file, folders[2], becomes} (null: a graph, of which the first
                    * folder's stands) */
};

/* Copies what the records that stand name from their folders into `out`. A sealed file is copied only if its seal is right, so
 * what is damaged in one folder is taken from another that has it whole, also from one whose record was dropped. The name of a truth says what it depends on: two files of
 * one name should have the same bytes. Where they have not, the second gets a name of its own, and the lines of the records that name it
 * are changed to that in place. Nothing is on disk before aob_folder_flush. False after a line if a file cannot be written. Call
 * aob_merge_files_finish in either case. */
bool aob_merge_files_copy(struct aob_merge_files *files, const struct aob_merge_union *all, const char *out,
                          struct aob_error *error);
void aob_merge_files_finish(struct aob_merge_files *files);
#endif
