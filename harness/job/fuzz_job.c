#include "fuzz_job.h"
#include <string.h>
#include "base/json.h"
#include "base/memory.h"

json_t *aob_fuzz_job_to_json(const struct aob_fuzz_job *job)
{
    return json_pack("{s:s, s:o, s:s, s:s?, s:b, s:I, s:I, s:I, s:I, s:o}", "job", "fuzz", "technique",
                     aob_address_to_json(&job->technique), "backend", job->backend, "device", job->device,
                     "validate", job->validate, "seed", (json_int_t)job->seed, "from", (json_int_t)job->from,
                     "count", (json_int_t)job->count, "known", (json_int_t)job->known, "images",
                     aob_json_path(job->images));
}

static uint64_t number(const json_t *object, const char *key)
{
    return (uint64_t)json_integer_value(json_object_get(object, key));
}

bool aob_fuzz_job_from_json(const json_t *object, struct aob_fuzz_job *job, struct aob_error *error)
{
    *job = (struct aob_fuzz_job){.backend = json_string_value(json_object_get(object, "backend")),
                                 .device = json_string_value(json_object_get(object, "device")),
                                 .validate = json_is_true(json_object_get(object, "validate")),
                                 .seed = number(object, "seed"),
                                 .from = number(object, "from"),
                                 .count = number(object, "count"),
                                 .known = (uint32_t)number(object, "known"),
                                 .images = json_string_value(json_object_get(object, "images"))};
    if (!job->backend)
        return aob_fail(error, "a fuzz job has no backend");
    return aob_address_from_json(json_object_get(object, "technique"), &job->technique, error);
}

static const char *const message_words[] = {"opened", "begun", "refuses", "found"};

json_t *aob_fuzz_answer_to_json(const struct aob_fuzz_answer *answer)
{
    json_t *object = json_pack("{s:s, s:I}", "message", message_words[answer->message], "index",
                               (json_int_t)answer->index);
    if (answer->message == AOB_FUZZ_OPENED) {
        json_object_set_new(object, "device", aob_json_text(answer->device));
        json_object_set_new(object, "driver", aob_json_text(answer->driver));
    }
    if (answer->message != AOB_FUZZ_FOUND)
        return object;
    json_object_set_new(object, "fault", json_string(answer->fault));
    json_object_set_new(object, "sentence", aob_json_text(answer->sentence));
    json_object_set_new(object, "hostile", json_boolean(answer->hostile));
    if (answer->smallest)
        json_object_set_new(object, "smallest", answer->smallest);
    return object;
}

bool aob_fuzz_answer_from_json(const json_t *object, struct aob_fuzz_answer *answer)
{
    const char *message = json_string_value(json_object_get(object, "message"));
    *answer = (struct aob_fuzz_answer){.device = json_string_value(json_object_get(object, "device")),
                                       .driver = json_string_value(json_object_get(object, "driver")),
                                       .index = number(object, "index"),
                                       .fault = json_string_value(json_object_get(object, "fault")),
                                       .sentence = json_string_value(json_object_get(object, "sentence")),
                                       .hostile = json_is_true(json_object_get(object, "hostile")),
                                       .smallest = json_object_get(object, "smallest")};
    for (size_t i = 0; message && i < AOB_COUNT(message_words); i++)
        if (strcmp(message, message_words[i]) == 0) {
            answer->message = (enum aob_fuzz_message)i;
            return answer->message == AOB_FUZZ_OPENED  ? answer->device && answer->driver
                   : answer->message == AOB_FUZZ_FOUND ? answer->fault && answer->sentence
                                                       : json_object_get(object, "index") != NULL;
        }
    return false;
}
