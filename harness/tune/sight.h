/* A view on a device of its own, on which one technique is drawn again and again with other values and compared with one truth. */
#ifndef AOB_TUNE_SIGHT_H
#define AOB_TUNE_SIGHT_H
#include "job/tune_job.h"
#include "worker/drawing.h"

struct aob_sight_pixel {
    size_t at; /* of the image, the guard band left out */
    float truth;
};
struct aob_tune_sight {
    struct aob_drawing drawing;
    struct aob_drawing_part part;
    struct aob_frame frame; /* while `built` */
    bool built;
    struct aob_sight_pixel *pixels; /* those in band: surfaces whose truth is below AOB_BAND_LIMIT */
    size_t count;
    float *image;
};

/* Opens the device and reads G-buffer and truth. False after a line; aob_tune_sight_close is to be called either way, and `view` must
 * outlive it. */
bool aob_tune_sight_open(struct aob_tune_sight *sight, const struct aob_tune_view *view,
                         struct aob_error *error);
void aob_tune_sight_close(struct aob_tune_sight *sight); /* of a zeroed one too */

/* Draws the technique with these values, one a row of its table. Where only uniforms differ from the values before, no pass is made
 * again. False after a line: the technique refuses the values, the device fails, or the image is no visibility. */
bool aob_tune_sight_draw(struct aob_tune_sight *sight, const double *values, size_t count,
                         struct aob_error *error);

/* The RMSE in band of what was drawn; NAN where the view has no pixel in band. */
double aob_tune_sight_error(const struct aob_tune_sight *sight);
#endif
