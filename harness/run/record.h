/* The record of a case, which is a line of the journal: what the case is, how it ended, and what its worker measured
 * (docs/design.md, A journal line). */
#ifndef AOB_RUN_RECORD_H
#define AOB_RUN_RECORD_H
#include <jansson.h>
#include "plan/plan.h"
#include "state.h"

struct aob_record_desc {
    const struct aob_config *config;
    const struct aob_case *c;
    const struct aob_state *state; /* what laying it out said; NULL: it was not laid out */
    const char *status;            /* "ok", "unsupported", "invalid", "failed", "planned" */
    const char *reason;            /* NULL: none */
    const json_t *answer;          /* of its block's worker; NULL: there is none */
    char *const *truths; /* of each target, its file below the run's folder or NULL; NULL: none is kept */
    size_t target;       /* place in the answer's `errors` of the one that is `error` */
    const char *image;   /* its EXR file below the run's folder; NULL: none is kept */
};
json_t *aob_record_create(const struct aob_record_desc *desc); /* a new object */
#endif
