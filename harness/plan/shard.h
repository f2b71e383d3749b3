/* A shard: the part of a plan that one of several machines measures. The parts of one count have no case in common, and together
 * they are the plan. Which part a case belongs to follows from the plan alone, so that machines need not talk to each other.
 *
 * Cases that are timed in one block stay together, since their times are ratios within it. The block's part is the hash of
 * its cases' keys: neighbours in the plan, which often take equally long, do not lie in one part. */
#ifndef AOB_PLAN_SHARD_H
#define AOB_PLAN_SHARD_H
#include "plan.h"

struct aob_shard {
    int index; /* 1 .. count */
    int count; /* 0: no shard, but the whole plan */
};
enum { AOB_SHARD_MOST = 10000 };

/* "2/4" is the second of four; "env" is the task of the array in which the program runs (below). False after a line that says what is
 * wrong. */
bool aob_shard_parse(const char *text, struct aob_shard *shard, struct aob_error *error);

/* The task of an array of Slurm, of GitLab's `parallel` or of a job of Open MPI, by the variables that these set. A Slurm array
 * counts from 0 or from 1 without gaps. Of another one, and of one task, the shard cannot be told, as it may be a part that was
 * started again. One that begins at 0 or 1 may be a part too, which nothing shows. False after a line, also where there is none and where two of them disagree. */
bool aob_shard_from_environment(struct aob_shard *shard, struct aob_error *error);

/* Keeps the shard's cases, in their order and in the blocks of the whole plan; it may be none. Does nothing without a shard. Call it before aob_plan_filter: what a filter leaves
 * would make other blocks. */
void aob_plan_keep_shard(struct aob_plan *plan, const struct aob_shard *shard);
#endif
