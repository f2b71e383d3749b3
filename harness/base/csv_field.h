/* Fields of a CSV file by RFC 4180. The comma before a field is the caller's. */
#ifndef AOB_BASE_CSV_FIELD_H
#define AOB_BASE_CSV_FIELD_H
#include "text.h"

void aob_csv_add_text(struct aob_text *csv, const char *text); /* in quotes where it must be */

/* Nine digits give a float back; a count is written whole. NAN is an empty field, infinity "inf". */
void aob_csv_add_number(struct aob_text *csv, double value);
#endif
