/* What a technique claims to compute, tabulated, so that the ray tracer needs none of its code. */
#ifndef AOB_TECHNIQUE_DEFINITION_H
#define AOB_TECHNIQUE_DEFINITION_H
#include <aobudget/technique.h>
#include "base/error.h"

/* Rows of a falloff over the root of the distance: Alchemy's peak lies at sqrt(epsilon)/r. */
enum { AOB_FALLOFF_ROWS = 1025 };

struct aob_definition_table {
    bool claims; /* false: it has no radius to trace, and the rest says nothing */
    bool uniform, of_triangle;
    bool fades;   /* false: an occluder within the radius counts 1, and there is no table */
    float radius; /* scene units, above 0; may be infinite */
    float falloff[AOB_FALLOFF_ROWS]; /* row i: at (i / (AOB_FALLOFF_ROWS - 1))^2 of the radius */
};

/* Runs the definition's functions (module code). False after a line that does not name the technique: a radius or a
 * falloff that makes no sense. */
bool aob_definition_tabulate(const struct aob_technique *technique, const void *values,
                             struct aob_definition_table *table, struct aob_error *error);
#endif
