/* For plan.c: the axes of one technique or of the options, with their values parsed, and the walk over their product. */
#ifndef AOB_PLAN_AXES_H
#define AOB_PLAN_AXES_H
#include <aobudget/technique.h>
#include "base/error.h"
#include "config/config.h"

struct aob_plan_axes {
    struct aob_plan_axis {
        size_t row; /* of the parameter table */
        double *values;
        size_t count, at;
    } * items;
    size_t count;
};
struct aob_plan_axes_desc {
    const struct aob_config *config; /* for positions */
    const char *owner;               /* "gtao", "options" */
    const struct aob_param *params;
    size_t param_count;
    const struct aob_axis *from; /* the config's */
    size_t count;
};

/* Every value judged by its row of the table. False: a line with the position of what is wrong; the axes are empty. */
bool aob_plan_axes_init(struct aob_plan_axes *axes, const struct aob_plan_axes_desc *desc,
                        struct aob_error *error);
void aob_plan_axes_finish(struct aob_plan_axes *axes);

/* Write the values of the current point into their rows; step to the next point, the last axis fastest. False at the
 * end, and the first point is the current one again. */
void aob_plan_axes_apply(const struct aob_plan_axes *axes, double *values);
bool aob_plan_axes_next(struct aob_plan_axes *axes);
#endif
