/* What the page of techniques says of each. */
#ifndef AOB_REPORTS_PAGE_TECHNIQUES_TEXT_H
#define AOB_REPORTS_PAGE_TECHNIQUES_TEXT_H
#include "techniques_cases.h"

/* The whole section of one technique. */
void aob_techniques_add_technique(struct aob_text *page, const struct aob_techniques *t, size_t technique);
#endif
