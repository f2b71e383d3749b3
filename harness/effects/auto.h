/* `effects: auto` in a config: of gtao each view is drawn with the set of effects that it calls for, planned before the first case is
 * measured. The set is that of aob_effects_plan at the default tolerance; an empty one is the technique `none`, on the
 * backends of gtao. A view whose device is missing is left to the run, which calls it unsupported. */
#ifndef AOB_EFFECTS_AUTO_H
#define AOB_EFFECTS_AUTO_H
#include "run/sweep.h"

struct aob_effects_auto {
    const struct aob_dispatch *dispatch;
    const char *config; /* path */
    bool quiet;         /* no note of what each view is planned to draw */
    const struct aob_config
        *config_of; /* set by the choice: the run's, with the choice's own entry of `none` last */
};

/* For a run (run.h); `chooser` must outlive it. A config fails with a line that has no entry of gtao, or several, that gives it or
 * a run option several values, that chooses itself what is planned (lit, an output, divisor), or that has a capture without the materials of a lit image. The truth of a plan has the radius
 * of the config's target. A view of which a filter leaves nothing that its plan decides is not planned. */
struct aob_sweep_choice aob_effects_auto_choice(struct aob_effects_auto *chooser);
#endif
