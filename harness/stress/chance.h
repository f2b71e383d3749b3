/* Numbers that look random and are the same for the same name, on every machine. Threads: one at a time for each. */
#ifndef AOB_STRESS_CHANCE_H
#define AOB_STRESS_CHANCE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/vec.h"

struct aob_chance {
    uint64_t key, drawn;
};
struct aob_chance aob_chance_of(const char *name);

size_t aob_chance_below(struct aob_chance *chance, size_t n); /* 0..n-1 */
bool aob_chance_once_in(struct aob_chance *chance, size_t n); /* true once in n times */
double aob_chance_unit(struct aob_chance *chance);            /* 0 <= x < 1 */
double aob_chance_between(struct aob_chance *chance, double low, double high);
double aob_chance_log(struct aob_chance *chance, double low,
                      double high);                              /* even in the logarithm; both above 0 */
struct aob_vec3 aob_chance_direction(struct aob_chance *chance); /* unit, even on the sphere */
#endif
