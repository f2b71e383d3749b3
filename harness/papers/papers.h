/* `aobudget papers`: the figures of the techniques' texts beside those measured here, a verdict for each, and the texts'
 * milliseconds beside modelled ones. The configs lie on the shelf `papers` (base/shelf.h). */
#ifndef AOB_PAPERS_PAPERS_H
#define AOB_PAPERS_PAPERS_H
#include <stdbool.h>
#include "base/error.h"
#include "run/dispatch.h"

struct aob_papers_desc {
    struct aob_dispatch dispatch;
    const char *filter; /* only rows whose name holds this text; NULL: all */
    const char *out;    /* folder; NULL: results/papers. Runs in it of the same names are discarded */
    const char *json;   /* the document; "-": standard output, and no table; NULL: none */
    bool quick, quiet;  /* quick: the middle 80 columns of each picture, 0.1 s a case, 64 rays a pixel */
};

/* OK: every row has a verdict, whatever it is. PART: a row could not be run. USAGE: no row of that name, a config is
 * missing, a module cannot be loaded, or nothing can be written: said before the first row is run. */
enum aob_exit aob_papers(const struct aob_papers_desc *desc, struct aob_error *error);
#endif
