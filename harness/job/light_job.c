#include "light_job.h"
#include "base/json.h"
#include "scene/light_json.h"

json_t *aob_light_job_to_json(const char *file)
{
    return json_pack("{s:s, s:s}", "job", "light", "file", file);
}

bool aob_light_job_from_json(const json_t *object, const char **file, struct aob_error *error)
{
    *file = json_string_value(json_object_get(object, "file"));
    return *file || aob_fail(error, "a light job has no file");
}

json_t *aob_light_answer_to_json(const struct aob_light_projection *answer)
{
    return json_pack("{s:o, s:f, s:o}", "light", aob_light_to_json(&answer->light), "held", answer->held,
                     "factors", aob_json_vector(answer->factors, 2));
}

bool aob_light_answer_from_json(const json_t *object, struct aob_light_projection *answer)
{
    answer->held = aob_json_to_number(json_object_get(object, "held"));
    return aob_light_from_json(json_object_get(object, "light"), &answer->light) &&
           aob_json_to_vector(json_object_get(object, "factors"), answer->factors, 2);
}
