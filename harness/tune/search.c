#include "search.h"
#include <math.h>
#include <nlopt.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"

/* What a model is made of must be finite. An RMSE of visibility is 1 at most. Models are quadratic, and near its least value a root mean
 * square is a cone where its square is a bowl, so searches see the square: it is least at the same place. */
static const double refused = 2;

/* Closer than this two places draw the same to the eye. */
static const double near = 1e-4;

/* A search that makes the error less by a smaller share than this is at its end. */
static const double gain = 1e-3;

struct search {
    const struct aob_search_desc *desc;
    double *best, least;
    int done;
};

static double measure(unsigned count, const double *place, double *gradient, void *user)
{
    struct search *search = user;
    (void)gradient; /* no search here asks for one */
    double error = search->desc->measure(search->desc->user, place);
    search->done++;
    if (error < search->least) {
        search->least = error;
        memcpy(search->best, place, count * sizeof *place);
    }
    return isfinite(error) ? error * error : refused;
}

/* An early end, such as a model that rounding leaves without a step, is no failure: the best place is kept by `measure`. */
static void look(struct search *search, nlopt_algorithm algorithm, double step, int measurements)
{
    const struct aob_search_desc *desc = search->desc;
    unsigned count = (unsigned)desc->count;
    double least, *place = AOB_NEW_ARRAY(double, count);
    nlopt_opt nlopt = nlopt_create(algorithm, count);
    memcpy(place, search->best, count * sizeof *place);
    nlopt_set_lower_bounds1(nlopt, 0);
    nlopt_set_upper_bounds1(nlopt, 1);
    nlopt_set_min_objective(nlopt, measure, search);
    nlopt_set_maxeval(nlopt, measurements);
    nlopt_set_xtol_abs1(nlopt, near);
    nlopt_set_initial_step1(nlopt, step);
    nlopt_optimize(nlopt, place, &least);
    nlopt_destroy(nlopt);
    free(place);
}

/* Parameters that do nearly the same make a bent valley, in which a model's steps become short before its end is reached. So another model
 * begins where one ended, and the other kind of search where that gains nothing. */
static void descend(struct search *search)
{
    const struct aob_search_desc *desc = search->desc;
    const int last = search->done + desc->local;
    /* BOBYQA's model needs two coordinates. */
    bool model = desc->count > 1;
    while (search->done < last) {
        const double before = search->least;
        const int begun = search->done;
        look(search, model ? NLOPT_LN_BOBYQA : NLOPT_LN_NELDERMEAD, desc->step, last - search->done);
        const bool gained = search->least < before * (1 - gain);
        if (search->done == begun || (!gained && !model))
            break;
        model = model && gained;
    }
}

double aob_search_run(const struct aob_search_desc *desc, double *best)
{
    struct search search = {desc, best, INFINITY, 0};
    memcpy(best, desc->start, desc->count * sizeof *best);
    measure((unsigned)desc->count, desc->start, NULL, &search);
    if (desc->global)
        look(&search, NLOPT_GN_DIRECT_L, desc->step, desc->global);
    descend(&search);
    return search.least;
}
