#include "camera_json.h"
#include "base/json.h"

static json_t *pose_to_json(struct aob_vec3 eye, struct aob_vec3 target)
{
    return json_pack("{s:[fff], s:[fff]}", "eye", eye.x, eye.y, eye.z, "target", target.x, target.y,
                     target.z);
}

json_t *aob_camera_to_json(const struct aob_camera *camera)
{
    json_t *json = pose_to_json(camera->eye, camera->target);
    json_object_set_new(json, "fov_deg", json_real(camera->fov_deg));
    json_object_set_new(json, "ortho_height", json_real(camera->ortho_height));
    json_object_set_new(json, "shift", aob_json_vector(camera->shift, 2));
    json_object_set_new(json, "previous",
                        camera->moves ? pose_to_json(camera->previous_eye, camera->previous_target)
                                      : json_null());
    return json;
}

static bool pose_from_json(const json_t *object, struct aob_vec3 *eye, struct aob_vec3 *target)
{
    double e[3], t[3];
    if (!aob_json_to_vector(json_object_get(object, "eye"), e, 3) ||
        !aob_json_to_vector(json_object_get(object, "target"), t, 3))
        return false;
    *eye = aob_vec(e[0], e[1], e[2]);
    *target = aob_vec(t[0], t[1], t[2]);
    return true;
}

bool aob_camera_from_json(const json_t *object, struct aob_camera *camera, struct aob_error *error)
{
    const json_t *previous = json_object_get(object, "previous");
    *camera = (struct aob_camera){.moves = json_is_object(previous)};
    if (!pose_from_json(object, &camera->eye, &camera->target) ||
        !aob_json_to_vector(json_object_get(object, "shift"), camera->shift, 2) ||
        (camera->moves && !pose_from_json(previous, &camera->previous_eye, &camera->previous_target)))
        return aob_fail(error, "a camera lacks eye, target or shift");
    camera->fov_deg = json_number_value(json_object_get(object, "fov_deg"));
    camera->ortho_height = json_number_value(json_object_get(object, "ortho_height"));
    return aob_camera_check(camera, error);
}
