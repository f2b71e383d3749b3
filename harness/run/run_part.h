/* Which part of its plan a run measures, and where it goes: the shard, and of that what the filter keeps. */
#ifndef AOB_RUN_RUN_PART_H
#define AOB_RUN_RUN_PART_H
#include <jansson.h>
#include "run.h"
#include "sweep.h"

/* The folder of a run: the one that was asked for, else results/NAME, and results/NAME-2-of-4 of a shard; free() it. */
char *aob_run_path(const struct aob_run_desc *desc, const struct aob_config *config);

/* For a shard, and for truths alone: a config with `effects: auto` is refused, as its cases are chosen by what is measured. False after a
 * line. */
bool aob_run_part_judge(const struct aob_run_desc *desc, const struct aob_config *config,
                        struct aob_error *error);

/* Takes the other cases out of the plan, and puts those that are left into `info` (NULL: nobody asks) as the ones that are asked for. None may be left of a
 * shard, where the plan has few blocks. False after a line if the filter leaves none of the whole plan. */
bool aob_run_part_choose(const struct aob_run_desc *desc, struct aob_plan *plan, json_t *info,
                         struct aob_error *error);
#endif
