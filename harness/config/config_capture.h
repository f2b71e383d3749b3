/* For config.c: the part of a scene's entry that only a captured frame has. */
#ifndef AOB_CONFIG_CONFIG_CAPTURE_H
#define AOB_CONFIG_CONFIG_CAPTURE_H
#include "config.h"
#include "yaml.h"

/* A key of aob_convention_keys? Then *at is its number. */
bool aob_config_is_convention(const char *key, enum aob_convention_key *at);
bool aob_config_read_convention(struct aob_yaml *yaml, const yaml_node_t *node, enum aob_convention_key key,
                                struct aob_convention *convention);

/* "capture:FILE" as a name becomes the capture FILE. */
void aob_config_take_capture(struct aob_scene_choice *choice);
bool aob_config_judge_capture(struct aob_yaml *yaml, const yaml_node_t *node,
                              const struct aob_scene_choice *choice);
#endif
