/* The cache figures of a case as lines for people. */
#ifndef AOB_COMMAND_CACHE_TABLE_H
#define AOB_COMMAND_CACHE_TABLE_H
#include <jansson.h>
#include "base/text.h"

/* Of one profile, as the record has them (docs/design.md, Cache figures), which must be ok: what was fetched, a row for
 * each level, and the curve of the first. Each figure as a band, from one warp in flight to the most. */
void aob_cache_table_print(const char *profile, const json_t *figures, struct aob_text *out);
#endif
