/* What the senders of jobs that draw frames share: the parts of the message (job/drawing_job.h), and the environment that
 * drivers read when their process starts. */
#ifndef AOB_RUN_DRAWING_H
#define AOB_RUN_DRAWING_H
#include "job/drawing_job.h"
#include "job/poses.h"
#include "measurement.h"

/* What the device is to draw for case `index` alone. Texts belong to the plan and to `files`. */
struct aob_job_drawing aob_job_drawing_of(const struct aob_measurement *m, size_t index,
                                          const struct aob_view_files *files);

/* The frames of a sequence before its last, with the truths of so many targets; free() them. */
struct aob_job_pose *aob_job_poses_of(const struct aob_view_files *files, size_t target_count);
struct aob_job_frame aob_job_frame_of(const struct aob_case *c);

struct aob_drawing_environment {
    char *texts[32]; /* "NAME=value", NULL-ended */
};
void aob_drawing_environment_init(struct aob_drawing_environment *env, const struct aob_measurement *m,
                                  const struct aob_case *c);
void aob_drawing_environment_finish(struct aob_drawing_environment *env);
#endif
