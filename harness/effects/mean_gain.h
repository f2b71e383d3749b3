/* How much nearer to the truth a mean over many frames can be, of a view in which nothing moves. */
#ifndef AOB_EFFECTS_MEAN_GAIN_H
#define AOB_EFFECTS_MEAN_GAIN_H
#include "drawn.h"

/* `drawn`: by aob_effect_image_of, of single frames and of the means of two frames.
 *
 * The noise of a frame is another each time, so the mean of two differs from the first by half of the difference between two draws, whose
 * variance is half the variance of one; and the mean of endlessly many differs from the first by that whole variance, n^2. Noise that
 * is spread evenly over frames, as a sequence of low discrepancy is, differs more from one frame to the next, and comes out larger
 * here than it is. Since noise is as often above that mean as below it, it adds up with what else is wrong by the squares: of an error e
 * the mean leaves sqrt(e^2 - n^2).
 *
 * Returns e - sqrt(e^2 - n^2) of the set of `open` for which it is the largest, e as lit_rmse. */
double aob_effect_mean_gain(const struct aob_seen *seen, const struct aob_drawn *drawn, unsigned open);
#endif
