/* Which night this is: a new one, or one that was stopped and is gone on with. */
#ifndef AOB_NIGHTLY_START_H
#define AOB_NIGHTLY_START_H
#include <stdint.h>
#include "history/night.h"
#include "nightly.h"

struct aob_night_start { /* zero it first; aob_night_start_finish frees */
    int64_t id;
    char *date;    /* when it began, "2026-11-30T02:00:00Z" */
    char *name;    /* the config's */
    char *run;     /* folder of its run */
    char *folder;  /* where its page goes: `run`, or beside other nights where the run lies elsewhere */
    char *out;     /* the folder of all nights */
    char *modules; /* hash of program and modules */
    bool measured; /* the run was made elsewhere */
    int lock; /* of the run's folder, so that no other call takes this night for a stopped one; 0: none */
};

/* A night of this config, program and modules that was stopped is gone on with, if its folder is there. Of another that was
 * stopped the history takes what was measured, and it ends unjudged. False after a line: also of a run that is a night already, and
 * while another call has a night of this config. */
bool aob_night_start(struct aob_history *history, const struct aob_nightly_desc *desc,
                     struct aob_night_start *start, struct aob_error *error);
void aob_night_start_finish(struct aob_night_start *start);

/* Whether program and modules are still those that the night began with. False with a line. */
bool aob_night_start_stands(const struct aob_night_start *start, const struct aob_nightly_desc *desc,
                            struct aob_error *error);

/* Whether a night ended without being judged: what was said of its points says nothing. */
bool aob_night_is_stopped(const struct aob_night *night);
#endif
