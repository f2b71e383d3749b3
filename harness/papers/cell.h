/* A cell of a Markdown table. */
#ifndef AOB_PAPERS_CELL_H
#define AOB_PAPERS_CELL_H
#include "base/text.h"

/* Adds " text |". Text may be anything, such as a driver's message: bars and line ends do not break the table. */
void aob_paper_cell(struct aob_text *table, const char *text);
#endif
