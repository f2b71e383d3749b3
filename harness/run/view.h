/* The inside of aob_view_prepare: what its parts share. */
#ifndef AOB_RUN_VIEW_H
#define AOB_RUN_VIEW_H
#include <jansson.h>
#include "job/view_job.h"
#include "measurement.h"

/* What a view shows at one time. */
struct aob_view_moment {
    struct aob_camera camera;
    int frame;     /* of a scene in which something moves; else 0 */
    unsigned seed; /* of its truths */
};
struct aob_view_moment aob_view_moment_last(const struct aob_plan_scene *scene); /* what is scored */

/* A frame of a sequence before its last. */
struct aob_view_moment aob_view_moment_of(const struct aob_plan_scene *scene, int frame);

/* Files in the cache, named by what they depend on; free() them. */
char *aob_view_gbuffer_path(const struct aob_measurement *m, const struct aob_case *c,
                            const struct aob_view_moment *moment);
char *aob_view_term_path(const struct aob_measurement *m, const struct aob_case *c,
                         const struct aob_view_moment *moment, json_t *term);

/* The terms that a view's job is to trace. `known`: which files have been looked for; `shut`: the last of them that
 * could not be read. */
struct aob_view_missing {
    json_t *terms, *known;
    struct aob_error shut;
};
struct aob_view_truth {
    const struct aob_target *target;
    bool bent;
};

/* Adds a truth to what is missing unless its file is there already; returns that file. */
char *aob_view_want_truth(struct aob_measurement *m, const struct aob_case *c,
                          const struct aob_view_moment *moment, const struct aob_view_truth *truth,
                          struct aob_view_missing *missing);

/* The job that casts the view and traces the terms. */
bool aob_view_trace(struct aob_measurement *m, const struct aob_case *c, const struct aob_job_view *view,
                    bool cast, json_t *terms, struct aob_error *error);

/* The frames before the last, where the view is a sequence: their files, which are made where the cache lacks them. */
bool aob_view_prepare_poses(struct aob_measurement *m, const struct aob_case *c, struct aob_view_files *files,
                            struct aob_error *error);
void aob_view_poses_finish(struct aob_view_files *files);
#endif
