/* Folders of parts of one run, such as its shards, become one folder, which every command takes as that of an ordinary run. */
#ifndef AOB_MERGE_MERGE_H
#define AOB_MERGE_MERGE_H
#include <jansson.h>
#include <stddef.h>
#include "base/error.h"

struct aob_merge_desc {
    const char *const *folders; /* in the order in which they win */
    size_t count;
    const char *out;
};

struct aob_merged {
    json_t *document; /* that of `merge --json` (docs/design.md, Merged folders) */
    enum aob_exit code;
};

/* Merges. Nothing is written unless all folders are parts of one run, none of them is being written to, and each folder that is to
 * be written can be created and holds nothing else. While a merge writes to a folder, that holds no run: the journal is emptied first and written
 * last, as a whole. So an interrupted merge is made again by the same call, and the same folders give the same journal, byte for
 * byte. Notes and warnings tell which folders went elsewhere, what conflicts, what is lost and how much is missing. The code is
 * 0 where each case of the plan is there and nothing conflicts and no file is lost, else 3. False after a line if nothing could
 * be merged, or a later folder not; else decref the document. */
bool aob_merge(const struct aob_merge_desc *desc, struct aob_merged *merged, struct aob_error *error);
#endif
