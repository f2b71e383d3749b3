/* Mean structural similarity (Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli: Image Quality Assessment: From
 * Error Visibility to Structural Similarity. IEEE Transactions on Image Processing 13(4), 2004, equation 13), with
 * the paper's figures: window of 11 x 11 pixels, Gaussian of sigma 1.5 and sum 1; K1 = 0.01, K2 = 0.03; L = 1, as
 * visibility is 0..1. Pixels are compared as they are, at full resolution. */
#ifndef AOB_SCORE_SSIM_H
#define AOB_SCORE_SSIM_H
#include "score.h"

/* Compares desc's image and truth. The result is -1..1, and 1 only if they are equal: the mean over the pixels that
 * are not sky and whose window lies inside the image, or NAN if there is none. The sky in a window is 1 in both
 * images, whatever they hold there. All other pixels are 0..1, as aob_score_judge has found. */
double aob_ssim(const struct aob_score_desc *desc);
#endif
