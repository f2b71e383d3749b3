/* Levels of a line of nightly figures: where it shifted, by the weighted L1 Potts functional. */
#ifndef AOB_HISTORY_LEVEL_H
#define AOB_HISTORY_LEVEL_H
#include <stddef.h>

struct aob_levels {
    size_t *starts; /* place of each level's first value; starts[0] is 0 */
    double *values; /* weighted median of each level */
    size_t count;
};

/* The levels of n values (logarithms of ratios) with weights above 0, in their order. n = 0: none. aob_levels_finish frees. */
void aob_levels_fit(const double *values, const double *weights, size_t n, struct aob_levels *levels);
void aob_levels_finish(struct aob_levels *levels);
#endif
