/* The motion of a scene entry: {frames: N}, or {frames: N, eye: [x, y, z], target: [x, y, z]} with the place that the camera
 * reaches in the last frame. */
#ifndef AOB_CONFIG_MOTION_CHOICE_H
#define AOB_CONFIG_MOTION_CHOICE_H
#include "yaml.h"

bool aob_motion_choice_read(struct aob_yaml *yaml, const yaml_node_t *node, struct aob_motion_choice *motion);

/* Whether an entry with a motion may have it: it is a scene's or a mesh's with a camera, which has no previous place. */
bool aob_motion_choice_judge(const struct aob_yaml *yaml, const yaml_node_t *node,
                             const struct aob_scene_choice *choice);
#endif
