#include <math.h>
#include "curves.h"

/* The interval of the ratio, moved to the time. */
static double bar_end(const struct aob_row *row, double end)
{
    return isfinite(row->ratio) && row->ratio > 0 ? row->cost_ms * end / row->ratio : NAN;
}

static bool measure(const struct aob_row *row, const void *user, struct aob_curve_point *point)
{
    (void)user;
    point->y = row->cost_ms;
    point->low = bar_end(row, row->ci_low);
    point->high = bar_end(row, row->ci_high);
    return row->cost_ms > 0 && isfinite(row->cost_ms);
}

void aob_curves_add_timing(struct aob_gallery *gallery, const struct aob_panel *panel)
{
    for (const struct aob_curve_axis *axis = aob_curve_axes; axis->name; axis++)
        aob_curves_add(gallery, panel,
                       &(struct aob_curves_desc){.name = axis->name,
                                                 .kind = AOB_FIGURE_CHART,
                                                 .axis = axis,
                                                 .title = "Time",
                                                 .label = "time a frame (ms",
                                                 .bars = "95 % interval",
                                                 .measure = measure});
}
