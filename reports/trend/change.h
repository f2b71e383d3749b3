/* What changed in a history: each border of two levels, and each night whose verdict says more. */
#ifndef AOB_REPORTS_TREND_CHANGE_H
#define AOB_REPORTS_TREND_CHANGE_H
#include "model.h"

struct aob_trend_change {
    const struct aob_trend_series *series;
    size_t since; /* the dot where it began */
    size_t
        told; /* the dot whose verdict tells of it; SIZE_MAX: no night was told, the levels alone show it */
    enum aob_night_verdict verdict; /* AOB_NIGHT_NONE where none was told */
    double before, after;           /* ratios to the fixed pass; NAN: not known, or not what changed */
};
struct aob_trend_changes { /* zero it first; free the items */
    struct aob_trend_change *items;
    size_t count, capacity;
};

/* The changes of all series: the latest first; of one day broken ones first, then by how much they differ. A verdict that
 * tells of a border by up to two nights off is that border's. */
void aob_trend_changes_find(const struct aob_trend_model *model, struct aob_trend_changes *changes);
#endif
