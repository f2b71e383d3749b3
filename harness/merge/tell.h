/* What is said of a merge: its warnings and its document. */
#ifndef AOB_MERGE_TELL_H
#define AOB_MERGE_TELL_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/table.h"
#include "files.h"
#include "set.h"
#include "union.h"

struct aob_merge_told {
    json_t *name, *out;               /* of the run; a row for each folder that was written */
    json_t *conflicts, *lost, *apart; /* of all folders (union.h, files.h) */
    size_t cases, dropped;
    struct aob_table planned, found; /* keys of the plans; found: those of them that some folder has */
};

void aob_merge_told_init(struct aob_merge_told *told);
void aob_merge_told_take(struct aob_merge_told *told, const struct aob_merge_set *set, const json_t *info,
                         const struct aob_merge_union *all, const struct aob_merge_files *files);

/* Warns of what conflicts, of files that are lost or kept apart, and of how many cases are missing; of each kind the first ten and the
 * number of the others. Returns whether there was nothing to warn of. */
bool aob_merge_told_tell(const struct aob_merge_told *told);
json_t *aob_merge_told_to_json(const struct aob_merge_told *told, const char *const *folders,
                               size_t count); /* docs/design.md, Merged folders; a new object */
void aob_merge_told_finish(struct aob_merge_told *told);
#endif
