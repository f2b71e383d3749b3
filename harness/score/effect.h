/* The errors of the outputs that are light, or a share of it: visibility after bounces, specular occlusion, irradiance, the lit
 * image. Each has a traced truth of its own. The error of visibility after bounces is in units of visibility; the others are relative,
 * a root of the mean square over that of the truth, since light has no scale of its own and a lobe may be open throughout.
 * Over colours an error is the mean of the channels' squares. */
#ifndef AOB_SCORE_EFFECT_H
#define AOB_SCORE_EFFECT_H
#include "score.h"

/* What a technique wrote as one output, and what that is compared with: `components` floats a pixel each. */
struct aob_effect {
    enum aob_output output; /* AOB_OUT_VISIBILITY_RGB, _SPECULAR, _IRRADIANCE or _LIT */
    int components;         /* 3; of specular 1 */
    const float *image, *truth, *se;
    const float *plain; /* what the technique's own visibility stands for without the effect */
    double
        exposure; /* of the lit image: what both are multiplied by when they are looked at (aob_light_exposure) */
    const float *model; /* what its formula makes of the true visibility; NULL: there is no such formula */
};

/* False with a line if the image cannot be such an output: over a surface a share must be finite and within 0..1 (within 1 %),
 * light finite and not negative. Reads output, components and image. */
bool aob_effect_judge(const struct aob_score_desc *desc, const struct aob_effect *effect,
                      struct aob_error *error);

/* Sets the metrics of the output; desc has the true visibility, which says what is in the band, and where the sky is. */
void aob_effect_score(const struct aob_score_desc *desc, const struct aob_effect *effect,
                      struct aob_metrics *metrics);

/* Light after bounces at an open share v of it between surfaces of a diffuse albedo, by the fit of Jimenez et al. 2016 (GTAO):
 * max(v, ((v a + b) v + c) v), a = 2.0404 albedo - 0.3324, b = -4.7951 albedo + 0.6417, c = 2.7552 albedo + 0.6903. */
double aob_effect_bounced(double v, double albedo);
#endif
