/* A journal line as a history takes it: what identifies its line, and the figures of its point. Pure functions. */
#ifndef AOB_HISTORY_RECORD_H
#define AOB_HISTORY_RECORD_H
#include <jansson.h>

/* What its device is, in words: "cpu, 2 x AMD EPYC ..., llvmpipe ..., Mesa ..., fixed pass 1"; "" of a record that reached none. */
char *aob_record_machine(const json_t *record); /* free() it */

/* How it was timed: "2 threads, cpu time"; "" of a record without a time. */
char *aob_record_clock(const json_t *record); /* free() it */

/* Which records of a run are timed alike: by backend, and the threads that were asked for; free() it. */
char *aob_record_timed_as(const json_t *record);

char *aob_record_params(const json_t *record);  /* "radius=0.5 slices=3"; free() it, and the next two */
char *aob_record_options(const json_t *record); /* with the light, where it matters */
char *aob_record_size(const json_t *record);    /* "480x270"; "" if it is not known */

/* "corner/front gtao radius=0.5 vulkan 480x270", without what is at its default, as far as `info`, which is run.json or NULL,
 * tells; with `module` (not "") behind the technique. free() it. */
char *aob_record_title(const json_t *record, const json_t *info, const char *module);

double aob_record_cost_ms(const json_t *record); /* of a frame by its clock; NAN */

/* Its own target: scene units (NAN: none), "cosine" or "uniform", "ray-traced" or "screen"; "" without one. */
struct aob_record_target {
    double radius;
    const char *weighting, *reference;
};
struct aob_record_target aob_record_target(const json_t *record);

/* {"flip": 0.01, "cache.ps4.l2.most.miss_ratio": 0.2}: every metric against its own target and every cache figure that is
 * known, named as the columns of cases.csv. decref it. */
json_t *aob_record_figures(const json_t *record);

/* The entry of run.json's techniques that measured it; NULL: none is known. */
const json_t *aob_record_technique(const json_t *record, const json_t *info);
#endif
