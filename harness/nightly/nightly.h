/* `aobudget nightly`: one night of a config: it is measured, kept in a history, judged against the nights before, and told.
 * What stands out is measured again at once, the old module beside the new one in the same blocks, before anything is said
 * of it (docs/measuring.md, Nights). */
#ifndef AOB_NIGHTLY_NIGHTLY_H
#define AOB_NIGHTLY_NIGHTLY_H
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"
#include "run/dispatch.h"

struct aob_nightly_desc {
    struct aob_dispatch dispatch;
    const char
        *config; /* a config; or the folder of a run, which is taken as it is: of many machines, merged */
    const char *history; /* its file; made if it is not there */
    const char
        *old; /* a module file, or a folder of them: the old builds; NULL: those that the history keeps */
    const char *out;      /* each night has a folder here, named by its date; NULL: results/nightly/NAME */
    const char *markdown; /* the summary for a pull request goes to this file; NULL: nowhere */
    const char *json;     /* NULL: no document */
    double precision;     /* the difference that counts, a share; 0: AOB_COMPARE_PRECISION */
    double seconds;       /* of timing a suspect beside its old module, at most; 0: AOB_COMPARE_SECONDS */
    bool quiet;
};
#define AOB_NIGHTLY_DISCOVERY                                                                                \
    0.05 /* share of false ones among the differences that a night tells, on average */

/* Adds one screen to `out`. OK: nothing is worse. BAD: a case is slower, its error is larger, or it ran and does not any
 * more. PART: nothing is worse, but something could not be decided, or a case failed. USAGE, with a line: the night
 * could not be measured or kept; what was measured of it is gone on with by the same command. */
enum aob_exit aob_nightly(const struct aob_nightly_desc *desc, struct aob_text *out, struct aob_error *error);
#endif
