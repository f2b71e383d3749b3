/* What settings are measured to be, as a run measures its cases. */
#ifndef AOB_TUNE_FINAL_H
#define AOB_TUNE_FINAL_H
#include "shape.h"

/* Measures the settings that are not too dear on each of the sides, on every view or only those that are fitted, into their figures. A case
 * that is not ok has the reason there. False after a line: none could be measured. */
struct aob_tune_final_desc {
    bool sides[AOB_TUNE_SIDES];
    bool error;    /* images are compared with the truth; else frames are timed alone */
    bool held_out; /* the views that are held out are measured too */
};
bool aob_tune_final_measure(const struct aob_tune_desc *desc, struct aob_tune *tune,
                            const struct aob_tune_final_desc *final, struct aob_error *error);
#endif
