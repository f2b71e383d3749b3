#include "poses.h"
#include "base/json.h"
#include "base/memory.h"
#include "scene/camera_json.h"

json_t *aob_poses_to_json(const struct aob_job_pose *poses, size_t count, size_t target_count)
{
    json_t *array = json_array();
    for (size_t i = 0; i < count; i++) {
        const struct aob_job_pose *pose = &poses[i];
        json_t *truths = json_array();
        for (size_t t = 0; t < target_count; t++)
            json_array_append_new(truths, aob_json_path(pose->truth[t]));
        json_array_append_new(array, json_pack("{s:o, s:i, s:i, s:o, s:o}", "camera",
                                               aob_camera_to_json(&pose->camera), "frame", pose->frame,
                                               "seed", (int)pose->seed, "gbuffer",
                                               aob_json_path(pose->gbuffer), "truth", truths));
    }
    return array;
}

static bool read_pose(const json_t *object, size_t target_count, struct aob_job_pose *pose,
                      struct aob_error *error)
{
    const json_t *truths = json_object_get(object, "truth");
    *pose = (struct aob_job_pose){.frame = (int)json_integer_value(json_object_get(object, "frame")),
                                  .seed = (unsigned)json_integer_value(json_object_get(object, "seed")),
                                  .gbuffer = json_string_value(json_object_get(object, "gbuffer"))};
    if (!pose->gbuffer || target_count > AOB_CONFIG_MAX_TARGETS || json_array_size(truths) != target_count)
        return aob_fail(error, "a pose of a job lacks its G-buffer or its truths");
    for (size_t t = 0; t < target_count; t++)
        pose->truth[t] = json_string_value(json_array_get(truths, t));
    return aob_camera_from_json(json_object_get(object, "camera"), &pose->camera, error);
}

bool aob_poses_from_json(const json_t *array, size_t target_count, struct aob_job_pose **poses, size_t *count,
                         struct aob_error *error)
{
    *count = json_array_size(array);
    *poses = AOB_NEW_ARRAY(struct aob_job_pose, *count);
    for (size_t i = 0; i < *count; i++)
        if (!read_pose(json_array_get(array, i), target_count, &(*poses)[i], error))
            return false;
    return *count < AOB_CONFIG_MAX_FRAMES ||
           aob_fail(error, "a job has %zu poses: there must be less than %d", *count, AOB_CONFIG_MAX_FRAMES);
}
