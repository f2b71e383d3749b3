/* Pictures in colour: three channels of an image each, and the exposure that technique and reference share. */
#ifndef AOB_REPORTS_PLOT_FIGURE_COLOUR_H
#define AOB_REPORTS_PLOT_FIGURE_COLOUR_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"
#include "figure_image.h"
#include "viz.h"

/* From the figure's members technique, reference, exposure and alone (figure.h), into the triptych's pictures and exposure.
 * False with a line that names a channel which the image lacks. */
bool aob_figure_take_colours(struct aob_viz_triptych *triptych, const struct aob_figure_image *from,
                             const json_t *figure, struct aob_error *error);
#endif
