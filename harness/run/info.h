/* What run.json says of a run: which one it is, and on what. */
#ifndef AOB_RUN_INFO_H
#define AOB_RUN_INFO_H
#include <jansson.h>
#include "sweep.h"

/* {name, config_hash, build, program, date, cases, keys, techniques, devices, budget}, of the whole plan whatever the filter: a page
 * is complete when all of it is measured. Opens each backend of the plan once, in a worker; a backend that cannot be
 * opened stands in `devices` as null. NULL after a line if this program's own file cannot be read, or
 * if no backend of the plan has the device that is asked for. Decref it. */
json_t *aob_run_info_create(const struct aob_sweep *sweep, const struct aob_dispatch *dispatch,
                            struct aob_error *error);

/* Sets cases, keys and techniques anew, where the plan has become another: that of a config with `effects: auto`, without the views that a
 * filter leaves unplanned. */
void aob_run_info_plan(json_t *info, const struct aob_sweep *sweep);

/* Adds `asked`: the keys of a plan that a filter has cut. Without it, all keys are asked for. */
void aob_run_info_ask(json_t *info, const struct aob_plan *plan);

/* Whether the run in a folder, by its run.json there, has ended with what its page shows of `info`: the page has the same
 * budget. A run that was stopped, or drew no page, has not. */
bool aob_run_info_has_page(const json_t *info, const char *folder);
#endif
