#include "cache_job.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"

json_t *aob_cache_job_to_json(const struct aob_cache_job *job)
{
    json_t *profiles = json_array();
    for (size_t i = 0; i < job->profile_count; i++)
        json_array_append_new(profiles, json_pack("{s:o, s:s}", "path", aob_json_path(job->profiles[i].path),
                                                  "digest", job->profiles[i].digest));
    json_t *object =
        json_pack("{s:s, s:o, s:o}", "job", "cache", "profiles", profiles, "map", aob_json_path(job->map));
    json_object_set_new(object, "poses", aob_poses_to_json(job->poses, job->pose_count, 0));
    aob_job_drawing_to_json(&job->drawing, object);
    aob_job_frame_to_json(&job->frame, object);
    return object;
}

static bool read_profiles(const json_t *array, struct aob_cache_job *job, struct aob_error *error)
{
    job->profiles = AOB_NEW_ARRAY(struct aob_cache_profile, json_array_size(array));
    for (size_t i = 0; i < json_array_size(array); i++) {
        struct aob_cache_profile *profile = &job->profiles[job->profile_count++];
        if (json_unpack(json_array_get(array, i), "{s:s, s:s}", "path", &profile->path, "digest",
                        &profile->digest) != 0)
            return aob_fail(error, "profile %zu of a cache job has no path with its digest", i);
    }
    return job->profile_count || aob_fail(error, "a cache job has no profile");
}

bool aob_cache_job_from_json(const json_t *object, struct aob_cache_job *job, struct aob_error *error)
{
    *job = (struct aob_cache_job){.map = json_string_value(json_object_get(object, "map"))};
    if (aob_job_drawing_from_json(object, &job->drawing, error) &&
        aob_job_frame_from_json(object, &job->frame, error) &&
        read_profiles(json_object_get(object, "profiles"), job, error) &&
        aob_poses_from_json(json_object_get(object, "poses"), 0, &job->poses, &job->pose_count, error))
        return true;
    aob_cache_job_finish(job);
    return false;
}

void aob_cache_job_finish(struct aob_cache_job *job)
{
    free(job->profiles);
    free(job->poses);
    *job = (struct aob_cache_job){0};
}

json_t *aob_cache_capture_to_json(const struct aob_cache_capture *capture)
{
    return json_pack("{s:{s:f, s:f, s:f}}", "capture", "words", capture->words, "strips", capture->strips,
                     "seconds", capture->seconds);
}

bool aob_cache_capture_from_json(const json_t *object, struct aob_cache_capture *capture)
{
    const json_t *c = json_object_get(object, "capture");
    *capture = (struct aob_cache_capture){aob_json_to_number(json_object_get(c, "words")),
                                          aob_json_to_number(json_object_get(c, "strips")),
                                          aob_json_to_number(json_object_get(c, "seconds"))};
    return json_is_object(c);
}

json_t *aob_cache_answer_to_json(const struct aob_cache_answer *answer)
{
    return json_pack("{s:I, s:s, s:s?, s:O?}", "profile", (json_int_t)answer->profile, "status",
                     answer->status, "reason", answer->reason, "figures", answer->figures);
}

bool aob_cache_answer_from_json(const json_t *object, struct aob_cache_answer *answer)
{
    const json_t *profile = json_object_get(object, "profile"), *figures = json_object_get(object, "figures");
    *answer = (struct aob_cache_answer){.profile = (size_t)json_integer_value(profile),
                                        .status = json_string_value(json_object_get(object, "status")),
                                        .reason = json_string_value(json_object_get(object, "reason")),
                                        .figures = json_is_object(figures) ? figures : NULL};
    return json_is_integer(profile) && answer->status &&
           !answer->figures == (strcmp(answer->status, "ok") != 0);
}
