/* What a night is of: a config with program and modules, or a run that was made elsewhere. */
#ifndef AOB_NIGHTLY_SUBJECT_H
#define AOB_NIGHTLY_SUBJECT_H
#include <time.h>
#include "base/hash.h"
#include "nightly.h"

struct aob_subject {
    char name[256]; /* the config's */
    char config_hash[AOB_KEY_SIZE];
    char modules[AOB_KEY_SIZE]; /* hash of program and modules */
    time_t date;                /* when it began: now, or when the run did */
};
/* False after a line: the config or run.json cannot be read, or a module's file. */
bool aob_subject_read(struct aob_subject *subject, const struct aob_nightly_desc *desc, bool measured,
                      struct aob_error *error);
#endif
