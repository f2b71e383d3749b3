/* Progress with an estimate of the time left, on standard error and only if that is a terminal. */
#ifndef AOB_RUN_PROGRESS_H
#define AOB_RUN_PROGRESS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include "base/text.h"

struct aob_progress {
    bool shown;
    size_t done, total;
    int64_t start_ns;
    const struct aob_text *below; /* lines that stand under it, borrowed; empty ones do not */
    size_t below_count;
};
void aob_progress_init(struct aob_progress *progress, size_t total, bool quiet);
void aob_progress_say(const struct aob_progress *progress, const char *what); /* what goes on now */
void aob_progress_step(struct aob_progress *progress, const char *what);      /* one more is done: this one */
void aob_progress_finish(struct aob_progress *progress);                      /* clears the line */
#endif
