/* What two cases cost beside one another, from their records and the raw rounds that their runs keep. */
#ifndef AOB_COMPARE_COST_H
#define AOB_COMPARE_COST_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "base/statistics.h"

struct aob_cost_side {
    const char *folder;   /* of its run */
    const json_t *record; /* a journal line */
};
struct aob_cost {
    struct aob_ratio cost, control; /* B / A, and the fixed pass against itself, the wider of two; 95 % */
    size_t rounds, processes;       /* of the side that has fewer */
    double fixed;                   /* the fixed pass' own time, B / A; NAN: not known. 1 in one block */
    bool paired; /* both were timed in the same rounds: the ratio is taken in each of them */
};

/* Paired where both are of one block whose rounds are kept; else the quotient of their ratios to the fixed pass (quotient.h),
 * estimated from raw rounds where both runs keep them and read from the journal otherwise. False with the reason why the
 * times cannot be compared: one has none, or is wall time as its device's clock failed its test, or they were measured by different clocks, devices, numbers of threads or
 * fixed passes. */
bool aob_cost_compare(const struct aob_cost_side *a, const struct aob_cost_side *b, struct aob_cost *cost,
                      struct aob_error *why);
#endif
