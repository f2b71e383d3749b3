/* The job `layout`: does a technique accept these cases, and what does it lay out for them? Texts are borrowed from the
 * JSON that they were read from. */
#ifndef AOB_JOB_LAYOUT_JOB_H
#define AOB_JOB_LAYOUT_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "address.h"
#include "base/error.h"
#include "technique/graph.h"

struct aob_layout_job {
    struct aob_address technique;
    size_t case_count, param_count;
    double *params; /* case_count x param_count, in the order of the technique's table */
    unsigned *
        wanted; /* case_count: outputs besides visibility; bits 1 << enum aob_output, and AOB_WANT_THRIFT. In JSON names */
};
json_t *aob_layout_job_to_json(const struct aob_layout_job *job);

/* False with a line if a case has not as many parameters as the first, or does not say what it wants. Allocates;
 * aob_layout_job_finish frees. */
bool aob_layout_job_from_json(const json_t *object, struct aob_layout_job *job, struct aob_error *error);
void aob_layout_job_finish(struct aob_layout_job *job);

/* The answer for one case; answers come in the order of the cases. */
struct aob_layout_answer {
    const char *status;       /* "ok", "invalid", or "unsupported": a wanted output is not given */
    const char *reason;       /* of a refusal, one line */
    const char *graph, *dot;  /* digest of the laid-out passes and their picture */
    unsigned outputs;         /* that it gives; bits 1 << enum aob_output. In JSON their names */
    bool triangles;           /* a pass draws the scene's */
    const json_t *definition; /* a term (term.h); NULL: the technique claims nothing */
    bool mapped;              /* the definition's value is mapped */
};
json_t *aob_layout_answer_to_json(const struct aob_layout_answer *answer);
bool aob_layout_answer_from_json(const json_t *object,
                                 struct aob_layout_answer *answer); /* false: of another form */

json_t *aob_outputs_to_json(unsigned outputs); /* ["visibility", "bent_normal"]; a new array */
unsigned aob_outputs_from_json(const json_t *names);
#endif
