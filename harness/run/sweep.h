/* A sweep: a config with the techniques that there are and the plan that it comes to. What run, plan and shot begin
 * with. */
#ifndef AOB_RUN_SWEEP_H
#define AOB_RUN_SWEEP_H
#include "budget/budget.h"
#include "config/config.h"
#include "dispatch.h"
#include "plan/plan.h"

/* Who chooses the cases of a config with `effects: auto`, which is above this room. */
struct aob_sweep_choice {
    bool (*widen)(void *user, struct aob_config *config,
                  struct aob_error *error); /* to all that may be chosen */
    /* Keeps cases of the plan. A filter leaves others out later, and what is chosen of these does not matter. */
    bool (*choose)(void *user, struct aob_plan *plan, const char *filter, struct aob_error *error);
    void *user;
};

struct aob_sweep {
    const struct aob_sweep_choice *choice; /* NULL: such a config is refused */
    struct aob_config config; /* filled in by the caller: aob_config_read, or by hand after aob_config_init */
    struct aob_budget budget; /* the config's; zero without one */
    struct aob_technique_list techniques;
    struct aob_plan plan; /* over the two above; the sweep must stay where it is */
};

/* Reads the budget, asks a worker for the techniques, loads the config's captures and expands the plan. False with one line, after which
 * the sweep is still to be finished. */
bool aob_sweep_expand(struct aob_sweep *sweep, const struct aob_dispatch *dispatch, struct aob_error *error);

/* Of a config with `effects: auto` the plan has all that may be chosen, until this has chosen; `filter` is that of aob_plan_filter, which comes
 * behind it, or NULL. False after a line. */
bool aob_sweep_choose(struct aob_sweep *sweep, const char *filter, struct aob_error *error);
void aob_sweep_finish(struct aob_sweep *sweep); /* of a zeroed one too */
#endif
