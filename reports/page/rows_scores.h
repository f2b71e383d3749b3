/* For rows.c: the scores of each case, and the targets of all of them. */
#ifndef AOB_REPORTS_PAGE_ROWS_SCORES_H
#define AOB_REPORTS_PAGE_ROWS_SCORES_H
#include "rows.h"

/* Fills in the scores of rows whose `json` is set, and the list of targets. */
void aob_rows_read_scores(struct aob_rows *rows);
#endif
