/* One search of a setting's fit: at one size, in a worker of its own. */
#ifndef AOB_TUNE_STAGE_H
#define AOB_TUNE_STAGE_H
#include "tune.h"

enum aob_tune_stage {
    AOB_TUNE_SMALL, /* small images, few rays: the whole box is searched, and then around the best place */
    AOB_TUNE_FULL,  /* the config's size and rays: around that place */
};

/* Chooses the axes and fits them in the first stage; starts at what is fitted in the second. False after a line. */
bool aob_tune_stage_run(const struct aob_tune_desc *desc, const struct aob_tune *tune,
                        enum aob_tune_stage stage, struct aob_tune_setting *setting, struct aob_error *error);

/* What the size is divided by in a stage. */
int aob_tune_stage_divisor(const struct aob_tune *tune, enum aob_tune_stage stage);

/* Chooses the axes of a setting from its case on the first view that is fitted. */
bool aob_tune_stage_axes(const struct aob_tune_desc *desc, const struct aob_case *first,
                         struct aob_tune_setting *setting, struct aob_error *error);
#endif
