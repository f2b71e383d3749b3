/* The job `block`: score and time up to AOB_BLOCK_MAX cases of one view on one backend. It is sent to several processes:
 * the first scores and times, the others time only. Its answers, in this order: of each case, if it scores, the measured
 * half of a record, which the run stores as it is; if it times, what it times (aob_block_timed) and the rounds of that,
 * {round{}} each (timing/rounds.h); at the end the shares of its time. Texts are borrowed from the JSON that they were
 * read from. */
#ifndef AOB_JOB_BLOCK_JOB_H
#define AOB_JOB_BLOCK_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include "base/clock.h"
#include "base/error.h"
#include "plan/plan.h"
#include "drawing_job.h"
#include "poses.h"

struct aob_block_target { /* what every case of the block is compared with */
    double radius;        /* scene units; INFINITY allowed */
    bool uniform;         /* weighting of directions: the bare solid angle, else the cosine */
    /* Files of each output's truth; NULL: nothing is compared. The visibility's has AO and SE, and B.X B.Y B.Z where `bent`; the
     * others are as job/term.h says. */
    const char *truth[AOB_OUTPUT_COUNT];
    bool bent; /* a case of the block gives a bent normal */
};
struct aob_block_case {
    struct aob_job_frame frame;
    size_t target; /* of the targets: the one that its image file and its `error` are against */
    const char *definition,
        *screen;       /* its definition, traced freely and against the bound; NULL: it has none */
    const char *image; /* EXR file to write; NULL: none */
};
struct aob_block_job {
    struct aob_job_drawing drawing;
    struct aob_job_pose
        *poses; /* pose_count, in order: drawn before what is scored, timed or traced; none: one picture */
    size_t pose_count;
    bool score;     /* images are drawn, judged and written; */
    bool error;     /* and compared with the targets */
    bool time;      /* Where it scores as well, those are timed that turn out good, cheap and dear ones apart:
                               what it times is in its answer. Else all are timed, or the job fails. */
    int process;    /* from here on for timing/timing.h: the process' place among those of the block, */
    uint32_t seed;  /* of its order, */
    double seconds; /* of timing a case, at most, */
    double precision;         /* share: timing ends early where the intervals are as narrow, */
    const char *clock;        /* that costs are judged by (base/clock.h); NULL: the worker chooses */
    const char *clock_reason; /* what an earlier worker said of that choice (below); not NULL with a clock */
    struct aob_block_target *targets;
    size_t target_count;
    struct aob_block_case *cases; /* 1 .. AOB_BLOCK_MAX */
    size_t case_count;
};
json_t *aob_block_job_to_json(const struct aob_block_job *job);

/* False with a line for what is missing or out of bounds. Allocates; aob_block_job_finish frees. */
bool aob_block_job_from_json(const json_t *object, struct aob_block_job *job, struct aob_error *error);
void aob_block_job_finish(struct aob_block_job *job);

/* What the rounds that follow are of: their slots from AOB_SLOT_CASES on. */
struct aob_block_timed {
    enum aob_clock clock;
    char clock_reason[256]; /* why it is wall time, where a device's own clock is wanted; else empty */
    int threads;            /* of the driver */
    struct aob_block_timed_case {
        size_t index;    /* of the job's cases */
        double setup_ms; /* until its passes could run */
        json_t *passes;  /* names of those that are not pruned; a reference */
    } cases[AOB_BLOCK_MAX];
    size_t count;
};
json_t *aob_block_timed_to_json(const struct aob_block_timed *timed);

/* False: it holds none, or one that is not of `case_count` cases. aob_block_timed_finish frees. */
bool aob_block_timed_from_json(const json_t *object, size_t case_count, struct aob_block_timed *timed);
void aob_block_timed_finish(struct aob_block_timed *timed);

struct aob_block_shares { /* where the job's wall time went, in seconds */
    double measured, warmup, images;
};
json_t *aob_block_shares_to_json(const struct aob_block_shares *shares);
bool aob_block_shares_from_json(const json_t *object,
                                struct aob_block_shares *shares); /* false: it holds none */
#endif
