/* What gpu-check found: its sections in order, each run in a process of its own (section.h), and the document of results. No
 * device is opened here. */
#ifndef AOB_GPU_CHECK_CHECK_H
#define AOB_GPU_CHECK_CHECK_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"

#define AOB_CHECK_SCHEMA "aobudget gpu-check 1"

struct aob_check_desc {
    const char
        *program; /* the folder of gpu-check-device, and of the loaders that it is packed with (loader.h) */
    const char *data;    /* folder (check_data.h) */
    const char *backend; /* NULL: all */
    const char *device;  /* NULL: each backend's choice */
    const char *section; /* NULL: all; else this one and what it needs: the device, and for times the timer */
    double seconds;      /* for all sections together */
    double precision; /* share that a technique's interval may reach to either side: its timing ends there */
};
#define AOB_CHECK_PRECISION 0.01

/* Runs the sections and returns the document; decref it. NULL with a line, before anything is opened, if something is to be
 * timed and the lock of measuring cannot be had (timing/measure_lock.h). The document holds schema, program, date, machine{cpu, cores, system},
 * packed_loaders[], seconds, verdict, findings[], cut[] (a line each), sections[{section, backend, status, reason, seconds, items[]}]. A section's
 * status is that of its worst item: failed, disagrees, cut, passed, skipped. The verdict is `disagrees` (a section failed or
 * disagrees, that of the device too: a driver that dies when it is opened is a finding), `cannot` (no backend has a device,
 * or not the one that was asked for), `cut` (there was no time left for some items, or the lock went away), or `passed`. */
json_t *aob_check_run(const struct aob_check_desc *desc, struct aob_error *error);

/* Whether there is a section of that name. */
bool aob_check_has(const char *section);

enum aob_exit aob_check_code(const json_t *document);

/* The document as plain tables. */
void aob_check_print(const json_t *document, struct aob_text *out);
#endif
