/* What a case is called beside its technique: parameters and run options that are not the same in all cases, then those
 * that are, but not at their defaults, then the light where an output is wanted that depends on it. */
#ifndef AOB_REPORTS_PAGE_LABEL_H
#define AOB_REPORTS_PAGE_LABEL_H
#include "rows.h"

/* Fills in every row's label: "radius=0.5 slices=2 guard_band=64". A parameter is looked at among the cases of its
 * technique, an option among all; the defaults of parameters are those in run.json, and where that names none, none is
 * told from another. */
void aob_labels_make(struct aob_rows *rows);

/* Every parameter and option of the case with its value; free() it. */
char *aob_label_full(const struct aob_row *row);
char *aob_label_params(const struct aob_row *row);  /* the parameters only */
char *aob_label_options(const struct aob_row *row); /* the run options and the light only */
#endif
