/* The targets of a config: `target: {radius: R, weighting: cosine}`, or a list of them. */
#ifndef AOB_CONFIG_CONFIG_TARGET_H
#define AOB_CONFIG_CONFIG_TARGET_H
#include "config.h"
#include "yaml.h"

/* For aob_yaml_sequence; `user` is the struct aob_config. Adds one target; two equal ones are an error. */
bool aob_config_read_target(struct aob_yaml *yaml, yaml_node_t *node, void *user);
#endif
