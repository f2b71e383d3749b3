/* How much of a frame of a still view is noise: what a mean over many frames can change in its lit image. */
#ifndef AOB_EFFECTS_NOISE_H
#define AOB_EFFECTS_NOISE_H
#include "drawn.h"

/* `drawn`: by aob_effect_image_of, of single frames and of the means of two frames. The noise of a frame is another each time, so the mean of
 * two differs from the first by half of the difference between two draws, whose variance is half the variance of one; and the mean of
 * endlessly many differs from the first by that whole variance. Noise that is spread evenly over frames, as a sequence of low
 * discrepancy is, differs more from one frame to the next, and comes out larger here than it is.
 *
 * Returns the root mean square over surfaces and channels, relative to that of the truth as lit_rmse is, of the set of `open`
 * for which it is the largest; so no set comes nearer to the truth by more than that through a mean over time. */
double aob_effect_noise(const struct aob_seen *seen, const struct aob_drawn *drawn, unsigned open);
#endif
