/* Which parameters of a technique are fitted, and between which values. */
#ifndef AOB_TUNE_AXES_H
#define AOB_TUNE_AXES_H
#include "job/tune_job.h"
#include "technique/registry.h"

struct aob_tune_axes {
    struct aob_tune_axis items[AOB_MAX_PARAM];
    size_t count;
};

/* Whether a fit without a list of names looks at a parameter: it is a float, a uniform, shapes the visibility, and is neither a length
 * in pixels, whose right value depends on the size of the image, nor the seed of a noise. */
bool aob_tune_axes_wants(const struct aob_param *param);

struct aob_tune_axes_desc {
    const struct aob_technique_info *technique;
    const double *start; /* a value for each row of its table */
    const char *names;   /* "a,b"; NULL: all that are wanted */
    const bool *stated;  /* rows that the config gives one value, and which stay unless they are named */
};

/* A parameter whose range reaches far beyond where it starts, and every length, is searched between 1/16 and 16 times that, by its
 * logarithm; another one over the range of its table. False after a line: a name is none of the technique's, stands twice or is no float,
 * or there is nothing to fit. */
bool aob_tune_axes_choose(struct aob_tune_axes *axes, const struct aob_tune_axes_desc *desc,
                          struct aob_error *error);

/* The value at a share of the way from low to high, as a float's value; and the share of a value, within 0 to 1. */
double aob_tune_axis_value(const struct aob_tune_axis *axis, double place);
double aob_tune_axis_place(const struct aob_tune_axis *axis, double value);

/* Lets it start at a value, with that in the middle of a box by the logarithm, as far as the table allows. */
void aob_tune_axis_centre(struct aob_tune_axis *axis, const struct aob_param *param, double value);
#endif
