/* `aobudget run`: a sweep from its config to the page. */
#ifndef AOB_RUN_RUN_H
#define AOB_RUN_RUN_H
#include <stdbool.h>
#include "base/error.h"
#include "dispatch.h"
#include "plan/shard.h"

struct aob_config_builds;
struct aob_run_again;
struct aob_sweep_choice;

struct aob_run_desc {
    struct aob_dispatch dispatch;
    const char *config;     /* path */
    const char *out;        /* folder; NULL: results/NAME, of a shard results/NAME-2-of-4 */
    struct aob_shard shard; /* of the plan, what this machine measures; zero: all of it */
    const char *filter;     /* only cases whose description holds this text; NULL: all */
    const char *json;       /* summary document to this file, "-": standard output; NULL: none */
    bool fresh, quiet;      /* fresh: what the folder held of an earlier run is removed first */
    const struct aob_config_builds
        *builds; /* each case with both of them (config/config_builds.h); NULL: as it is */
    const struct aob_run_again *
        again; /* the config is the copy that an earlier run has, and its cases are measured again (again.h) */
    const struct aob_sweep_choice
        *choice;  /* of a config with `effects: auto`; NULL: such a config is refused */
    bool no_page; /* the journal only; `aobudget report` can make the page later */
    int max_width; /* pixels; of wider pictures only the middle columns, at their scale, so that a pixel costs what
                           it did; 0: as the config says */
    double seconds;   /* of timing a case; 0: as the config says */
    int processes;    /* that a case is timed in, at least; 0: three */
    double precision; /* share that ends timing early; 0: as the config says */
    int max_spp;      /* rays a pixel of the reference, even; 0: as the config says */
};

/* OK: every case of the plan is measured. PART: some are not; each has its reason in the journal. USAGE:
 * nothing could run, and the line says why. */
enum aob_exit aob_run(const struct aob_run_desc *desc, struct aob_error *error);
#endif
