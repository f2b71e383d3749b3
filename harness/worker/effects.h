/* The outputs of one case besides visibility and bent normal: read from the device, judged, scored against their truths, and
 * stored. They are the `effects` of a struct aob_case_image. */
#ifndef AOB_WORKER_EFFECTS_H
#define AOB_WORKER_EFFECTS_H
#include "case_image.h"
#include "score/effect.h"

/* Reads those that the drawn frame gives. */
bool aob_case_effects_read(const struct aob_block *block, struct aob_frame *frame,
                           struct aob_case_image *image, struct aob_error *error);

/* False with a line if a value cannot be one. */
bool aob_case_effects_judge(const struct aob_score_desc *desc, const struct aob_case_image *image,
                            struct aob_error *error);

/* Reads the target's truths and scores what the case gives against them; adds the bits 1 << enum aob_output of what it scored
 * to `outputs`. `desc` has the true visibility, `f` is the case's frame. The truths of the case's own target stay with the
 * image. */
bool aob_case_effects_score(const struct aob_block *block, size_t f, const struct aob_block_target *target,
                            const struct aob_score_desc *desc, struct aob_case_image *image,
                            struct aob_metrics *metrics, unsigned *outputs, struct aob_error *error);

/* Adds the channels technique.NAME, reference.NAME, reference.SE.NAME and error.NAME, the mean of the channels' differences. */
void aob_case_effects_store(const struct aob_case_image *image, struct aob_image *file);

void aob_case_effects_finish(struct aob_case_image *image);
#endif
