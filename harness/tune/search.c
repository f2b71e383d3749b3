#include "search.h"
#include <math.h>
#include <nlopt.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

/* What a model of the error is made of must be finite. An RMSE of visibility is 1 at most. */
static const double refused = 2;

/* Closer than this two places draw the same to the eye. */
static const double near = 1e-4;

struct search {
    const struct aob_search_desc *desc;
    double *best, least;
};

static double measure(unsigned count, const double *place, double *gradient, void *user)
{
    struct search *search = user;
    (void)gradient; /* neither search asks for one */
    double error = search->desc->measure(search->desc->user, place);
    if (error < search->least) {
        search->least = error;
        memcpy(search->best, place, count * sizeof *place);
    }
    return isfinite(error) ? error : refused;
}

/* An early end, such as a model that rounding leaves without a step, is no failure: the best place is kept by `measure`. */
static void look(struct search *search, nlopt_algorithm algorithm, int measurements)
{
    const struct aob_search_desc *desc = search->desc;
    unsigned count = (unsigned)desc->count;
    double least, *place = AOB_NEW_ARRAY(double, count);
    if (measurements > 0) {
        nlopt_opt nlopt = nlopt_create(algorithm, count);
        memcpy(place, search->best, count * sizeof *place);
        nlopt_set_lower_bounds1(nlopt, 0);
        nlopt_set_upper_bounds1(nlopt, 1);
        nlopt_set_min_objective(nlopt, measure, search);
        nlopt_set_maxeval(nlopt, measurements);
        nlopt_set_xtol_abs1(nlopt, near);
        nlopt_set_initial_step1(nlopt, desc->step);
        nlopt_optimize(nlopt, place, &least);
        nlopt_destroy(nlopt);
    }
    free(place);
}

double aob_search_run(const struct aob_search_desc *desc, double *best)
{
    struct search search = {desc, best, INFINITY};
    memcpy(best, desc->start, desc->count * sizeof *best);
    measure((unsigned)desc->count, desc->start, NULL, &search);
    look(&search, NLOPT_GN_DIRECT_L, desc->global);
    /* BOBYQA's model needs two coordinates. */
    look(&search, desc->count > 1 ? NLOPT_LN_BOBYQA : NLOPT_LN_NELDERMEAD, desc->local);
    return search.least;
}
