/* `aobudget stress --fuzz`: frames drawn by lot, on every technique and backend, several workers at a time. */
#ifndef AOB_STRESS_FUZZ_H
#define AOB_STRESS_FUZZ_H
#include <stdbool.h>
#include <stdint.h>
#include "base/error.h"
#include "base/text.h"
#include "run/dispatch.h"

struct aob_fuzz_desc {
    struct aob_dispatch dispatch;
    const char *technique, *backend; /* only this one; NULL: all */
    uint64_t frames;                 /* shared among the rows, a technique on a backend each */
    uint64_t seed, from;             /* frame FROM is each row's first; all below 2^53 */
    const char *out;                 /* folder for fuzz.json and the smallest failing frames; NULL: none */
    const char *json;                /* the same document, a file or "-"; NULL: none */
    bool quiet;                      /* no progress */
};

/* The code as of aob_stress (stress.h). */
enum aob_exit aob_fuzz(const struct aob_fuzz_desc *desc, struct aob_text *table, struct aob_error *error);
#endif
