#include "check_job.h"
#include "base/json.h"

json_t *aob_check_job_to_json(const struct aob_check_job *job)
{
    json_t *object = json_pack("{s:s, s:o}", "job", "check", "radius", aob_json_number(job->radius));
    aob_job_view_to_json(&job->view, object);
    return object;
}

bool aob_check_job_from_json(const json_t *object, struct aob_check_job *job, struct aob_error *error)
{
    *job = (struct aob_check_job){.radius = aob_json_to_number(json_object_get(object, "radius"))};
    return aob_job_view_from_json(object, &job->view, error) &&
           (job->radius > 0 || aob_fail(error, "a check job needs a radius"));
}

json_t *aob_check_answer_to_json(const struct aob_check_answer *answer)
{
    return json_pack("{s:I, s:I, s:f}", "triangles", (json_int_t)answer->triangles, "doubled",
                     (json_int_t)answer->doubled, "backs", answer->backs);
}

bool aob_check_answer_from_json(const json_t *object, struct aob_check_answer *answer)
{
    *answer = (struct aob_check_answer){
        .triangles = (size_t)json_integer_value(json_object_get(object, "triangles")),
        .doubled = (size_t)json_integer_value(json_object_get(object, "doubled")),
        .backs = aob_json_to_number(json_object_get(object, "backs"))};
    return answer->triangles && answer->backs >= 0;
}
