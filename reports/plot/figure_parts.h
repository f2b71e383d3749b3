/* The parts of a technique's error as images: definition (definition.AO less the truth), missing information
 * (screen.AO less definition.AO) and estimator (technique.AO less screen.AO). Their sum is the error. */
#ifndef AOB_REPORTS_PLOT_FIGURE_PARTS_H
#define AOB_REPORTS_PLOT_FIGURE_PARTS_H
#include <stdbool.h>
#include "base/error.h"
#include "figure_image.h"

enum { AOB_PARTS = 3 };

/* width * height floats each, 0 where the image's Z is infinite (sky); start from zero. */
struct aob_parts {
    float *maps[AOB_PARTS];
};

/* Has the image the channels that only a split error needs? */
bool aob_parts_exist(const struct aob_image *image);

/* False if a channel is not there; the line names it but not the image. */
bool aob_parts_init(struct aob_parts *parts, const struct aob_figure_image *from, struct aob_error *error);
void aob_parts_finish(struct aob_parts *parts);
#endif
