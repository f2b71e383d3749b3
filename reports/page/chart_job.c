#include "chart_job.h"
#include <math.h>
#include <stdio.h>

void aob_span_include(struct aob_span *span, double value)
{
    span->low = fmin(span->low, value);
    span->high = fmax(span->high, value);
}

json_t *aob_chart_axis(const char *label, struct aob_span span, double factor)
{
    bool log = span.low > 0 && span.high / span.low >= factor;
    char text[160];
    snprintf(text, sizeof text, "%s%s)", label, log ? ", log scale" : "");
    return json_pack("{s:s, s:b}", "label", text, "log", (int)log);
}

struct aob_figure *aob_chart_add(struct aob_gallery *gallery, const struct aob_panel *panel,
                                 enum aob_figure_kind kind, const char *name, json_t *job)
{
    json_t *copy = json_copy(job);
    aob_gallery_add(gallery, panel, kind, name, ".svg", job);
    aob_gallery_add(gallery, panel, kind, name, ".png", copy);
    return &gallery->figures[gallery->count - 2];
}
