/* The cache figures of a case: the member `cache` of its record. */
#ifndef AOB_RUN_CACHE_CASE_H
#define AOB_RUN_CACHE_CASE_H
#include <jansson.h>
#include "measurement.h"

/* What the plan's profiles make of the fetches of case `index`, in a worker of its own: an object with a member for each
 * profile (docs/design.md, Cache figures). A case that cannot be traced, and one whose worker fails, has the reason in
 * its place. A new object. */
json_t *aob_cache_case(struct aob_measurement *m, size_t index, const struct aob_view_files *files);

/* Whether a record holds what the plan's profiles ask for now: figures of the same profile, or the reason why there can
 * be none. What failed is tried again. */
bool aob_cache_case_is_done(const struct aob_plan *plan, const json_t *record);

/* Ends a case of which a record is stored (state.h): the record with cache figures of now and all else as it was. A case that
 * was refused has the reason in their place, but for those that are stored and still wanted. */
void aob_cache_case_again(struct aob_measurement *m, size_t index);
#endif
