/* The member `time` of a record (docs/design.md, A journal line), from the rounds of its block. */
#ifndef AOB_RUN_TIME_RECORD_H
#define AOB_RUN_TIME_RECORD_H
#include <jansson.h>
#include "job/block_job.h"
#include "timing/processes.h"

struct aob_time_record_desc {
    const struct aob_processes_desc *asked;
    const struct aob_processes *measured;
    const struct aob_block_timed *timed; /* what the slots are */
    size_t at;                           /* of its cases, the one that is recorded */
    const json_t *slots;                 /* keys of the cases behind "fixed" and "control" */
    const char *rounds_file;             /* below the run's folder; NULL: none is kept */
};
json_t *aob_time_record_create(const struct aob_time_record_desc *desc); /* a new object */
#endif
