/* Jobs for workers (worker/worker.h), each in a process of its own, from the program's main process. */
#ifndef AOB_RUN_DISPATCH_H
#define AOB_RUN_DISPATCH_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "job/modules.h"
#include "technique/registry.h"

struct aob_dispatch {
    const char *program;        /* path of the executable that answers to `worker` */
    struct aob_modules modules; /* the --module files */
    bool validate;              /* Vulkan validation layer in workers */
    const char *device;         /* of each backend (aob_gpu_choose); NULL: its default */
};
struct aob_job_desc {
    json_t *job;                                         /* taken */
    const char *const *env;                              /* NULL, or NULL-ended "NAME=value" */
    double timeout_s;                                    /* of work (base/deadline.h) */
    size_t memory_limit, output_limit;                   /* bytes (base/child.h); 0: none, 64 MiB */
    void (*on_answer)(void *user, const json_t *answer); /* borrowed */
    void *user;
    const char *file; /* of the user, that it reads, and that its line names; NULL: none */
};
/* False: the worker could not start, crashed, took too long or said that the job cannot be done; one line
 * says which. Answers given before that have been passed on. */
bool aob_dispatch_job(const struct aob_dispatch *dispatch, const struct aob_job_desc *desc,
                      struct aob_error *error);

/* What techniques there are: built in and in the modules, which may be others than the dispatch's. */
bool aob_dispatch_describe(const struct aob_dispatch *dispatch, const struct aob_modules *modules,
                           struct aob_technique_list *list, struct aob_error *error);

/* The devices of a backend, [{name, driver, class, software, timer, lacks, chosen}] in the order of their numbers; one is
 * `chosen` at most, that of dispatch->device or the default; where none is, `error` has the reason. NULL after a line: no
 * driver. Decref it. */
json_t *aob_dispatch_devices(const struct aob_dispatch *dispatch, const char *backend,
                             struct aob_error *error);

/* What a backend's device says of itself, {device, driver, class}; NULL after a line if it cannot be opened. Decref
 * it. */
json_t *aob_dispatch_probe(const struct aob_dispatch *dispatch, const char *backend, struct aob_error *error);

/* Whether a backend's device has a clock that tells the truth: {trusted, why_not, checks[]} of the job `timer`
 * (worker/worker.h). NULL after a line if it cannot be tested. Decref it. */
json_t *aob_dispatch_timer(const struct aob_dispatch *dispatch, const char *backend, struct aob_error *error);
#endif
