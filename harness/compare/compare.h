/* `aobudget compare A B`: two runs, or two builds of a module, case by case; or a run and a new build of a module that it
 * has, which is compared with the old one now, and the old one now with what was stored of it. */
#ifndef AOB_COMPARE_COMPARE_H
#define AOB_COMPARE_COMPARE_H
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"
#include "run/dispatch.h"

struct aob_compare_desc {
    struct aob_dispatch dispatch;
    const char *sides[2]; /* A and B: folders of runs, or module files */
    const char *folder;   /* what is measured and the maps of what moved go here; NULL: results/compare */
    const char *
        config; /* of modules: the cases; NULL: those of the run, or those of AOB_COMPARE_SCENE at defaults */
    const char *technique; /* of two modules: this one only; NULL: all that both have */
    double precision;      /* the difference that counts, a share; 0: AOB_COMPARE_PRECISION */
    double seconds;        /* of two modules: of timing a case, at most; 0: AOB_COMPARE_SECONDS */
    const char *json;      /* NULL: no document */
    bool quiet;
};
#define AOB_COMPARE_SCENE     "atrium"
#define AOB_COMPARE_PRECISION 0.02
#define AOB_COMPARE_SECONDS   6.0
enum { AOB_COMPARE_PROCESSES_AB = 5 }; /* that two modules are timed in, at least */

/* Adds the table to `out`. OK: nothing is worse. BAD: a case is slower, or its image has a larger error. PART: nothing is
 * worse, but a case is undecided. USAGE, with a line: nothing could be compared. */
enum aob_exit aob_compare(const struct aob_compare_desc *desc, struct aob_text *out, struct aob_error *error);
#endif
