/* The modelled rows as a section of the page and of the document of `aobudget papers`. */
#ifndef AOB_PAPERS_MODELLED_TABLE_H
#define AOB_PAPERS_MODELLED_TABLE_H
#include "modelled.h"
#include "runs.h"

struct aob_modelled_table_desc {         /* all borrowed */
    const struct aob_modelled_row *rows; /* ended by a NULL name */
    const struct aob_modelled_pair
        *pairs;                  /* ended by a NULL row; those of rows without a time are left out */
    struct aob_paper_runs *runs; /* the rows' configs are run that were not run yet */
    const char *filter;          /* only rows whose name holds it; NULL: all */
};
struct aob_modelled_table {
    struct aob_text text; /* Markdown; empty where no row was wanted */
    json_t *document;     /* docs/design.md, "Modelled rows" */
    size_t failed;        /* rows that could not be run */
};

/* In a quick run each picture is a part of the text's, so there are neither sums nor pairs. */
void aob_modelled_table_init(struct aob_modelled_table *table, const struct aob_modelled_table_desc *desc);
void aob_modelled_table_finish(struct aob_modelled_table *table);
#endif
