#include "layout_job.h"
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"

static const char thrift[] = "thrift";

static json_t *wanted_to_json(unsigned wanted)
{
    json_t *names = aob_outputs_to_json(wanted);
    if (wanted & AOB_WANT_THRIFT)
        json_array_append_new(names, json_string(thrift));
    return names;
}

static unsigned wanted_from_json(const json_t *names)
{
    unsigned wanted = aob_outputs_from_json(names);
    json_t *name;
    size_t at;
    json_array_foreach(names, at, name)
    {
        if (json_is_string(name) && strcmp(json_string_value(name), thrift) == 0)
            wanted |= AOB_WANT_THRIFT;
    }
    return wanted;
}

json_t *aob_layout_job_to_json(const struct aob_layout_job *job)
{
    json_t *cases = json_array();
    for (size_t i = 0; i < job->case_count; i++)
        json_array_append_new(cases,
                              json_pack("{s:o, s:o}", "params",
                                        aob_json_vector(job->params + i * job->param_count, job->param_count),
                                        "wanted", wanted_to_json(job->wanted[i])));
    return json_pack("{s:s, s:o, s:o}", "job", "layout", "technique", aob_address_to_json(&job->technique),
                     "cases", cases);
}

bool aob_layout_job_from_json(const json_t *object, struct aob_layout_job *job, struct aob_error *error)
{
    const json_t *cases = json_object_get(object, "cases");
    const json_t *first = json_object_get(json_array_get(cases, 0), "params");
    *job =
        (struct aob_layout_job){.case_count = json_array_size(cases), .param_count = json_array_size(first)};
    if (!aob_address_from_json(json_object_get(object, "technique"), &job->technique, error))
        return false;
    job->params = AOB_NEW_ARRAY(double, job->case_count * job->param_count);
    job->wanted = AOB_NEW_ARRAY(unsigned, job->case_count);
    for (size_t i = 0; i < job->case_count; i++) {
        const json_t *c = json_array_get(cases, i), *wanted = json_object_get(c, "wanted");
        if (!json_is_array(wanted) ||
            !aob_json_to_vector(json_object_get(c, "params"), job->params + i * job->param_count,
                                job->param_count)) {
            aob_layout_job_finish(job);
            return aob_fail(error, "case %zu of a layout job has not %zu numbers and the outputs it wants", i,
                            job->param_count);
        }
        job->wanted[i] = wanted_from_json(wanted);
    }
    return true;
}

void aob_layout_job_finish(struct aob_layout_job *job)
{
    free(job->params);
    free(job->wanted);
    *job = (struct aob_layout_job){0};
}

json_t *aob_outputs_to_json(unsigned outputs)
{
    json_t *names = json_array();
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
        if (outputs >> which & 1)
            json_array_append_new(names, json_string(aob_output_name((enum aob_output)which)));
    return names;
}

unsigned aob_outputs_from_json(const json_t *names)
{
    unsigned outputs = 0;
    json_t *name;
    size_t at;
    json_array_foreach(names, at, name)
    {
        for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
            if (json_is_string(name) &&
                strcmp(json_string_value(name), aob_output_name((enum aob_output)which)) == 0)
                outputs |= 1u << which;
    }
    return outputs;
}

json_t *aob_layout_answer_to_json(const struct aob_layout_answer *answer)
{
    return json_pack("{s:s, s:s?, s:s?, s:s?, s:o, s:b, s:O?, s:b}", "status", answer->status, "reason",
                     answer->reason, "graph", answer->graph, "dot", answer->dot, "outputs",
                     aob_outputs_to_json(answer->outputs), "triangles", answer->triangles, "definition",
                     (json_t *)(uintptr_t)answer->definition, "mapped", answer->mapped);
}

bool aob_layout_answer_from_json(const json_t *object, struct aob_layout_answer *answer)
{
    const json_t *definition = json_object_get(object, "definition");
    *answer = (struct aob_layout_answer){.status = json_string_value(json_object_get(object, "status")),
                                         .reason = json_string_value(json_object_get(object, "reason")),
                                         .graph = json_string_value(json_object_get(object, "graph")),
                                         .dot = json_string_value(json_object_get(object, "dot")),
                                         .outputs = aob_outputs_from_json(json_object_get(object, "outputs")),
                                         .triangles = json_is_true(json_object_get(object, "triangles")),
                                         .definition = json_is_object(definition) ? definition : NULL,
                                         .mapped = json_is_true(json_object_get(object, "mapped"))};
    return answer->status != NULL;
}
