/* A section of gpu-check on one backend, in a process of its own (gpu-check-device), so that a driver that crashes or hangs
 * costs this section. It reads one JSON document on standard input, {section, backend, device, data, seconds, most,
 * precision, trusted}, and answers with a JSON object a line: an item, {item, status, ...}. An alarm ends it after `most`
 * seconds. A section that cannot be done at all says so in one line on standard error and exits with 2. */
#ifndef AOB_GPU_CHECK_SECTION_H
#define AOB_GPU_CHECK_SECTION_H
#include <jansson.h>
#include <stdbool.h>
#include <stdint.h>
#include "base/error.h"
#include "check_data.h"
#include "gpu/gpu.h"

struct aob_section_job {
    const char *backend, *device; /* device: NULL: the backend's choice */
    struct aob_check_data data;
    double precision; /* of a technique's time, a share */
    bool trusted;     /* the device's clock passed its test */
    int64_t end_ns;   /* by the monotonic clock: no item is begun after it */
    int reply;        /* file descriptor of the answers */
};
struct aob_section {
    const char *name;
    bool (*run)(const struct aob_section_job *job, struct aob_error *error);
};
extern const struct aob_section aob_section_device, aob_section_timer, aob_section_images,
    aob_section_validation, aob_section_times;

/* How an item ended. */
#define AOB_CHECK_PASSED    "passed"
#define AOB_CHECK_DISAGREES "disagrees" /* with a `reason` */
#define AOB_CHECK_FAILED    "failed"    /* the device could not do it; with a `reason` */
#define AOB_CHECK_SKIPPED   "skipped"   /* nothing for this device; with a `reason` */
#define AOB_CHECK_CUT       "cut"       /* there was no time or no lock left; with a `reason` */
#define AOB_CHECK_CANNOT    "cannot"    /* of all together: no backend has a device */

/* Sends an item; takes the reference. */
void aob_section_reply(const struct aob_section_job *job, json_t *item);

/* Sends {item, status, reason}. */
void aob_section_say(const struct aob_section_job *job, const char *item, const char *status,
                     const char *reason);

/* Whether the time is up; if so the item is sent as cut. */
bool aob_section_is_over(const struct aob_section_job *job, const char *item);
double aob_section_seconds_left(const struct aob_section_job *job);

/* The job's device; NULL after one line. */
struct aob_gpu *aob_section_open(const struct aob_section_job *job, const struct aob_gpu_desc *how,
                                 struct aob_error *error);
#endif
