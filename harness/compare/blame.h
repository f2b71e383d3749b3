/* What changed between two stored runs besides the module. Their cases were measured at two times, perhaps by two
 * programs, and cases whose technique is the same in both are the control of that: if they moved, the machine or the
 * harness did. */
#ifndef AOB_COMPARE_BLAME_H
#define AOB_COMPARE_BLAME_H
#include <stdbool.h>
#include <stddef.h>
#include "base/statistics.h"
#include "verdict.h"

struct aob_blame_couple {
    struct aob_ratio cost; /* B / A, with the interval that decides */
    enum aob_verdict verdict;
    double delta;    /* that it was judged by */
    bool same_build; /* the technique is the same build in both */
};
struct aob_blame {
    char text[300]; /* what is to blame in place of the module; empty: nothing is */
    bool excused;   /* nothing that was compared changed: the couple is no regression */
};

/* For each couple that is FASTER or SLOWER. One of one build has no other module that could be to blame: the same program
 * leaves the machine, another one leaves both. One of another module is excused if the couples of one build moved as well,
 * and it did not move beyond their median. */
void aob_blame_find(const struct aob_blame_couple *couples, size_t count, bool same_program,
                    struct aob_blame *blames);
#endif
