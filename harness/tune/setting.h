/* A setting: a technique with the values that the config gives it, all but what is fitted. Where the config sweeps samples or choices, each
 * combination is a setting with a fit and a cost of its own. */
#ifndef AOB_TUNE_SETTING_H
#define AOB_TUNE_SETTING_H
#include "axes.h"
#include "budget/choice.h"
#include "config/config.h"

struct aob_setting_value {
    const char *name; /* borrowed from the config */
    char text[64];    /* as the config writes it */
};
struct aob_tune_figures { /* of one view; NAN where not known */
    double error;         /* RMSE in band */
    double ratio;         /* cost over that of the fixed pass */
    double ms, low, high; /* of a frame, and its interval */
    char reason[256];     /* why there are none; else empty */
};
enum aob_tune_side { AOB_TUNE_DEFAULT, AOB_TUNE_FITTED, AOB_TUNE_SIDES };

struct aob_tune_setting {
    const struct aob_technique_choice *from; /* entry of the config: technique, module, backends */
    struct aob_setting_value values[AOB_MAX_PARAM];
    size_t value_count;
    struct aob_tune_axes axes;    /* what is fitted; `start` is what it has without a fit */
    double fitted[AOB_MAX_PARAM]; /* of the axes */
    bool idle[AOB_MAX_PARAM];     /* of the axes: it changes no image, so it stays as it is */
    int evaluations;              /* images of every view that the fit has drawn */
    bool dear;                    /* too dear without a fit, so it has none */
    struct aob_tune_figures (*figures)[AOB_TUNE_SIDES]; /* one a view */
};

struct aob_settings_desc {
    const struct aob_config *config; /* whose entries of the technique are taken; outlives the settings */
    const struct aob_technique_info *technique;
    const char *params; /* that are fitted by name; NULL: by themselves */
    size_t view_count;
};
enum { AOB_TUNE_MAX_SETTINGS = 12 };

/* The products of what the entries sweep. A sweep over a parameter that is fitted is none, since the fit looks between its values. False
 * after a line if there are too many. */
bool aob_tune_settings_create(const struct aob_settings_desc *desc, struct aob_tune_setting **settings,
                              size_t *count, struct aob_error *error);
void aob_tune_settings_destroy(struct aob_tune_setting *settings, size_t count);

/* Whether the setting states a parameter. */
bool aob_tune_setting_states(const struct aob_tune_setting *setting, const char *name);

/* The setting as an entry of a config, without a fit or with it. `radius` is what a technique with such a parameter gets where the setting
 * states none: the target's; INFINITY: its own default. Allocates; aob_technique_choice_finish frees. */
void aob_tune_setting_entry(const struct aob_tune_setting *setting,
                            const struct aob_technique_info *technique, enum aob_tune_side side,
                            double radius, struct aob_technique_choice *entry);

/* The mean error over the views that are held out, or over the others, of those that have one on both sides; NAN where there is none. */
struct aob_tune_shown;
double aob_tune_setting_mean(const struct aob_tune_setting *setting, const struct aob_tune_shown *views,
                             size_t count, bool held_out, enum aob_tune_side side);
#endif
