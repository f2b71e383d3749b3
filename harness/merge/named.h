/* What files a record names below its run's folder. */
#ifndef AOB_MERGE_NAMED_H
#define AOB_MERGE_NAMED_H
#include <jansson.h>
#include <stdbool.h>
#include "base/file.h"

/* "images/KEY.exr", "truths/HASH.exr", "rounds/HASH.jsonl.zst", "graphs/DIGEST.dot": a new array of texts, each of them once. A name of
 * another form is among them. */
json_t *aob_merge_named(const struct aob_piece *line);

bool aob_merge_named_has(const json_t *names, const json_t *name);

/* Whether the name has one of these forms: a journal from elsewhere must not make a merge write outside its folder. */
bool aob_merge_named_is_safe(const char *name);
bool aob_merge_named_is_graph(const char *name); /* which has no seal */

/* Puts `to` in place of the file `from` wherever the line names it. Both are equally long. */
void aob_merge_named_change(const struct aob_piece *line, const char *from, const char *to);
#endif
