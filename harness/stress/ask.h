/* The worker's side of `stress`: the job that asks the properties (job/stress_job.h). A row for main.c's array of jobs. */
#ifndef AOB_STRESS_ASK_H
#define AOB_STRESS_ASK_H
#include "worker/worker.h"

extern const struct aob_worker_job aob_worker_stress;
#endif
