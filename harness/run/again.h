/* The cases of an earlier run, measured again beside another build of their module. */
#ifndef AOB_RUN_AGAIN_H
#define AOB_RUN_AGAIN_H
#include <jansson.h>
#include "sweep.h"

struct aob_run_again {
    const char *place;     /* where the config lay that the run has a copy of */
    const json_t *records; /* the run's records of the old module, an array */
    const char *module;    /* of the other build, one of the dispatch's modules */
};

/* Reads the copy, without the scenes whose geometry cannot be had any more (gone.h); one warning for each says why, and how
 * many of the records are of it. */
bool aob_run_again_read(const struct aob_run_again *again, const char *copy, struct aob_config *config,
                        struct aob_error *error);

/* Leaves those cases of the sweep's plan that the records are of, which is what their keys say, and adds the other build
 * of each. One warning names each record that cannot be made again, and says what has changed. False with a line if none
 * can. */
bool aob_run_again_choose(const struct aob_run_again *again, struct aob_sweep *sweep,
                          struct aob_error *error);
#endif
