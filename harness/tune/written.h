/* The config that a fit writes: that of the user, with the technique at its values and at the fitted ones in place of its entries. All
 * else stays as it is written there, comments of the list of techniques aside. */
#ifndef AOB_TUNE_WRITTEN_H
#define AOB_TUNE_WRITTEN_H
#include "tune.h"

/* The path beside the config "FILE.yaml": "FILE-TECHNIQUE.yaml"; free() it. */
char *aob_tune_written_path(const char *config, const char *technique);

/* What can be said before a fit: `path` is new and can be written, and the config's paths mean the same there. False after a line. */
bool aob_tune_written_check(const struct aob_tune_desc *desc, const char *path, struct aob_error *error);

/* Writes it, whole or not at all. A setting must be chosen. */
bool aob_tune_written_save(const struct aob_tune_desc *desc, const struct aob_tune *tune, const char *path,
                           struct aob_error *error);
#endif
