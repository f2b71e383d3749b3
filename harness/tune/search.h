/* The search for the place of least error in a box, without derivatives (NLopt): the whole box first (DIRECT-L), and then around the
 * best place of that (BOBYQA). Both are deterministic: the same measurements give the same result. Places have coordinates from 0 to
 * 1. Pure but for what `measure` does. */
#ifndef AOB_TUNE_SEARCH_H
#define AOB_TUNE_SEARCH_H
#include <stddef.h>
#include "base/error.h"

struct aob_search_desc {
    size_t count;        /* of coordinates, 1 at least */
    const double *start; /* a place that is measured first, so that the result is no worse */
    int global, local;   /* measurements, at most; 0: that search is left out */
    double step;         /* of the local search at first, in (0, 0.5] */
    double (*measure)(void *user, const double *place); /* INFINITY: nothing can be drawn there */
    void *user;
};

/* The best place that was measured, into `best`; returns its error, INFINITY where no place could be measured. */
double aob_search_run(const struct aob_search_desc *desc, double *best);
#endif
