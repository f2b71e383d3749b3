/* The job `cache`: what the passes of one case fetch, and how the caches of profiles take it. It answers first with what
 * it is about to do (aob_cache_capture), then with the figures of each profile (aob_cache_answer), in the order of the
 * job. Texts are borrowed from the JSON that they were read from. */
#ifndef AOB_JOB_CACHE_JOB_H
#define AOB_JOB_CACHE_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "drawing_job.h"
#include "poses.h"

struct aob_cache_profile {
    const char *path;   /* of its file */
    const char *digest; /* that the file is to have (profile/profile.h) */
};
struct aob_cache_job {
    struct aob_job_drawing drawing;
    struct aob_job_frame frame;
    struct aob_job_pose
        *poses; /* pose_count, in order, without truths: drawn before what is traced, where the technique
                                    keeps a history; none: one picture */
    size_t pose_count;
    struct aob_cache_profile *profiles; /* one at least */
    size_t profile_count;
    const char *map; /* EXR file to write, NAME.misses of each profile by pixel; NULL: none */
};
json_t *aob_cache_job_to_json(const struct aob_cache_job *job);

/* False with a line for what is missing. Allocates; aob_cache_job_finish frees. */
bool aob_cache_job_from_json(const json_t *object, struct aob_cache_job *job, struct aob_error *error);
void aob_cache_job_finish(struct aob_cache_job *job);

struct aob_cache_capture { /* what is foretold once the device knows the case's passes */
    double words;          /* fetches of all invocations of all passes */
    double strips;         /* draws */
    double seconds;        /* of the whole job, from here on */
};
json_t *aob_cache_capture_to_json(const struct aob_cache_capture *capture);
bool aob_cache_capture_from_json(const json_t *object,
                                 struct aob_cache_capture *capture); /* false: it is none */

struct aob_cache_answer {
    size_t profile;        /* its place in the job */
    const char *status;    /* "ok", "unsupported": such a trace is not possible here, or "failed" */
    const char *reason;    /* where it is not ok; else NULL */
    const json_t *figures; /* docs/design.md, Cache figures; NULL where it is not ok */
};
json_t *aob_cache_answer_to_json(const struct aob_cache_answer *answer);
bool aob_cache_answer_from_json(const json_t *object,
                                struct aob_cache_answer *answer); /* false: it is none */
#endif
