/* What each technique is, as a page of Markdown, from the folder of one run: its text, parameters, pictures of AO, truth
 * and error, its errors against closed forms, and its cost; all of the cases in which every parameter has its default.
 * What is missing is said in its place. Everything from the folder is escaped. */
#ifndef AOB_REPORTS_PAGE_TECHNIQUES_PAGE_H
#define AOB_REPORTS_PAGE_TECHNIQUES_PAGE_H
#include "base/error.h"
#include "base/text.h"
#include "gallery.h"

struct aob_techniques_desc {
    const char *folder;  /* of the run: run.json with `techniques`, journal.jsonl, images/ */
    const char *file;    /* the page, "…/NAME.md"; its pictures go into …/NAME/ */
    const char *program; /* path of aobudget: aobudget-plot is beside it. NULL: the page has no pictures */
};
struct aob_techniques_summary {
    size_t techniques, planned, cases, ok; /* planned: 0 if not known */
    size_t figures, drawn;
};

/* False with a line if the folder is no run's, its run.json names no techniques, or the page cannot be written. */
bool aob_techniques_page_write(const struct aob_techniques_desc *desc, struct aob_techniques_summary *summary,
                               struct aob_error *error);

/* Between the files of the page. */
struct aob_techniques {
    struct aob_rows rows;
    struct aob_gallery gallery;    /* its sections are the places */
    const json_t *list;            /* run.json's techniques */
    size_t count;                  /* how many */
    const struct aob_row **chosen; /* count x section_count: the case at defaults; NULL: none */
};
const struct aob_row *aob_techniques_row(const struct aob_techniques *t, size_t technique, size_t section);

/* Whether a case of the section was scored against a closed form; its pictures are of no interest then. */
bool aob_techniques_is_oracle(const struct aob_techniques *t, size_t section);

/* "corner/front" in code. */
void aob_techniques_add_place(struct aob_text *page, const struct aob_techniques *t, size_t section);

/* A row of a table begins: "|", to be followed by cells that end in "|". Heads of tables: names, NULL-ended. */
void aob_techniques_add_head(struct aob_text *page, const char *const *names);

/* The whole section of one technique. */
void aob_techniques_add_technique(struct aob_text *page, const struct aob_techniques *t, size_t technique);
#endif
