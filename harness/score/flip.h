/* Mean LDR-FLIP of two images (P. Andersson, J. Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild:
 * FLIP: A Difference Evaluator for Alternating Images. Proceedings of the ACM on Computer Graphics and Interactive
 * Techniques 3(2), HPG 2020), with the paper's constants: how much one notices in a pixel when the two images take turns
 * on the screen, 0 (nothing) to 1. Green against blue, all over and at full strength, is 1.
 *
 * Transfer: an image is linear light. Visibility is looked at as the grey R = G = B = visibility of linear sRGB, which is
 * what a white surface shows in light of luminance 1 from everywhere. Another program gives the same figures for files
 * of the sRGB-encoded values; others for files that hold visibility itself as the code of a pixel.
 *
 * The opponent channels Cx and Cz of a grey are 0, as are a* and b*. So nothing is left of their two filters, of Hunt's
 * adjustment and of the Euclidean part of HyAB: the colour difference of greys is |L1* - L2*|. It is scaled by the
 * largest HyAB that the paper knows, that of green and blue, in which Hunt's adjustment does count.
 *
 * The outermost pixels repeat beyond the edges. The filters see the sky as white in both images, whatever they hold
 * there. A mean is over the pixels that are not sky, NAN if there is none, and the same whichever image comes first. */
#ifndef AOB_SCORE_FLIP_H
#define AOB_SCORE_FLIP_H
#include "score.h"

/* The paper's observer: 0.7 m from a screen 0.7 m wide with 3840 pixels across. */
#define AOB_FLIP_PIXELS_PER_DEGREE (0.7 * 3840 / 0.7 * 3.14159265358979323846 / 180)

/* Of desc's image and truth, which are visibility: 0..1 in each pixel that is not sky, as aob_score_judge has found. */
double aob_flip(const struct aob_score_desc *desc);

/* Of two images in colour. Each is width x height pixels of three floats, R G B, in linear light of sRGB's primaries, row 0
 * at the top. `exposure` multiplies the light of both; what is then below 0 or above 1 is cut, as a screen does. A pixel
 * that is not sky holds no NaN. Of desc this reads the size and where the sky is; its image and truth may be NULL. For
 * R = G = B at exposure 1 it is aob_flip of that grey, to rounding. */
double aob_flip_colour(const struct aob_score_desc *desc, const float *image, const float *truth,
                       double exposure);
#endif
