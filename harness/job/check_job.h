/* The job `check`: whether a view's geometry is as techniques that draw its triangles presuppose. Texts are borrowed
 * from the JSON that they were read from. */
#ifndef AOB_JOB_CHECK_JOB_H
#define AOB_JOB_CHECK_JOB_H
#include "view_job.h"

struct aob_check_job {
    struct aob_job_view view; /* its G-buffer is not read */
    double radius;            /* farthest occluder of these techniques, scene units */
};
json_t *aob_check_job_to_json(const struct aob_check_job *job);
bool aob_check_job_from_json(const json_t *object, struct aob_check_job *job, struct aob_error *error);

struct aob_check_answer {
    size_t triangles, doubled; /* doubled: those that repeat another one (scene/mesh_double.h) */
    double backs;              /* share of directions that meet a back (reference/backs.h) */
};
json_t *aob_check_answer_to_json(const struct aob_check_answer *answer);
bool aob_check_answer_from_json(const json_t *object,
                                struct aob_check_answer *answer); /* false: of another form */
#endif
