/* What a stored record is worth to a run that is started again. */
#ifndef AOB_RUN_STORED_H
#define AOB_RUN_STORED_H
#include <jansson.h>
#include "plan/plan.h"

/* Whether a time's interval is as narrow as the config wants. Null, where no interval was reached, is not. */
bool aob_stored_is_precise(const struct aob_config *config, const json_t *time);

/* The seconds of timing a case that would make it so, as the record foretells them; NAN: the record foretells another
 * precision than this. */
double aob_stored_seconds_needed(const struct aob_config *config, const json_t *time);

/* Whether the case need not be measured again but for its cache figures (cache_case.h). Cases with a verdict stay; failed
 * and unsupported ones get another chance, and so does one that lacks what the plan's config wants. `folder` is the
 * run's. */
bool aob_stored_is_finished(const struct aob_plan *plan, const char *folder, const json_t *record);
#endif
