/* The job `stress`: one technique on one backend, or the program's own instruments, put to properties. The answers say which
 * property is begun, and then what came of it, so that who dies is known. Texts are borrowed from the JSON that they were
 * read from. */
#ifndef AOB_JOB_STRESS_JOB_H
#define AOB_JOB_STRESS_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "address.h"
#include "base/error.h"

struct aob_stress_job {
    struct aob_address technique; /* its name NULL: the instruments, which need no backend */
    const char *backend, *device; /* device NULL: the backend's default */
    bool validate, quick;
    const char **properties; /* names, property_count; allocated by aob_stress_job_from_json */
    size_t property_count;
    const char *images; /* folder for the pictures of what fails; NULL: none */
};
json_t *aob_stress_job_to_json(const struct aob_stress_job *job);

/* False with a line for what is missing. aob_stress_job_finish frees. */
bool aob_stress_job_from_json(const json_t *object, struct aob_stress_job *job, struct aob_error *error);
void aob_stress_job_finish(struct aob_stress_job *job);

enum aob_stress_message { AOB_STRESS_OPENED, AOB_STRESS_BEGUN, AOB_STRESS_ANSWERED };
struct aob_stress_answer {
    enum aob_stress_message message;
    const char *device, *driver; /* of AOB_STRESS_OPENED */
    const char *property;        /* of the other two; the rest is of AOB_STRESS_ANSWERED */
    const char *outcome;         /* aob_outcome_word */
    double worst, bound;         /* NAN: not applicable, or what is no number */
    bool declared;
    const char *where;          /* it is worst; may be empty */
    const char *reason, *image; /* image: file in `images`; NULL: none */
    bool compared;              /* the image has what it was compared with beside it */
};
json_t *aob_stress_answer_to_json(const struct aob_stress_answer *answer);
bool aob_stress_answer_from_json(const json_t *object,
                                 struct aob_stress_answer *answer); /* false: it is none */
#endif
