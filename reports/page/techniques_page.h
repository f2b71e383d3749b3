/* What each technique is, as a page of Markdown, from the folder of one run: its text, parameters, pictures of AO, truth
 * and error, its errors against closed forms, and its cost; all of the cases in which every parameter has its default.
 * Errors are those of `error`: against the technique's own radius where that is a target. What is missing is said in its
 * place. Everything from the folder is escaped. */
#ifndef AOB_REPORTS_PAGE_TECHNIQUES_PAGE_H
#define AOB_REPORTS_PAGE_TECHNIQUES_PAGE_H
#include <stddef.h>
#include "base/error.h"

struct aob_techniques_desc {
    const char *folder;  /* of the run: run.json with `techniques`, journal.jsonl, images/ */
    const char *file;    /* the page, "…/NAME.md"; its pictures go into …/NAME/ */
    const char *program; /* path of aobudget: aobudget-plot is beside it. NULL: the page has no pictures */
};
struct aob_techniques_summary {
    size_t techniques, planned, cases, ok; /* planned: 0 if not known */
    size_t figures, drawn;
    struct aob_error damage; /* on the journal; empty if it is whole */
};

/* False with a line if the folder is no run's, its run.json names no techniques, or the page cannot be written. */
bool aob_techniques_page_write(const struct aob_techniques_desc *desc, struct aob_techniques_summary *summary,
                               struct aob_error *error);
#endif
