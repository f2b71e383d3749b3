#include "gbuffer/capture.h"
#include "base/json.h"
#include "gbuffer/gbuffer.h"
#include "job/capture_job.h"
#include "worker.h"

static void set_vector(double into[3], struct aob_vec3 from)
{
    into[0] = from.x;
    into[1] = from.y;
    into[2] = from.z;
}

static json_t *describe(const struct aob_capture *capture)
{
    const struct aob_camera *camera = &capture->camera;
    struct aob_capture_answer answer = {.width = capture->hits.width,
                                        .height = capture->hits.height,
                                        .surface = capture->surface,
                                        .derived = capture->derived,
                                        .fov_deg = camera->fov_deg,
                                        .ortho_height = camera->ortho_height,
                                        .materials = capture->materials};
    set_vector(answer.eye, camera->eye);
    set_vector(answer.target, camera->target);
    json_t *warnings = json_array();
    for (size_t i = 0; i < capture->warning_count; i++)
        json_array_append_new(warnings, json_string(capture->warnings[i].text));
    answer.warnings = warnings;
    json_t *object = aob_capture_answer_to_json(&answer);
    json_decref(warnings);
    return object;
}

static bool read_capture(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_capture_job job;
    struct aob_capture capture;
    if (!aob_capture_job_from_json(worker->job, &job, error))
        return false;
    struct aob_capture_desc desc = {.file = job.file,
                                    .convention = job.convention,
                                    .fov_deg = job.fov_deg,
                                    .ortho_height = job.ortho_height,
                                    .has_camera = job.has_camera,
                                    .eye = aob_vec(job.eye[0], job.eye[1], job.eye[2]),
                                    .target = aob_vec(job.target[0], job.target[1], job.target[2])};
    if (!aob_capture_read(&capture, &desc, error))
        return false;
    bool ok = aob_gbuffer_store_capture(&capture.hits, capture.albedo, capture.shine, job.out, error);
    if (ok)
        aob_worker_reply(worker, describe(&capture));
    aob_capture_finish(&capture);
    return ok;
}

const struct aob_worker_job aob_worker_capture = {"capture", read_capture};
