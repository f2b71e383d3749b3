/* What a frame of a technique drew, and the lit image of any set of effects made of it: the same as the device's composite gives
 * (technique/composite.h), but for what half floats round. A frame with every effect holds what each set of its size needs, because
 * an effect is the same to the bit whatever is drawn beside it. */
#ifndef AOB_EFFECTS_DRAWN_H
#define AOB_EFFECTS_DRAWN_H
#include "effect_row.h"
#include "seen.h"

struct aob_drawn_surface { /* what is not drawn is NAN */
    float visible, lobe;
    float bounced[3], light[3], bent[3];
};
struct aob_drawn {
    struct aob_drawn_surface *surfaces; /* those of the view, in its order */
};

/* From the image of a frame of this view. False after a line. aob_drawn_finish frees. */
bool aob_drawn_read(struct aob_drawn *drawn, const struct aob_seen *seen, const char *image,
                    struct aob_error *error);
void aob_drawn_finish(struct aob_drawn *drawn);

/* The radiance that surface i shows with a set; `drawn` may be NULL for the empty set. */
void aob_drawn_light(const struct aob_seen *seen, const struct aob_drawn *drawn, unsigned set, size_t i,
                     double rgb[3]);

/* How far the lit image of a set is from the truth. */
struct aob_lit_error {
    double
        rmse; /* relative, as metric lit_rmse, with the noise of the truth taken out: an estimate of what endless rays would
                      * give; 0 where it comes out below */
    double
        rmse_se; /* its standard error by that noise; the noise of the mean light is left out, which counts less by the error */
    double flip; /* FLIP in colour of both images, made smaller until a pixel has enough rays */
};
struct aob_lit_error aob_drawn_error(const struct aob_seen *seen, const struct aob_drawn *drawn,
                                     unsigned set);
#endif
