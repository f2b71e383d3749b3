/* `aobudget tune`: the free parameters of one technique fitted to the ray-traced truth of one target, on the views of a config, and what
 * that gains on views which no fit has seen. Small images with few rays are fitted first, then those of the config. */
#ifndef AOB_TUNE_TUNE_H
#define AOB_TUNE_TUNE_H
#include "run/sweep.h"
#include "setting.h"

struct aob_tune_desc {
    const struct aob_dispatch *dispatch;
    const char *technique, *config; /* its name; a path */
    const char *params;             /* "a,b"; NULL: those of aob_tune_axes_wants */
    const char *target;             /* radius, scene units, inf allowed; NULL: the config's only target */
    const char *held_out;           /* "scene,scene/view"; NULL: none */
    double budget_ms;               /* that a frame may take; INFINITY: any */
    const char *folder;             /* that exists, for what drivers compile */
    void (*on_work)(void *user, const char *work); /* what is done next; NULL: nobody asks */
    void *user;
};

struct aob_tune_shown { /* a view */
    char *name;         /* "corner/front" */
    bool held_out;      /* it is scored and never fitted */
};
struct aob_tune {
    struct aob_sweep
        look; /* the config as it was read, and its plan: settings and the next three point into it */
    const struct aob_technique_info *technique;
    const char *backend;
    struct aob_target target;
    int width, height, spp;       /* that figures are of */
    struct aob_tune_shown *views; /* view_count, as the scenes of the config */
    size_t view_count;
    struct aob_tune_setting *settings; /* setting_count: each with a fit of its own */
    size_t setting_count;
    size_t
        chosen; /* setting of the least error in training that fits the budget; AOB_NO_CANDIDATE: none does */
    double cheapest_ms; /* then the least upper end of a cost */
    bool unfitted;      /* all were too dear before any fit, so none was made */
};

/* False after a line. aob_tune_finish is to be called either way. */
bool aob_tune_run(const struct aob_tune_desc *desc, struct aob_tune *tune, struct aob_error *error);
void aob_tune_finish(struct aob_tune *tune); /* of a zeroed one too */
#endif
