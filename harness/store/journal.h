/* The journal of a run: one JSON object a line, each on disk (fsync) before the next case starts. A line cut
 * short by a crash is ignored when the journal is read, and cut off before the next line is written. */
#ifndef AOB_STORE_JOURNAL_H
#define AOB_STORE_JOURNAL_H
#include <jansson.h>
#include <stdbool.h>
#include <sys/types.h>
#include "base/error.h"
#include "base/file.h"

/* Reads every whole line that is an object with a "key". If several lines have one key, the last stands. A missing file
 * is an empty journal. Bytes are what it holds: after a loss of power, zeros may stand where a line was or before one.
 * What is no record is passed over, and one line in `damage` tells of it (NULL: nobody asks; it stays as it is where
 * nothing is damaged). NULL after an error line; json_decref the array. */
json_t *aob_journal_read(const char *path, struct aob_error *damage, struct aob_error *error);

/* The same with no other members than those that `paths` name (base/json_keep.h; NULL: with all), which is faster by what the
 * others take. One of them is "key". */
json_t *aob_journal_read_only(const char *path, const char *const *paths, struct aob_error *damage,
                              struct aob_error *error);

/* The same, with the bytes of each record as they stand in the file, for who passes them on. What `paths` leave out of a line is not looked
 * at, so a fault within it goes unseen. */
struct aob_journal_lines {
    char *text; /* of the file */
    struct aob_piece
        *items; /* of each record, in their order: its line without the line break; within `text` */
    size_t capacity;
};
json_t *aob_journal_read_lines(const char *path, const char *const *paths, struct aob_journal_lines *lines,
                               struct aob_error *damage, struct aob_error *error);
void aob_journal_lines_finish(struct aob_journal_lines *lines);

struct aob_journal {
    int file; /* locked, so that one run has the folder */
    char *path;
    off_t size; /* bytes of the lines that were written so far */
};
/* Opens or creates a journal for appending. It is refused with one line while another process has it open. */
bool aob_journal_open(struct aob_journal *journal, const char *path, struct aob_error *error);

/* Opens a journal to read it, and keeps every run from writing to it until aob_journal_close. Several programs may hold it
 * at once. It is refused with one line while a run writes to it. */
bool aob_journal_hold(struct aob_journal *journal, const char *path, struct aob_error *error);

/* Writes a line onto the disk, whole or not at all. False with the cause, and also if the file is no longer the one
 * that the path names (aob_journal_check). */
bool aob_journal_append(struct aob_journal *journal, const json_t *record, struct aob_error *error);

/* Whether all that was written is still where it was written to. False: the file or its folder was deleted, moved,
 * replaced or cut by somebody else, and the line says which. */
bool aob_journal_check(const struct aob_journal *journal, struct aob_error *error);

bool aob_journal_clear(struct aob_journal *journal, struct aob_error *error); /* removes all lines, on disk */
void aob_journal_close(struct aob_journal *journal);
#endif
