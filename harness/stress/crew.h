/* The workers of a run of `stress`: each asks one row at a time, as many at once as the machine has cores. A worker that dies
 * fails the property that it was at, and another goes on behind it. */
#ifndef AOB_STRESS_CREW_H
#define AOB_STRESS_CREW_H
#include "cell.h"
#include "run/dispatch.h"
#include "run/progress.h"

struct aob_crew_desc {
    const struct aob_dispatch *dispatch;
    struct aob_stress_row
        *rows; /* filled in; cells that nobody could ask stay not applicable, with the reason */
    size_t count;
    bool quick;
    const char *images; /* folder; NULL: none */
    struct aob_progress *progress;
};
void aob_crew_run(const struct aob_crew_desc *desc);
#endif
