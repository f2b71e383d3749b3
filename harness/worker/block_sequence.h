/* A sequence within a block: the frames before the last are drawn in order, each scored against the truth of its own time, and
 * compared with the frame before at the same points of the surfaces (score/flicker.h). The last one is scored as a single
 * picture is, and compared as well. */
#ifndef AOB_WORKER_BLOCK_SEQUENCE_H
#define AOB_WORKER_BLOCK_SEQUENCE_H
#include <jansson.h>
#include "block.h"
#include "store/metric.h"

/* Draws the frames before the last with all techniques of the block, so that those with a memory have it, and leaves the
 * screens and the frames' numbers at the last. Does nothing if the job is of one picture. Where the job scores, what goes
 * wrong with a technique is that case's (below), else the job's. */
bool aob_block_sequence_draw(struct aob_block *block, struct aob_error *error);

/* False with a line: the frames before the last could not be drawn, or one of them is no visibility. */
bool aob_block_sequence_is_drawn(const struct aob_block *block, size_t f, struct aob_error *error);
bool aob_block_sequence_judge(const struct aob_block *block, size_t f, struct aob_error *error);

/* Of the last frame, against the job's target t: sets metrics->flicker. The RMSE has to be there. */
struct aob_block_sequence_images { /* of the view */
    const float *image, *truth, *se;
};
void aob_block_sequence_score(const struct aob_block *block, size_t f, size_t t,
                              const struct aob_block_sequence_images *last, struct aob_metrics *metrics);

/* The record's `sequence`, once the case's own target is scored. */
json_t *aob_block_sequence_to_json(const struct aob_block *block, size_t f);

void aob_block_sequence_destroy(struct aob_block_sequence *sequence);
#endif
