/* The fixed reference pass: every block is timed against it, and costs are reported as ratios to it, so that
 * records of one machine can be joined. It is laid out like a technique but listed nowhere. */
#ifndef AOB_TIMING_FIXED_PASS_H
#define AOB_TIMING_FIXED_PASS_H
#include <aobudget/technique.h>

extern const struct aob_technique aob_technique_fixed_pass; /* its revision is part of the fingerprint */
#endif
