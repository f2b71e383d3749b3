/* The folders that are merged, by device: figures of two devices never lie in one folder. */
#ifndef AOB_MERGE_SET_H
#define AOB_MERGE_SET_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "source.h"

struct aob_merge_set { /* folders whose devices agree */
    char *out;         /* the folder that they become */
    json_t *devices;   /* of all of them, as in run.json */
    const struct aob_merge_source *
        *sources; /* in the order given, which is that of the array they lie in; borrowed */
    size_t count, capacity;
};
struct aob_merge_sets {
    struct aob_merge_set *items;
    size_t count, capacity;
};

/* Puts each source into the first set whose devices agree with its own (store/run_folder.h), else into a new one. A backend
 * that could not be opened anywhere agrees with every device. The first set becomes the folder `out`, the others out-2, out-3
 * and so on. */
void aob_merge_sets_make(struct aob_merge_sets *sets, const struct aob_merge_source *sources, size_t count,
                         const char *out);

/* Prints a note of each set after the first: which folders went where, and which device differs. */
void aob_merge_sets_tell(const struct aob_merge_sets *sets);

/* Whether a merge may write the folder of each set: it can be created, it holds no run, or what an earlier merge of some of the
 * sources left there, to which no run has added anything since and none is adding; and it is none of the sources. False after a
 * line; nothing is written. */
bool aob_merge_sets_judge(const struct aob_merge_sets *sets, const struct aob_merge_source *sources,
                          size_t count, struct aob_error *error);

void aob_merge_sets_finish(struct aob_merge_sets *sets);
#endif
