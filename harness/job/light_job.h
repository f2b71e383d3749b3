/* The job `light`: read a light probe into nine coefficients. Texts are borrowed from the JSON that they were read from. */
#ifndef AOB_JOB_LIGHT_JOB_H
#define AOB_JOB_LIGHT_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "scene/light.h"

json_t *aob_light_job_to_json(const char *file);
bool aob_light_job_from_json(const json_t *object, const char **file, struct aob_error *error);

json_t *aob_light_answer_to_json(const struct aob_light_projection *answer);
bool aob_light_answer_from_json(const json_t *object,
                                struct aob_light_projection *answer); /* false: of another form */
#endif
