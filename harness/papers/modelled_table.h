/* The modelled rows as a section of the page and of the document of `aobudget papers`. */
#ifndef AOB_PAPERS_MODELLED_TABLE_H
#define AOB_PAPERS_MODELLED_TABLE_H
#include "modelled.h"
#include "runs.h"

struct aob_modelled_table {
    struct aob_text text; /* Markdown; empty where no row was wanted */
    json_t *
        document; /* {rows[], counted{}, all{}, alone{}, pairs[], pairs_within} (docs/design.md, "Modelled rows") */
    size_t failed; /* rows that could not be run */
};

/* Runs the configs of the rows whose name holds the filter (NULL: all), those that were not run yet. */
void aob_modelled_table_init(struct aob_modelled_table *table, struct aob_paper_runs *runs,
                             const char *filter);
void aob_modelled_table_finish(struct aob_modelled_table *table);
#endif
