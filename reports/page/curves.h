/* The charts of a report: what time follows from, and what accuracy costs. */
#ifndef AOB_REPORTS_PAGE_CURVES_H
#define AOB_REPORTS_PAGE_CURVES_H
#include "gallery.h"

/* Timing curves of the panel's section: over the radius, the number of depth samples a pixel (samples, directions x
 * steps, slices x steps x 2, directions x rays x steps) and the megapixels, wherever cases differ in nothing
 * else. At most 8 curves a chart: each technique's first, in the order of backends; the subtitle tells if
 * some are left out. */
void aob_curves_add_timing(struct aob_gallery *gallery, const struct aob_panel *panel);

/* Quality against cost of one section, against the panel's target, one chart for each image size: time and band RMSE of
 * all cases on the section's backend, with the Pareto front. */
void aob_curves_add_quality(struct aob_gallery *gallery, const struct aob_panel *panel);
#endif
