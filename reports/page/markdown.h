/* Pieces of GitHub's Markdown. */
#ifndef AOB_REPORTS_PAGE_MARKDOWN_H
#define AOB_REPORTS_PAGE_MARKDOWN_H
#include "base/text.h"

/* The text such that it reads as itself, within a line, a table cell, or a heading: what could be markup or HTML becomes a
 * character reference, a line break a space. */
void aob_md_escape(struct aob_text *page, const char *text);

/* A name: `name` where it is made of letters, digits, _ - . and /, else escaped. */
void aob_md_code(struct aob_text *page, const char *name);

/* A path relative to the page, as it stands within the brackets of a link. */
void aob_md_link(struct aob_text *page, const char *path);

/* A cell of a table with so many decimals, and a bar behind it; a dash if the value is not finite. */
void aob_md_number(struct aob_text *page, double value, int decimals);
#endif
