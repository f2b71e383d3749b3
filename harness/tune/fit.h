/* The worker's side of `tune`: the job that draws and searches (job/tune_job.h). A row for main.c's array of jobs. */
#ifndef AOB_TUNE_FIT_H
#define AOB_TUNE_FIT_H
#include "worker/worker.h"

extern const struct aob_worker_job aob_worker_tune;
#endif
