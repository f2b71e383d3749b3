/* The charts of a report: what time and misses follow from, and what accuracy costs. */
#ifndef AOB_REPORTS_PAGE_CURVES_H
#define AOB_REPORTS_PAGE_CURVES_H
#include "base/text.h"
#include "gallery.h"

/* What the x axis of a chart may be. */
struct aob_curve_axis {
    const char *name, *label, *title;           /* "radius (scene units" without the bracket; "radius" */
    double (*value)(const struct aob_row *row); /* NaN: the row has none */
    const char *const *words;                   /* parameters that make up the value */
};
/* Ended by a NULL name: the radius, the number of depth samples a pixel (samples, directions x steps, slices x steps x 2,
 * directions x rays x steps) and the megapixels. */
extern const struct aob_curve_axis aob_curve_axes[];

struct aob_curve_point {
    double x, y;
    double low, high; /* ends of a bar; NAN: none */
};
struct aob_curves_desc {
    const char *name; /* of the figure's file */
    enum aob_figure_kind kind;
    const struct aob_curve_axis *axis;
    const char *title, *label; /* "Time", the y axis without its last bracket: "time a frame (ms" */
    const char *bars;          /* what they are: "95 % interval" */
    bool (*measure)(
        const struct aob_row *row, const void *user,
        struct aob_curve_point *point); /* fills in all but x; false: the row has no such figure */
    const void *user;
    void (*note)(const struct aob_curve_point *points, size_t count,
                 struct aob_text *text); /* adds what is said of a curve below the chart; NULL: nothing is */
};
/* Curves of the panel's section, wherever cases differ in nothing but the axis; no chart where there is none. At most 8
 * curves a chart: each technique's first, in the order of backends; the subtitle tells if some are left out. */
void aob_curves_add(struct aob_gallery *gallery, const struct aob_panel *panel,
                    const struct aob_curves_desc *desc);

/* Times over each axis. */
void aob_curves_add_timing(struct aob_gallery *gallery, const struct aob_panel *panel);

/* Cache figures over each axis: for each profile misses of the first level, and fills and bytes of the last, a pixel. */
void aob_curves_add_cache(struct aob_gallery *gallery, const struct aob_panel *panel);

/* The knee of misses over the radius: the x at which a curve has risen to half of its plateau, the largest y, between two
 * points by their logarithms. NAN where it begins above that, or still rises by more than a tenth at its end, so that the
 * plateau is not known. Points by x, rising. */
double aob_curve_knee(const struct aob_curve_point *points, size_t count);

/* Quality against cost of one section, against the panel's target, one chart for each image size: time and band RMSE of
 * all cases on the section's backend, with the Pareto front. */
void aob_curves_add_quality(struct aob_gallery *gallery, const struct aob_panel *panel);
#endif
