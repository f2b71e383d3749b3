/* For the files of the page of techniques: the case of each technique and place, and what they say of places. */
#ifndef AOB_REPORTS_PAGE_TECHNIQUES_CASES_H
#define AOB_REPORTS_PAGE_TECHNIQUES_CASES_H
#include "base/text.h"
#include "gallery.h"

struct aob_techniques {
    struct aob_rows rows; /* their sections are the places */
    struct aob_gallery gallery;
    const json_t *list;            /* run.json's techniques */
    size_t count;                  /* how many */
    const struct aob_row **chosen; /* count x section_count: the case at defaults; NULL: none */
};

/* Fills in `chosen` from the rows and the list: good cases first, among those the backend that comes first. */
void aob_techniques_choose(struct aob_techniques *t);

const struct aob_row *aob_techniques_row(const struct aob_techniques *t, size_t technique, size_t section);

/* What the case's own score says of a closed form; NULL without one, or without a case. */
const json_t *aob_techniques_oracle(const struct aob_row *row);

/* Whether a case of the section was scored against a closed form; its pictures are of no interest then. */
bool aob_techniques_is_oracle(const struct aob_techniques *t, size_t section);

/* "corner/front" in code. */
void aob_techniques_add_place(struct aob_text *page, const struct aob_techniques *t, size_t section);

/* A row of a table begins: "|", to be followed by cells that end in "|". Heads of tables: names, NULL-ended. */
void aob_techniques_add_head(struct aob_text *page, const char *const *names);
#endif
