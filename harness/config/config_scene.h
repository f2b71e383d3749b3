/* The `scenes` list of a config: one entry, as the choices of its views. */
#ifndef AOB_CONFIG_CONFIG_SCENE_H
#define AOB_CONFIG_CONFIG_SCENE_H
#include "config.h"
#include "yaml.h"

/* For aob_yaml_sequence; `user` is the struct aob_config. Adds one choice a view, or one without a view. */
bool aob_config_read_scene(struct aob_yaml *yaml, yaml_node_t *node, void *user);
#endif
