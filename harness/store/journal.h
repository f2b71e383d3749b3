/* The journal of a run: one JSON object a line, each on disk (fsync) before the next case starts. A line cut
 * short by a crash is ignored when the journal is read, and cut off before the next line is written. */
#ifndef AOB_STORE_JOURNAL_H
#define AOB_STORE_JOURNAL_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"

/* Reads every whole line that is an object with a "key". If several lines have one key, the last stands. A missing
 * file is an empty journal. NULL after an error line; json_decref the array. */
json_t *aob_journal_read(const char *path, struct aob_error *error);

struct aob_journal {
    int file; /* locked, so that one run has the folder */
    char *path;
};
/* Opens or creates a journal for appending. It is refused with one line while another process has it open. */
bool aob_journal_open(struct aob_journal *journal, const char *path, struct aob_error *error);
bool aob_journal_append(struct aob_journal *journal, const json_t *record, struct aob_error *error);
void aob_journal_close(struct aob_journal *journal);
#endif
