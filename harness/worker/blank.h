/* Why a technique draws nothing: an image that one of its own rules leaves open, such as an early exit. */
#ifndef AOB_WORKER_BLANK_H
#define AOB_WORKER_BLANK_H
#include "job/block_job.h"
#include "score/score.h"

/* Adds to the line of aob_score_judge_drawn the pixels that the parameter `radius` covers at the median depth, and the
 * parameters that are not at their defaults, lengths left out. Always false. */
bool aob_blank_explain(const struct aob_technique *technique, const struct aob_block_case *c,
                       const struct aob_score_desc *desc, struct aob_error *error);
#endif
