/* What stands out is settled: measured again beside the old module, or compared by its images. */
#ifndef AOB_NIGHTLY_SETTLE_H
#define AOB_NIGHTLY_SETTLE_H
#include "old_files.h"
#include "start.h"
#include "suspect.h"

/* Gives every suspect its verdict, and draws the maps of images that changed. What cannot be measured again is left open with
 * the cause; that is no error. `nights`: those of the config. False with a line if a map cannot be written. */
bool aob_suspects_settle(struct aob_suspects *suspects, struct aob_history *history,
                         const struct aob_nights *nights, const struct aob_nightly_desc *desc,
                         const struct aob_night_start *start, struct aob_error *error);
#endif
