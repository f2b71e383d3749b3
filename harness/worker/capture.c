#include <string.h>
#include "base/json.h"
#include "gbuffer/capture.h"
#include "gbuffer/gbuffer.h"
#include "worker.h"

static bool get_convention(const json_t *job, struct aob_convention *c, struct aob_error *error)
{
    int depth, normals, left;
    const char *depth_channel, *normal_channel;
    if (json_unpack((json_t *)(uintptr_t)job, "{s:i, s:i, s:b, s:s, s:s}", "depth", &depth, "normals",
                    &normals, "left_handed", &left, "depth_channel", &depth_channel, "normal_channel",
                    &normal_channel) != 0 ||
        strlen(depth_channel) >= sizeof c->depth_channel ||
        strlen(normal_channel) >= sizeof c->normal_channel ||
        !aob_json_to_vector(json_object_get(job, "up"), c->up, 3))
        return aob_fail(error, "a capture job lacks a field");
    c->depth = (unsigned)depth;
    c->normals = (unsigned)normals;
    c->left_handed = left;
    c->near = aob_json_to_number(json_object_get(job, "near"));
    c->far = aob_json_to_number(json_object_get(job, "far"));
    strcpy(c->depth_channel, depth_channel);
    strcpy(c->normal_channel, normal_channel);
    return true;
}

static bool get_desc(const json_t *job, struct aob_capture_desc *desc, struct aob_error *error)
{
    double eye[3], target[3];
    desc->file = json_string_value(json_object_get(job, "file"));
    desc->fov_deg = json_number_value(json_object_get(job, "fov_deg"));
    desc->ortho_height = json_number_value(json_object_get(job, "ortho_height"));
    desc->has_camera = aob_json_to_vector(json_object_get(job, "eye"), eye, 3) &&
                       aob_json_to_vector(json_object_get(job, "target"), target, 3);
    if (desc->has_camera) {
        desc->eye = aob_vec(eye[0], eye[1], eye[2]);
        desc->target = aob_vec(target[0], target[1], target[2]);
    }
    return desc->file ? get_convention(job, &desc->convention, error)
                      : aob_fail(error, "a capture job needs a file");
}

static json_t *describe(const struct aob_capture *capture)
{
    const struct aob_camera *camera = &capture->camera;
    json_t *warnings = json_array();
    for (size_t i = 0; i < capture->warning_count; i++)
        json_array_append_new(warnings, json_string(capture->warnings[i].text));
    return json_pack("{s:i, s:i, s:I, s:I, s:f, s:f, s:[fff], s:[fff], s:o}", "width", capture->hits.width,
                     "height", capture->hits.height, "surface", (json_int_t)capture->surface, "derived",
                     (json_int_t)capture->derived, "fov_deg", camera->fov_deg, "ortho_height",
                     camera->ortho_height, "eye", camera->eye.x, camera->eye.y, camera->eye.z, "target",
                     camera->target.x, camera->target.y, camera->target.z, "warnings", warnings);
}

bool aob_worker_capture(struct aob_worker *worker, struct aob_error *error)
{
    struct aob_capture_desc desc = {0};
    struct aob_capture capture;
    const char *out = json_string_value(json_object_get(worker->job, "out"));
    if (!out)
        return aob_fail(error, "a capture job needs out");
    if (!get_desc(worker->job, &desc, error) || !aob_capture_read(&capture, &desc, error))
        return false;
    bool ok = aob_gbuffer_store(&capture.hits, &(struct aob_mesh){0}, out, error);
    if (ok)
        aob_worker_reply(worker, describe(&capture));
    aob_capture_finish(&capture);
    return ok;
}
