#include "capture_job.h"
#include <stdint.h>
#include <string.h>
#include "base/json.h"

static json_t *names_to_json(const struct aob_convention *c)
{
    json_t *names = json_array();
    for (int m = 0; m < AOB_MATERIAL_CHANNELS; m++)
        json_array_append_new(names, json_string(c->material_channels[m]));
    return names;
}

json_t *aob_capture_job_to_json(const struct aob_capture_job *job)
{
    const struct aob_convention *c = &job->convention;
    return json_pack(
        "{s:s, s:s, s:o, s:i, s:b, s:i, s:b, s:o, s:o, s:o, s:s, s:s, s:f, s:f, s:o, s:o, s:b, s:o}", "job",
        "capture", "file", job->file, "out", aob_json_path(job->out), "depth", (int)c->depth, "depth_stated",
        c->depth_stated, "normals", (int)c->normals, "left_handed", c->left_handed, "near",
        aob_json_number(c->near), "far", aob_json_number(c->far), "up", aob_json_vector(c->up, 3),
        "depth_channel", c->depth_channel, "normal_channel", c->normal_channel, "fov_deg", job->fov_deg,
        "ortho_height", job->ortho_height, "eye",
        job->has_camera ? aob_json_vector(job->eye, 3) : json_null(), "target",
        job->has_camera ? aob_json_vector(job->target, 3) : json_null(), "no_materials", c->no_materials,
        "material_channels", names_to_json(c));
}

static bool read_materials(const json_t *object, struct aob_convention *c)
{
    const json_t *names = json_object_get(object, "material_channels");
    c->no_materials = json_is_true(json_object_get(object, "no_materials"));
    for (size_t m = 0; m < AOB_MATERIAL_CHANNELS; m++) {
        const char *name = json_string_value(json_array_get(names, m));
        if (!name || strlen(name) >= sizeof c->material_channels[m])
            return false;
        strcpy(c->material_channels[m], name);
    }
    return true;
}

static bool read_convention(const json_t *object, struct aob_convention *c)
{
    int depth, stated, normals, left;
    const char *depth_channel, *normal_channel;
    if (json_unpack((json_t *)(uintptr_t)object, "{s:i, s:b, s:i, s:b, s:s, s:s}", "depth", &depth,
                    "depth_stated", &stated, "normals", &normals, "left_handed", &left, "depth_channel",
                    &depth_channel, "normal_channel", &normal_channel) != 0 ||
        strlen(depth_channel) >= sizeof c->depth_channel ||
        strlen(normal_channel) >= sizeof c->normal_channel ||
        !aob_json_to_vector(json_object_get(object, "up"), c->up, 3))
        return false;
    c->depth = (unsigned)depth;
    c->depth_stated = stated;
    c->normals = (unsigned)normals;
    c->left_handed = left;
    c->near = aob_json_to_number(json_object_get(object, "near"));
    c->far = aob_json_to_number(json_object_get(object, "far"));
    strcpy(c->depth_channel, depth_channel);
    strcpy(c->normal_channel, normal_channel);
    return true;
}

bool aob_capture_job_from_json(const json_t *object, struct aob_capture_job *job, struct aob_error *error)
{
    *job =
        (struct aob_capture_job){.file = json_string_value(json_object_get(object, "file")),
                                 .out = json_string_value(json_object_get(object, "out")),
                                 .fov_deg = json_number_value(json_object_get(object, "fov_deg")),
                                 .ortho_height = json_number_value(json_object_get(object, "ortho_height"))};
    job->has_camera = aob_json_to_vector(json_object_get(object, "eye"), job->eye, 3) &&
                      aob_json_to_vector(json_object_get(object, "target"), job->target, 3);
    return (job->file && job->out && read_convention(object, &job->convention) &&
            read_materials(object, &job->convention)) ||
           aob_fail(error, "a capture job lacks a field");
}

json_t *aob_capture_answer_to_json(const struct aob_capture_answer *answer)
{
    return json_pack("{s:i, s:i, s:I, s:I, s:f, s:f, s:o, s:o, s:i, s:O?}", "width", answer->width, "height",
                     answer->height, "surface", (json_int_t)answer->surface, "derived",
                     (json_int_t)answer->derived, "fov_deg", answer->fov_deg, "ortho_height",
                     answer->ortho_height, "eye", aob_json_vector(answer->eye, 3), "target",
                     aob_json_vector(answer->target, 3), "materials", (int)answer->materials, "warnings",
                     (json_t *)(uintptr_t)answer->warnings);
}

bool aob_capture_answer_from_json(const json_t *object, struct aob_capture_answer *answer)
{
    *answer = (struct aob_capture_answer){
        .width = (int)json_integer_value(json_object_get(object, "width")),
        .height = (int)json_integer_value(json_object_get(object, "height")),
        .surface = (size_t)json_integer_value(json_object_get(object, "surface")),
        .derived = (size_t)json_integer_value(json_object_get(object, "derived")),
        .fov_deg = json_number_value(json_object_get(object, "fov_deg")),
        .ortho_height = json_number_value(json_object_get(object, "ortho_height")),
        .materials = (unsigned)json_integer_value(json_object_get(object, "materials")),
        .warnings = json_object_get(object, "warnings")};
    return answer->width > 0 && answer->height > 0 &&
           aob_json_to_vector(json_object_get(object, "eye"), answer->eye, 3) &&
           aob_json_to_vector(json_object_get(object, "target"), answer->target, 3);
}
