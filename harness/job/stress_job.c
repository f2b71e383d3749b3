#include "stress_job.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/json.h"
#include "base/memory.h"

json_t *aob_stress_job_to_json(const struct aob_stress_job *job)
{
    json_t *names = json_array();
    for (size_t i = 0; i < job->property_count; i++)
        json_array_append_new(names, json_string(job->properties[i]));
    json_t *object = json_pack("{s:s, s:s?, s:s?, s:b, s:b, s:o, s:o}", "job", "stress", "backend",
                               job->backend, "device", job->device, "validate", job->validate, "quick",
                               job->quick, "properties", names, "images", aob_json_path(job->images));
    if (job->technique.technique)
        json_object_set_new(object, "technique", aob_address_to_json(&job->technique));
    return object;
}

bool aob_stress_job_from_json(const json_t *object, struct aob_stress_job *job, struct aob_error *error)
{
    const json_t *names = json_object_get(object, "properties"),
                 *technique = json_object_get(object, "technique");
    *job = (struct aob_stress_job){.backend = json_string_value(json_object_get(object, "backend")),
                                   .device = json_string_value(json_object_get(object, "device")),
                                   .validate = json_is_true(json_object_get(object, "validate")),
                                   .quick = json_is_true(json_object_get(object, "quick")),
                                   .images = json_string_value(json_object_get(object, "images")),
                                   .property_count = json_array_size(names)};
    if (technique && !aob_address_from_json(technique, &job->technique, error))
        return false;
    if (technique && !job->backend)
        return aob_fail(error, "a stress job of a technique has no backend");
    job->properties = AOB_NEW_ARRAY(const char *, job->property_count + 1);
    for (size_t i = 0; i < job->property_count; i++) {
        job->properties[i] = json_string_value(json_array_get(names, i));
        if (job->properties[i])
            continue;
        aob_stress_job_finish(job);
        return aob_fail(error, "property %zu of a stress job is no name", i);
    }
    return true;
}

void aob_stress_job_finish(struct aob_stress_job *job)
{
    free(job->properties);
    *job = (struct aob_stress_job){.property_count = 0};
}

static const char *const message_words[] = {"opened", "begun", "answered"};

json_t *aob_stress_answer_to_json(const struct aob_stress_answer *answer)
{
    json_t *object = json_pack("{s:s}", "message", message_words[answer->message]);
    if (answer->message == AOB_STRESS_OPENED) {
        json_object_set_new(object, "device", aob_json_text(answer->device));
        json_object_set_new(object, "driver", aob_json_text(answer->driver));
        return object;
    }
    json_object_set_new(object, "property", json_string(answer->property));
    if (answer->message == AOB_STRESS_BEGUN)
        return object;
    json_object_set_new(object, "outcome", json_string(answer->outcome));
    json_object_set_new(object, "worst", aob_json_number(answer->worst));
    json_object_set_new(object, "bound", aob_json_number(answer->bound));
    json_object_set_new(object, "declared", json_boolean(answer->declared));
    json_object_set_new(object, "where", aob_json_text(answer->where ? answer->where : ""));
    json_object_set_new(object, "reason", aob_json_text(answer->reason));
    if (answer->image) {
        json_object_set_new(object, "image", json_string(answer->image));
        json_object_set_new(object, "compared", json_boolean(answer->compared));
    }
    return object;
}

bool aob_stress_answer_from_json(const json_t *object, struct aob_stress_answer *answer)
{
    const char *message = json_string_value(json_object_get(object, "message"));
    *answer = (struct aob_stress_answer){.device = json_string_value(json_object_get(object, "device")),
                                         .driver = json_string_value(json_object_get(object, "driver")),
                                         .property = json_string_value(json_object_get(object, "property")),
                                         .outcome = json_string_value(json_object_get(object, "outcome")),
                                         .worst = aob_json_to_number(json_object_get(object, "worst")),
                                         .bound = aob_json_to_number(json_object_get(object, "bound")),
                                         .declared = json_is_true(json_object_get(object, "declared")),
                                         .where = json_string_value(json_object_get(object, "where")),
                                         .reason = json_string_value(json_object_get(object, "reason")),
                                         .image = json_string_value(json_object_get(object, "image")),
                                         .compared = json_is_true(json_object_get(object, "compared"))};
    for (size_t i = 0; message && i < AOB_COUNT(message_words); i++)
        if (strcmp(message, message_words[i]) == 0) {
            answer->message = (enum aob_stress_message)i;
            return i == AOB_STRESS_OPENED ? answer->device && answer->driver
                                          : answer->property && (i == AOB_STRESS_BEGUN || answer->outcome);
        }
    return false;
}
