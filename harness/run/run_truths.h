/* `run --truth-only`: what the cases of a plan are compared with, traced into the cache. A run of the plan, or of any of its shards,
 * that has this cache traces nothing. So machines that measure need not wait for rays, and no shard of a view traces
 * what another one does. No device is opened, no folder made, and nothing timed. */
#ifndef AOB_RUN_RUN_TRUTHS_H
#define AOB_RUN_RUN_TRUTHS_H
#include "run.h"

/* Of `desc` the dispatch, config, filter, shard, json and quiet. A view that fails is told in a warning, and the others are made
 * all the same. OK: all cases that their techniques accept have their truths. PART: some have not, or a technique could not be asked. USAGE: none has, or the
 * config cannot be planned. A line in `error` then. */
enum aob_exit aob_run_truths(const struct aob_run_desc *desc, struct aob_error *error);
#endif
