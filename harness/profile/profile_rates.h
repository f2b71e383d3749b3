/* For profile_read.c: the mapping `rates` of a profile. */
#ifndef AOB_PROFILE_PROFILE_RATES_H
#define AOB_PROFILE_PROFILE_RATES_H
#include "config/yaml.h"
#include "profile.h"

bool aob_profile_rates_read(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_profile *profile);

/* Once the levels are known as well: with rates every level but the last has a fill, and no other one has. `root` is the
 * file's mapping. */
bool aob_profile_rates_judge(struct aob_yaml *yaml, const yaml_node_t *root,
                             const struct aob_profile *profile);
#endif
