/* run.json of what is merged. */
#ifndef AOB_MERGE_MERGED_INFO_H
#define AOB_MERGE_MERGED_INFO_H
#include <jansson.h>
#include "set.h"

/* That of the set's first source, with `keys`, `techniques` and `devices` of all sources. `asked` is what all of them asked for,
 * in the plan's order, and absent where one of them asked for all. `seconds` is absent, since nobody has measured all of it and
 * there is no page; `merged` lists the sources' paths. A new object. */
json_t *aob_merged_info_create(const struct aob_merge_set *set);
#endif
