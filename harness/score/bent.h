/* The error of bent normals against the traced mean of the open directions. It is an angle, because a bent normal is
 * used by its direction, and techniques give it lengths of their own. */
#ifndef AOB_SCORE_BENT_H
#define AOB_SCORE_BENT_H
#include "score.h"

/* Three floats a pixel, view space. A surface counts where the truth is longer than this: in a nearly closed place its
 * direction is noise. */
#define AOB_BENT_LEAST 0.05

/* Whether a vector can be a mean open direction: it is finite and not longer than 1 (within 1 %). */
bool aob_bent_is_sound(const float bent[3]);

/* False with a line if a vector over a surface is not finite or longer than 1 (within 1 %). */
bool aob_bent_judge(const struct aob_score_desc *desc, const float (*image)[3], struct aob_error *error);

/* What bent normals are compared with. */
struct aob_bent_truth {
    const float (*open)[3];   /* the traced mean of the open directions */
    const float (*normal)[3]; /* the surface's own normal */
};

/* Degrees between two directions; a right angle where one of them is none. */
double aob_bent_angle(const float a[3], const float b[3]);

/* Whether a surface of this mean open direction counts. */
bool aob_bent_counts(const float open[3]);

/* Sets the metrics whose names begin with bent_; desc has the truth's visibility and says where the sky is. An image that is 0
 * (closed) where the truth is open is off by a right angle. Means are NAN if no pixel counts. */
void aob_bent_score(const struct aob_score_desc *desc, const float (*image)[3],
                    const struct aob_bent_truth *truth, struct aob_metrics *metrics);
#endif
