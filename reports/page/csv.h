/* All cases as one table for other programs: cases.csv beside the page. */
#ifndef AOB_REPORTS_PAGE_CSV_H
#define AOB_REPORTS_PAGE_CSV_H
#include "rows.h"

/* FOLDER/cases.csv, as RFC 4180 has it, in UTF-8: a line of names, then a line for each case and target; of a case
 * without a score one line without a target. What is not known is empty. The metrics are those of store/metric.h, by
 * name. */
bool aob_csv_write(const struct aob_rows *rows, const char *folder, struct aob_error *error);
#endif
