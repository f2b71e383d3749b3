/* A config for two builds of a module: each of its entries for both of them. */
#ifndef AOB_CONFIG_CONFIG_BUILDS_H
#define AOB_CONFIG_CONFIG_BUILDS_H
#include "config.h"

struct aob_config_builds {
    const char *files[2];          /* as the current folder sees them; records call them so */
    const char *const *techniques; /* of both, NULL-ended */
};

/* An entry of one of the techniques becomes two, one of each file, with the same backends, parameters and axes. The others
 * are left out. False with a line if none is left. */
bool aob_config_take_builds(struct aob_config *config, const struct aob_config_builds *builds,
                            struct aob_error *error);
#endif
