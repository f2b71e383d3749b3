/* A camera as JSON, as it stands in records, in `list scenes` and in messages between processes: {eye, target, fov_deg,
 * ortho_height, shift, previous: {eye, target} or null}. Lengths in scene units. */
#ifndef AOB_SCENE_CAMERA_JSON_H
#define AOB_SCENE_CAMERA_JSON_H
#include <jansson.h>
#include "base/error.h"
#include "camera.h"

json_t *aob_camera_to_json(const struct aob_camera *camera); /* a new object */

/* False with a line if the object lacks a field or is no camera that could be used (aob_camera_check). */
bool aob_camera_from_json(const json_t *object, struct aob_camera *camera, struct aob_error *error);
#endif
