/* Whose time the costs of a run are, on each of its backends. The first process that times on a backend chooses the clock
 * (timing/timer.h), and all others of the run are told: two blocks by two clocks could not be compared. Device, driver and
 * machine are the same all the time. */
#ifndef AOB_RUN_RUN_CLOCK_H
#define AOB_RUN_RUN_CLOCK_H
#include <jansson.h>
#include <stddef.h>
#include "base/clock.h"

struct aob_run_clock {
    const char *backend; /* the plan's text */
    enum aob_clock clock;
    char reason[256]; /* why it is wall time; else empty */
};
struct aob_run_clocks { /* zeroed: none; free with aob_run_clocks_finish */
    struct aob_run_clock *items;
    size_t count, capacity;
};
const struct aob_run_clock *aob_run_clocks_find(const struct aob_run_clocks *clocks, const char *backend);

/* Keeps what the first process says; of later ones nothing. One that has a reason is told in a warning, so there is one for
 * each such device and run. */
void aob_run_clocks_keep(struct aob_run_clocks *clocks, const char *backend, enum aob_clock clock,
                         const char *reason);

/* The same by a record of this run's folder, so that a run that goes on has one clock too. One without a time says nothing. */
void aob_run_clocks_take(struct aob_run_clocks *clocks, const char *backend, const json_t *record);
void aob_run_clocks_finish(struct aob_run_clocks *clocks);
#endif
