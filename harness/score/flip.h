/* Mean LDR-FLIP of two grey images (P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D.
 * Fairchild: FLIP: A Difference Evaluator for Alternating Images. Proceedings of the ACM on Computer Graphics and
 * Interactive Techniques 3(2), HPG 2020), with the paper's constants: how much one notices in a pixel when the two
 * images take turns on the screen, 0 (nothing) to 1.
 *
 * Transfer: visibility is linear light. It is looked at as the grey R = G = B = visibility of linear sRGB, which is
 * what a white surface shows in light of luminance 1 from everywhere. Another program gives the same figures for
 * files of the sRGB-encoded values; others for files that hold visibility itself as the code of a pixel.
 *
 * The opponent channels Cx and Cz of such a grey are 0, as are a* and b*. So nothing is left of their two filters, of
 * Hunt's adjustment and of the Euclidean part of HyAB: the colour difference is |L1* - L2*|. It is scaled by the
 * largest HyAB that the paper knows, that of green and blue, in which Hunt's adjustment does count.
 *
 * The outermost pixels repeat beyond the edges. */
#ifndef AOB_SCORE_FLIP_H
#define AOB_SCORE_FLIP_H
#include "score.h"

/* The paper's observer: 0.7 m from a screen 0.7 m wide with 3840 pixels across. */
#define AOB_FLIP_PIXELS_PER_DEGREE (0.7 * 3840 / 0.7 * 3.14159265358979323846 / 180)

/* Compares desc's image and truth; their order does not matter. Returns the mean over the pixels that are not sky, or
 * NAN if there is none. The filters see the sky as 1 in both images, whatever they hold there. All other pixels are
 * 0..1, as aob_score_judge has found. */
double aob_flip(const struct aob_score_desc *desc);
#endif
