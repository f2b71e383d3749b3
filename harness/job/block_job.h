/* The job `block`: time and score up to AOB_BLOCK_MAX cases of one view on one backend. Its answers are the measured
 * half of a record, which the run stores as they are, and at the end the shares of its time. Texts are borrowed from
 * the JSON that they were read from. */
#ifndef AOB_JOB_BLOCK_JOB_H
#define AOB_JOB_BLOCK_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "address.h"
#include "base/error.h"
#include "plan/plan.h"
#include "technique/option.h"
#include "view_job.h"

struct aob_block_target { /* what every case of the block is compared with */
    double radius;        /* scene units; INFINITY allowed */
    bool uniform;         /* weighting of directions: the bare solid angle, else the cosine */
    const char *truth;    /* file with AO and SE, and B.X B.Y B.Z where `bent`; NULL: nothing is compared */
    bool bent;            /* a case of the block gives a bent normal */
};
struct aob_block_case {
    struct aob_address technique;
    double params[AOB_MAX_PARAM]; /* param_count, in the order of the technique's table */
    size_t param_count;
    double options[AOB_OPTION_COUNT];
    size_t target; /* of the targets: the one that its image file and its `error` are against */
    const char *definition,
        *screen;       /* its definition, traced freely and against the bound; NULL: it has none */
    const char *image; /* EXR file to write; NULL: none */
};
struct aob_block_job {
    struct aob_job_view view;
    const char *backend;
    bool validate;          /* Vulkan runs under its validation layer */
    bool raster, triangles; /* the device draws the G-buffer; a pass draws the scene's triangles */
    bool time, error;       /* what is measured */
    double seconds;         /* of timing a case, at most */
    double narrow;          /* timing ends early where the intervals are so narrow; 0: as timing.h says */
    struct aob_block_target *targets;
    size_t target_count;
    struct aob_block_case *cases; /* 1 .. AOB_BLOCK_MAX */
    size_t case_count;
};
json_t *aob_block_job_to_json(const struct aob_block_job *job);

/* False with a line for what is missing or out of bounds. Allocates; aob_block_job_finish frees. */
bool aob_block_job_from_json(const json_t *object, struct aob_block_job *job, struct aob_error *error);
void aob_block_job_finish(struct aob_block_job *job);

struct aob_block_shares { /* where the job's wall time went, in seconds */
    double measured, warmup, images;
};
json_t *aob_block_shares_to_json(const struct aob_block_shares *shares);
bool aob_block_shares_from_json(const json_t *object,
                                struct aob_block_shares *shares); /* false: it holds none */
#endif
