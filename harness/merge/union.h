/* The records of a set of folders, each case once. */
#ifndef AOB_MERGE_UNION_H
#define AOB_MERGE_UNION_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/file.h"
#include "set.h"

struct aob_merge_case {
    const char *key;                       /* borrowed */
    const struct aob_merge_source *source; /* whose record stands; NULL: no folder has the case */
    const struct aob_piece *line;          /* of that record; its bytes may be changed (files.h) */
    int rank;                              /* of its status: ok before invalid before the others */
};
struct aob_merge_other { /* a record of which another of the same case and status stands */
    size_t at;           /* of the case */
    const struct aob_merge_source *source;
    const struct aob_piece *line;
    int rank;
    const char *differs; /* in which member it says something else; NULL: it agrees, and was dropped */
};
struct aob_merge_union {
    struct aob_merge_case *cases; /* those of the plan in its order, then what else the folders have */
    size_t count, capacity;
    struct aob_merge_other *others; /* in the order of the sources */
    size_t other_count, other_capacity;
    size_t missing; /* cases of the plan that no folder has */
    size_t dropped; /* records that say the same as one that stands */
    /* Of records that say something else: {key, case, folders[2], differs, kept}; the first folder's stands, and `kept` is the file
     * that the other is written to. */
    json_t *conflicts;
};

/* Takes the records of all sources of the set. Of two of one case the better status stands, then the one of the source that
 * was given first. Whether two agree is asked of those of one status: by `image_digest`, and by `errors` with what lies beside
 * them (`error`, `sequence`). Times differ from one measurement to the next, and are not asked.
 * `keys`: those of the plan, an array of texts, which outlives the union. */
void aob_merge_union_make(struct aob_merge_union *all, const struct aob_merge_set *set, const json_t *keys);
void aob_merge_union_finish(struct aob_merge_union *all);

/* Writes the lines that lost a conflict to OUT/conflicts.jsonl, each as it stands in its journal: {"folder": …, "record": LINE}. Where
 * there is none, nothing is written. False after a line. */
bool aob_merge_union_keep(const struct aob_merge_union *all, const char *out, struct aob_error *error);

/* "corner/front gtao radius=0.5 slices=2, vulkan 64x36": the case of a journal's line; free() it. */
char *aob_merge_case_describe(const struct aob_piece *line);
#endif
