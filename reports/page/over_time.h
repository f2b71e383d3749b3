/* The figures over time of a panel: of the cases of a sequence whose own target is the panel's. */
#ifndef AOB_REPORTS_PAGE_OVER_TIME_H
#define AOB_REPORTS_PAGE_OVER_TIME_H
#include "gallery.h"

/* The record's `sequence` if the case is good and its errors are against this target; NULL otherwise. */
const json_t *aob_over_time_of(const struct aob_row *row, size_t target);

/* A chart of the error of each frame, a curve a case, at most 8; and one of the flicker of each case by the time of its frame, which is there
 * if a case has both. */
void aob_over_time_add(struct aob_gallery *gallery, const struct aob_panel *panel);
#endif
