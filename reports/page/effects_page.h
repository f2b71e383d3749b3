/* The page of a plan of effects: what each effect adds to the lit image of a view, as pictures, and what it costs. It needs nothing
 * from elsewhere. Everything from the document is escaped. */
#ifndef AOB_REPORTS_PAGE_EFFECTS_PAGE_H
#define AOB_REPORTS_PAGE_EFFECTS_PAGE_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"

struct aob_effects_page_desc {
    const json_t *document; /* docs/design.md, Effects, with the images of its sets; borrowed */
    const char *out;        /* folder of the page; the images lie below it by their names */
    const char *program;    /* path of aobudget: aobudget-plot is beside it. NULL: no pictures */
};

/* Writes OUT/index.html, and OUT/figures/ with a picture of each image and a chart of all sets. False where the page cannot be written; a
 * picture that could not be drawn is told in its place. */
bool aob_effects_page_write(const struct aob_effects_page_desc *desc, struct aob_error *error);
#endif
