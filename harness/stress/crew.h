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

/* One thread of the driver and of the tracer for each worker: there are as many workers as cores. NULL-ended; `backend` may be
 * NULL. */
enum { AOB_CREW_ENVIRONMENT = 32 };
void aob_crew_environment(const char *backend, const char *env[AOB_CREW_ENVIRONMENT]);

/* Runs `work` on as many threads as the machine has cores, at most `most` and at least this one, until all have returned. */
void aob_crew_share(void *(*work)(void *user), void *user, size_t most);
#endif
