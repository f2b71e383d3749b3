/* What one traced file holds: a visibility, its standard error, and its mean open directions. */
#ifndef AOB_WORKER_TRACED_H
#define AOB_WORKER_TRACED_H
#include "block.h"

struct aob_traced {             /* of the view, owned */
    float *ao, *se, (*open)[3]; /* open: only if it is asked for */
};
bool aob_traced_load(const char *path, const struct aob_block *block, bool bent, struct aob_traced *traced,
                     struct aob_error *error);
void aob_traced_finish(struct aob_traced *traced); /* also after a refusal, and of a zeroed one */
#endif
