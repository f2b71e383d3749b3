/* The workers' side of `stress`: the job that asks the properties (job/stress_job.h), and the one that draws the fuzzer's frames
 * (job/fuzz_job.h). Rows for main.c's array of jobs. */
#ifndef AOB_STRESS_ASK_H
#define AOB_STRESS_ASK_H
#include "worker/worker.h"

extern const struct aob_worker_job aob_worker_stress, aob_worker_fuzz;
#endif
