/* A folder that is merged: its run.json and its journal, which no run may write to meanwhile. */
#ifndef AOB_MERGE_SOURCE_H
#define AOB_MERGE_SOURCE_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "store/journal.h"

struct aob_merge_source {
    const char *path;           /* as it was given; borrowed */
    json_t *info;               /* run.json */
    struct aob_journal journal; /* held */
    json_t *records;            /* of each line `key` and `status` alone */
    struct aob_journal_lines lines;
};

/* Opens the folder and holds its journal. A folder without a journal is one of a run that was stopped before its first case.
 * False after a line: it is no folder of a run, or a run is writing there. Call aob_merge_source_close in either case. */
bool aob_merge_source_open(struct aob_merge_source *source, const char *path, struct aob_error *error);

/* Whether the two hold parts of one run: the same config by its hash, and the same build of this program. False after a line
 * that names both folders and what differs. */
bool aob_merge_source_judge(const struct aob_merge_source *first, const struct aob_merge_source *other,
                            struct aob_error *error);

/* Whether each technique of the source is of the build that the sources before it have: a module that was built anew in between has
 * other images under the same name. `builds`: an object, empty at first, that takes what each source has. False after a line that
 * names the technique and both folders. */
bool aob_merge_source_judge_builds(const struct aob_merge_source *source, json_t *builds,
                                   struct aob_error *error);

/* Reads the journal. One warning tells of lines that are damaged. False after a line if it cannot be read. */
bool aob_merge_source_read(struct aob_merge_source *source, struct aob_error *error);

void aob_merge_source_close(struct aob_merge_source *source);
#endif
