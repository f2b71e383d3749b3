/* The inside of a block job (job/block_job.h): what its parts share. */
#ifndef AOB_WORKER_BLOCK_H
#define AOB_WORKER_BLOCK_H
#include <jansson.h>
#include "frame/frame.h"
#include "job/block_job.h"
#include "drawing.h"
#include "worker.h"

struct aob_block_sequence; /* block_sequence.h */

/* One block while it is worked on. */
struct aob_block {
    struct aob_block_job job;
    struct aob_drawing drawing;
    struct aob_frame fixed, frames[AOB_BLOCK_MAX];
    size_t case_of_frame[AOB_BLOCK_MAX], frame_count;
    double setup_ms[AOB_BLOCK_MAX];
    bool good[AOB_BLOCK_MAX]; /* of each frame, where the job scores: its image is a visibility */
    struct aob_block_shares shares;
    struct aob_block_sequence *sequence; /* NULL: one picture */
};

/* Times the frames that the job wants timed, and replies with what they are and their rounds. */
bool aob_block_measure(struct aob_worker *worker, struct aob_block *block, struct aob_error *error);

/* Runs the frame once more, scores its image against the targets and writes the EXR that the case asks for. Puts
 * `errors` into the answer, and `status` invalid where the image is no visibility. */
bool aob_block_score(struct aob_block *block, size_t f, json_t *answer, struct aob_error *error);
#endif
