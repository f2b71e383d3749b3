/* The frames of a sequence before its last, as the jobs `block` and `cache` have them. Texts are borrowed from the JSON that they were
 * read from. */
#ifndef AOB_JOB_POSES_H
#define AOB_JOB_POSES_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "config/config.h"
#include "scene/camera.h"

struct aob_job_pose { /* a frame before the last, which is the drawing's view */
    struct aob_camera camera;
    int frame;     /* as of a view; */
    unsigned seed; /* likewise */
    const char *gbuffer;
    const char *truth[AOB_CONFIG_MAX_TARGETS]; /* of each target: of the visibility, channels AO and SE */
};
json_t *aob_poses_to_json(const struct aob_job_pose *poses, size_t count,
                          size_t target_count); /* a new array */

/* free(*poses), after a refusal as well. False with a line for what is missing or out of bounds. */
bool aob_poses_from_json(const json_t *array, size_t target_count, struct aob_job_pose **poses, size_t *count,
                         struct aob_error *error);
#endif
