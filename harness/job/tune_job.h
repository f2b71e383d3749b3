/* The job `tune`: one technique with some of its parameters free, drawn on several views and compared with their truths, until the
 * values of least error are found. Each view has a device of its own, which lives as long as the job. The answers, in this order:
 * progress, any number of times, and one result. Texts are borrowed from the JSON that they were read from. */
#ifndef AOB_JOB_TUNE_JOB_H
#define AOB_JOB_TUNE_JOB_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "drawing_job.h"

struct aob_tune_axis { /* a parameter that is free */
    size_t index;      /* row of the technique's table */
    bool log;          /* the search takes equal steps of its logarithm; low is above 0 then */
    double low, high;  /* between which the search looks, in the unit of the table */
    double start;      /* where it begins */
    double scale;      /* what is drawn is the value times this: pixels of a smaller image */
};
struct aob_tune_view {
    struct aob_job_drawing drawing;
    struct aob_job_frame
        frame;         /* the values of what is not free, and those that the error without a fit is of */
    const char *truth; /* file of the visibility of the target */
};
struct aob_tune_job {
    struct aob_tune_view *views; /* all of one technique */
    size_t view_count;
    struct aob_tune_axis axes[AOB_MAX_PARAM];
    size_t axis_count;
    bool probe;        /* axes that change no image are found first, and stay where they start */
    int global, local; /* images of every view that each search may draw */
    double step;       /* of the local search at first: a share of the way from low to high */
};
json_t *aob_tune_job_to_json(const struct aob_tune_job *job);

/* False with a line for what is missing or out of bounds. Allocates; aob_tune_job_finish frees. */
bool aob_tune_job_from_json(const json_t *object, struct aob_tune_job *job, struct aob_error *error);
void aob_tune_job_finish(struct aob_tune_job *job);

struct aob_tune_progress {
    int done, of; /* images of every view */
    double error; /* the least so far */
};
json_t *aob_tune_progress_to_json(const struct aob_tune_progress *progress);
bool aob_tune_progress_from_json(const json_t *object, struct aob_tune_progress *progress);

struct aob_tune_result {
    double values[AOB_MAX_PARAM]; /* of the axes, floats' values */
    bool idle[AOB_MAX_PARAM];     /* of the axes: it changes no image */
    size_t count;
    double start_error, error; /* mean over views of the RMSE in band, at the start and at the values */
    int evaluations;
};
json_t *aob_tune_result_to_json(const struct aob_tune_result *result);
bool aob_tune_result_from_json(const json_t *object, struct aob_tune_result *result);
#endif
