/* `aobudget worker`: one job in a process of its own. It reads one JSON document on standard input and answers with JSON
 * lines on standard output. Only here are modules loaded, drivers opened and files of strangers parsed, so a crash costs
 * this job. The messages are in job/, writer and reader of each in one file; four jobs are too small for one:
 *   describe {modules}  -> a technique a line (aob_technique_to_json), built in or of the modules
 *   devices  {backend, device}  -> a device a line: {name, driver, class, software, timer, lacks, chosen}; {none}, the
 *                                  reason, where none is chosen
 *   probe    {backend, device}  -> {device, driver, class}, and {cpu, cores} where a processor is the device
 *   timer    {backend, device}  -> {trusted, why_not, checks[{what, measured, expected, low, high}]} (timing/timer.h)
 * A job that cannot be done says so in one line on standard error and exits with 2. */
#ifndef AOB_WORKER_WORKER_H
#define AOB_WORKER_WORKER_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "job/view_job.h"
#include "scene/mesh.h"
#include "technique/registry.h"

struct aob_worker {
    const json_t *job;
    int reply; /* file descriptor of the answers; what drivers print on standard output goes to standard error */
};
struct aob_worker_job {
    const char *name; /* the member "job" of its message */
    bool (*run)(struct aob_worker *worker, struct aob_error *error);
};
extern const struct aob_worker_job aob_worker_describe, aob_worker_probe, aob_worker_devices,
    aob_worker_timer, aob_worker_layout, aob_worker_mesh, aob_worker_capture, aob_worker_light,
    aob_worker_check, aob_worker_view, aob_worker_block, aob_worker_cache;

/* Reads a job and does it by the NULL-ended list; the exit code. */
int aob_worker_main(const struct aob_worker_job *const *jobs);

void aob_worker_reply(struct aob_worker *worker, json_t *answer); /* takes the reference */

/* The numbers as the technique's own values struct, into a buffer of 4 * AOB_MAX_PARAM bytes; false with a line if there
 * are not as many as it has parameters. */
bool aob_worker_values(const struct aob_technique *technique, const double *params, size_t count,
                       void *values, struct aob_error *error);

/* The view's flat mesh, or its procedural scene in the view's frame; aob_mesh_finish frees. */
bool aob_worker_load(const struct aob_job_view *view, struct aob_mesh *mesh, struct aob_error *error);
#endif
