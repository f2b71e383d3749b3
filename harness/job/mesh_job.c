#include "mesh_job.h"
#include <stdint.h>
#include "base/json.h"

json_t *aob_mesh_job_to_json(const struct aob_mesh_job *job)
{
    return json_pack("{s:s, s:s, s:o}", "job", "mesh", "file", job->file, "out", aob_json_path(job->out));
}

bool aob_mesh_job_from_json(const json_t *object, struct aob_mesh_job *job, struct aob_error *error)
{
    *job = (struct aob_mesh_job){json_string_value(json_object_get(object, "file")),
                                 json_string_value(json_object_get(object, "out"))};
    return (job->file && job->out) || aob_fail(error, "a mesh job needs file and out");
}

json_t *aob_mesh_answer_to_json(const struct aob_mesh_answer *answer)
{
    struct aob_vec3 low = answer->low, high = answer->high;
    return json_pack("{s:[fff], s:[fff], s:I, s:I, s:O?}", "low", low.x, low.y, low.z, "high", high.x, high.y,
                     high.z, "vertices", (json_int_t)answer->vertices, "triangles",
                     (json_int_t)answer->triangles, "warnings", (json_t *)(uintptr_t)answer->warnings);
}

bool aob_mesh_answer_from_json(const json_t *object, struct aob_mesh_answer *answer)
{
    double low[3], high[3];
    if (!aob_json_to_vector(json_object_get(object, "low"), low, 3) ||
        !aob_json_to_vector(json_object_get(object, "high"), high, 3))
        return false;
    *answer = (struct aob_mesh_answer){
        .low = aob_vec(low[0], low[1], low[2]),
        .high = aob_vec(high[0], high[1], high[2]),
        .vertices = (size_t)json_integer_value(json_object_get(object, "vertices")),
        .triangles = (size_t)json_integer_value(json_object_get(object, "triangles")),
        .warnings = json_object_get(object, "warnings")};
    return true;
}
