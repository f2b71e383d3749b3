/* The job `fuzz`: frames of one technique on one backend, drawn by lot (stress/fuzz_frame.h). The answers say which frame is
 * begun, so that the one that kills its worker is known. Texts are borrowed from the JSON that they were read from. */
#ifndef AOB_JOB_FUZZ_JOB_H
#define AOB_JOB_FUZZ_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include "address.h"
#include "base/error.h"

struct aob_fuzz_job {
    struct aob_address technique;
    const char *backend, *device; /* device NULL: the backend's default */
    bool validate;
    uint64_t seed, from, count; /* all below 2^63 */
    uint32_t known;             /* bits 2 * fault + hostile: those are counted, and not made smaller */
    const char *images;         /* folder for the smallest frames; NULL: none */
};
json_t *aob_fuzz_job_to_json(const struct aob_fuzz_job *job);
bool aob_fuzz_job_from_json(const json_t *object, struct aob_fuzz_job *job,
                            struct aob_error *error); /* false with a line for what is missing */

enum aob_fuzz_message { AOB_FUZZ_OPENED, AOB_FUZZ_BEGUN, AOB_FUZZ_REFUSES, AOB_FUZZ_FOUND };
struct aob_fuzz_answer {
    enum aob_fuzz_message message;
    const char *device, *driver; /* of AOB_FUZZ_OPENED */
    uint64_t index;              /* of the others; the rest is of AOB_FUZZ_FOUND */
    const char *fault;           /* aob_fuzz_fault_word */
    const char *sentence;        /* of the frame as it was drawn */
    bool hostile;                /* its G-buffer had what no renderer should write */
    json_t *smallest; /* aob_fuzz_frame_to_json; NULL: its kind was known. aob_fuzz_answer_to_json takes it */
};
json_t *aob_fuzz_answer_to_json(const struct aob_fuzz_answer *answer);
bool aob_fuzz_answer_from_json(const json_t *object, struct aob_fuzz_answer *answer); /* false: it is none */
#endif
