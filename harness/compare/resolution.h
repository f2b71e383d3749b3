/* What can be resolved on a machine in how many seconds, from what its rounds show (noise.h). */
#ifndef AOB_COMPARE_RESOLUTION_H
#define AOB_COMPARE_RESOLUTION_H
#include <jansson.h>
#include "base/text.h"
#include "noise.h"
#include "timing/rounds.h"

enum { AOB_RESOLUTION_STEPS = 5 };
/* 1, 2, 3, 5 and 10 %, as shares. */
extern const double aob_resolution_steps[AOB_RESOLUTION_STEPS];

struct aob_resolution {
    struct aob_noise control; /* the fixed pass against itself */
    struct aob_noise cost;    /* the case against the fixed pass */
    double clean;             /* share of slots without a context switch or stolen time */
    double round_s;           /* wall time of a round, a case */
    double seconds
        [AOB_RESOLUTION_STEPS]; /* of timing a case, shared among processes as timing/processes.h does, until its
                                              interval reaches so far to each side; INFINITY: not in 1e6 */
    double
        recommended; /* the smallest step that takes no more seconds than a case has by default; NAN: none */
};

/* From the rounds of at least two processes with one case each. `default_s`: what a case has by default. */
struct aob_resolution aob_resolution_of(const struct aob_round_list *rounds, double default_s);
void aob_resolution_print(const struct aob_resolution *resolution, struct aob_text *out);
json_t *aob_resolution_to_json(const struct aob_resolution *resolution); /* a new object */
#endif
