/* The error of an image, split by its causes (design.md, References 2). With t the truth, d the technique's definition
 * ray-traced (and mapped), s the same against the screen-space bound, v the technique's image:
 *   v - t = (d - t) + (s - d) + (v - s) = definition + missing information + estimator,
 * so the mean square of the whole is the three squares and twice the three mean products. */
#ifndef AOB_SCORE_SPLIT_H
#define AOB_SCORE_SPLIT_H
#include "score.h"

/* Sets these metrics over the pixels of desc that are not sky; they are NAN if there is none. `definition` and
 * `screen` are width x height floats. The mean products are not centred. */
void aob_split(const struct aob_score_desc *desc, const float *definition, const float *screen,
               struct aob_metrics *metrics);
#endif
