/* The page of a run of `stress`: the table of technique by property, and for each property what it asks, its bound, and the
 * answers with the command that shows each again. It needs nothing from elsewhere. Everything from the document is
 * escaped. */
#ifndef AOB_REPORTS_PAGE_STRESS_PAGE_H
#define AOB_REPORTS_PAGE_STRESS_PAGE_H
#include <jansson.h>
#include <stdbool.h>
#include "base/error.h"

struct aob_stress_page_desc {
    const json_t *document; /* docs/design.md, Stress figures; borrowed */
    const char *out;        /* folder of the page; the images that cells name lie in its folder `images` */
    const char *program;    /* path of aobudget: aobudget-plot is beside it. NULL: no pictures */
};

/* Writes OUT/index.html, and OUT/figures/ with a picture of each image. False where the page cannot be written; a picture
 * that could not be drawn is told in its place. */
bool aob_stress_page_write(const struct aob_stress_page_desc *desc, struct aob_error *error);
#endif
