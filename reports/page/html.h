/* Pieces of HTML. */
#ifndef AOB_REPORTS_PAGE_HTML_H
#define AOB_REPORTS_PAGE_HTML_H
#include "base/text.h"
#include "gallery.h"

/* The text with &, <, > and both quotes escaped: fit for content and for quoted attributes. */
void aob_html_escape(struct aob_text *page, const char *text);

/* A number as a cell: right-aligned, sorted by its value; a dash if it is not finite. `shown` is how it
 * looks. */
void aob_html_number_cell(struct aob_text *page, double value, const char *shown);
void aob_html_text_cell(struct aob_text *page, const char *class_name, const char *text);

/* A share of one as a cell in per cent. */
void aob_html_share_cell(struct aob_text *page, double share);

/* "0.0123", "-0.0123" with a true minus; "12.3" milliseconds to three digits. */
void aob_html_decimal(char text[32], double value);
void aob_html_ms(char text[32], double value);

/* The section's table of where the errors of the techniques' pictured cases come from. */
void aob_html_split(struct aob_text *page, const struct aob_gallery *gallery, size_t section);

/* One scene's view: charts, then pictures. */
void aob_html_section(struct aob_text *page, const struct aob_gallery *gallery, size_t section);

/* The table of all cases. */
void aob_html_table(struct aob_text *page, const struct aob_rows *rows);
#endif
