/* The error of an image of visibility against a closed form, for scenes that have one. */
#ifndef AOB_SCORE_ORACLE_SCORE_H
#define AOB_SCORE_ORACLE_SCORE_H
#include "gbuffer/gbuffer.h"
#include "reference/oracle_scene.h"

struct aob_oracle_desc {
    const struct aob_oracle *oracle;
    const struct aob_camera *camera;
    const struct aob_gbuffer *gbuffer; /* the canonical one: it says where on the scene a pixel is */
    double radius;                     /* scene units; INFINITY allowed */
};
struct aob_oracle_score {
    double rmse, bias;          /* over the pixels whose point has a closed form; NAN if there is none */
    double band_rmse;           /* of these, where the closed form is below AOB_BAND_LIMIT */
    size_t pixels, band_pixels; /* how many */
};

/* `image` has the view's pixels, which are the G-buffer's without its guard band, row 0 at the top. Sky and values
 * that are not finite do not count. */
void aob_oracle_score(const struct aob_oracle_desc *desc, const float *image, struct aob_oracle_score *score);
#endif
