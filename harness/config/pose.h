/* Where a camera stands and looks, as a mapping of its own: {eye: [x, y, z], target: [x, y, z]}. */
#ifndef AOB_CONFIG_POSE_H
#define AOB_CONFIG_POSE_H
#include "yaml.h"

/* Both keys are needed. */
bool aob_pose_read(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_pose *pose);
#endif
