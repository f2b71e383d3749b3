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

/* A metric's value as a cell: a count, or four decimals. */
void aob_html_metric_cell(struct aob_text *page, const struct aob_metric *metric, double value);

/* "0.0123", "-0.0123" with a true minus; "12.3" milliseconds to three digits. */
void aob_html_decimal(char text[32], double value);
void aob_html_ms(char text[32], double value);

/* Where the page has several targets: the control that shows one of them at a time. Without the script it stays hidden,
 * and all targets stand below each other. */
void aob_html_target_control(struct aob_text *page, const struct aob_rows *rows);

/* A part of the page that is about one target begins, with its name as the heading, then `more`; it ends with
 * "</div>". */
void aob_html_target_open(struct aob_text *page, const struct aob_rows *rows, size_t target,
                          const char *more);

/* What a case is called beside its technique, cut to two lines; all that it is when one points at it. */
void aob_html_label(struct aob_text *page, const struct aob_row *row);

/* What the case gives besides visibility, and the passes that it takes for it, each with its time. Nothing of a case that
 * gives visibility only. */
void aob_html_given(struct aob_text *page, const struct aob_row *row);

/* The names of what the case gives as a cell. */
void aob_html_outputs_cell(struct aob_text *page, const struct aob_row *row);

/* Does the case give more than visibility? */
bool aob_html_gives_more(const struct aob_row *row);

/* The panel's table of where the errors of the techniques' pictured cases come from. */
void aob_html_split(struct aob_text *page, const struct aob_gallery *gallery, const struct aob_panel *panel);

/* Of the cases of a sequence whose own target is the panel's: error, flicker and cost. Nothing where there is none. */
void aob_html_over_time(struct aob_text *page, const struct aob_gallery *gallery,
                        const struct aob_panel *panel);

/* One scene's view: for each target charts and pictures, then what needs no target. */
void aob_html_section(struct aob_text *page, const struct aob_gallery *gallery, size_t section);

/* Where a run has a budget (run.json): which case to take for it, of each scene, view and target. */
void aob_html_budget(struct aob_text *page, const struct aob_rows *rows);

/* The tables of all cases, one for each target. */
void aob_html_table(struct aob_text *page, const struct aob_rows *rows);

/* From the doctype to the header's end: what was run where, what did not run, the way to the sections. */
void aob_html_head(struct aob_text *page, const struct aob_rows *rows);

/* Where the runs have several backends: whether their images agree, from the images themselves. */
void aob_html_agreement(struct aob_text *page, const struct aob_rows *rows);
#endif
