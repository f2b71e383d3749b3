#include "drawing_job.h"
#include <stdint.h>
#include "base/json.h"

void aob_job_drawing_to_json(const struct aob_job_drawing *drawing, json_t *job)
{
    json_t *members =
        json_pack("{s:s, s:s?, s:b, s:b, s:b}", "backend", drawing->backend, "device", drawing->device,
                  "validate", drawing->validate, "raster", drawing->raster, "triangles", drawing->triangles);
    json_object_update(job, members);
    json_decref(members);
    aob_job_view_to_json(&drawing->view, job);
}

bool aob_job_drawing_from_json(const json_t *job, struct aob_job_drawing *drawing, struct aob_error *error)
{
    int validate, raster, triangles;
    *drawing = (struct aob_job_drawing){0};
    if (json_unpack((json_t *)(uintptr_t)job, "{s:s, s:b, s:b, s:b}", "backend", &drawing->backend,
                    "validate", &validate, "raster", &raster, "triangles", &triangles) != 0)
        return aob_fail(error, "a job lacks what says on which device it draws");
    drawing->device = json_string_value(json_object_get(job, "device"));
    drawing->validate = validate;
    drawing->raster = raster;
    drawing->triangles = triangles;
    return aob_job_view_from_json(job, &drawing->view, error);
}

void aob_job_frame_to_json(const struct aob_job_frame *frame, json_t *object)
{
    json_object_set_new(object, "technique", aob_address_to_json(&frame->technique));
    json_object_set_new(object, "params", aob_json_vector(frame->params, frame->param_count));
    json_object_set_new(object, "options", aob_json_vector(frame->options, AOB_OPTION_COUNT));
}

bool aob_job_frame_from_json(const json_t *object, struct aob_job_frame *frame, struct aob_error *error)
{
    const json_t *params = json_object_get(object, "params");
    *frame = (struct aob_job_frame){.param_count = json_array_size(params)};
    if (!aob_address_from_json(json_object_get(object, "technique"), &frame->technique, error))
        return false;
    if (frame->param_count > AOB_MAX_PARAM || !aob_json_to_vector(params, frame->params, frame->param_count))
        return aob_fail(error, "a job's case has no technique with its parameters");
    return aob_json_to_vector(json_object_get(object, "options"), frame->options, AOB_OPTION_COUNT) ||
           aob_fail(error, "a job's case has not %d options", AOB_OPTION_COUNT);
}
