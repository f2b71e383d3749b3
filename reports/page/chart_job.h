/* What the charts of a report share. */
#ifndef AOB_REPORTS_PAGE_CHART_JOB_H
#define AOB_REPORTS_PAGE_CHART_JOB_H
#include "gallery.h"

struct aob_span {
    double low, high;
};
#define AOB_SPAN_EMPTY ((struct aob_span){__builtin_huge_val(), -__builtin_huge_val()})
void aob_span_include(struct aob_span *span, double value);

/* "label)" or "label, log scale)": logarithmic if the span is positive and its ends differ by `factor` or
 * more. */
json_t *aob_chart_axis(const char *label, struct aob_span span, double factor);

/* The chart twice: the returned SVG for the page, and a PNG for slides. Takes `job` over. */
struct aob_figure *aob_chart_add(struct aob_gallery *gallery, const struct aob_panel *panel,
                                 enum aob_figure_kind kind, const char *name, json_t *job);
#endif
