/* The inside of aob_measurement_block: a block under way, and what its parts share. */
#ifndef AOB_RUN_BLOCK_H
#define AOB_RUN_BLOCK_H
#include <jansson.h>
#include "job/block_job.h"
#include "measurement.h"
#include "timing/processes.h"

struct aob_run_block {
    struct aob_measurement *m;
    const size_t *indices; /* of the plan's cases; a case's place is its index in here */
    size_t count;
    const struct aob_view_files *files;   /* while its workers run */
    char *truths[AOB_CONFIG_MAX_TARGETS]; /* "truths/HASH.exr" below the run's folder; NULL: it is not kept */
    bool answered[AOB_BLOCK_MAX];
    json_t *held[AOB_BLOCK_MAX]; /* a good answer that still lacks its times or cache figures */
    char reason[768];            /* why what is not answered is not; empty: the worker did not say */
};

/* What one process has answered to the block's job. */
struct aob_run_block_reply {
    struct aob_run_block *block;
    struct aob_block_timed timed; /* none: count is 0 */
    struct aob_round_list *rounds;
    struct aob_error garbled; /* the first answer that made no sense */
    bool complete;            /* the last answer came: what the worker does after that is no case's fault */
};

/* One process: sends the job for the cases at these places and takes its answers. Where it times, the machine is locked
 * meanwhile (timing/measure_lock.h). */
struct aob_run_block_job {
    const size_t *places;
    size_t count;
    bool score;
    const struct aob_process_desc *process;
};
bool aob_run_block_send(struct aob_run_block *block, const struct aob_run_block_job *job,
                        struct aob_run_block_reply *reply, struct aob_error *error);
void aob_run_block_take(void *reply, const json_t *answer); /* for each answer */

const struct aob_case *aob_run_block_case(const struct aob_run_block *block, size_t place);

/* The case's image below the run's folder. */
void aob_run_block_image(const struct aob_case *c, char name[AOB_KEY_SIZE + 16]);

/* Writes the record of a case. */
void aob_run_block_finish_case(struct aob_run_block *block, size_t place, const char *status,
                               const char *reason, const json_t *answer);

/* The record of a case that is held, with the cache figures that the plan asks for; its times are in it. */
void aob_run_block_finish_held(struct aob_run_block *block, size_t place);

/* How the cases at `places` (not needed for `count` alone) are timed over processes. */
struct aob_processes_desc aob_run_block_processes(const struct aob_run_block *block, size_t place,
                                                  size_t count);

/* Times what is held, in further processes, and writes its records. `first` is what the process that scored has
 * answered, and `lost` why its rounds do not count, or NULL. Cases whose processes fail stay unanswered. */
void aob_run_block_time(struct aob_run_block *block, struct aob_run_block_reply *first, const char *lost);
#endif
