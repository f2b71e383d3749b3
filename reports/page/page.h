/* The report of one or more runs: one HTML page that needs nothing from elsewhere, and its figures.
 * It works on whatever there is: an unfinished journal, failed cases, fields that are absent, no
 * aobudget-plot. What is missing is said in its place. Everything from a journal is escaped. */
#ifndef AOB_REPORTS_PAGE_PAGE_H
#define AOB_REPORTS_PAGE_PAGE_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_page_summary {
    size_t planned;          /* cases of the runs; 0: not known */
    size_t cases, ok;        /* in the journals */
    size_t figures, drawn;   /* charts count twice: SVG and PNG */
    struct aob_error damage; /* on the first journal with damaged lines; empty if there is none */
};

struct aob_page_desc {
    const char *const *folders; /* of the runs (journal.jsonl, run.json, images/), NULL-ended, at least one */
    const char *out;            /* folder of the page: index.html, cases.csv and figures/ are written here */
    const char *program; /* path of aobudget: aobudget-plot is beside it. NULL: the page has no figures */
    struct aob_page_summary *summary; /* filled in; may be NULL */
};

/* False if a folder is no run's or given twice, or the page cannot be written. A figure that could not be drawn is no
 * failure. */
bool aob_page_write(const struct aob_page_desc *desc, struct aob_error *error);
#endif
