/* `aobudget stress`: every technique on every backend put to the properties, several workers at a time. */
#ifndef AOB_STRESS_STRESS_H
#define AOB_STRESS_STRESS_H
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"
#include "run/dispatch.h"

struct aob_stress_desc {
    struct aob_dispatch dispatch;
    const char *technique, *backend; /* only this one; NULL: all */
    const char *const *properties;   /* property_count names, only these; none: all */
    size_t property_count;
    bool quick;       /* the properties that need few programs, at fewer places */
    const char *out;  /* folder for stress.json, its page and pictures; NULL: none */
    const char *json; /* the same document, a file or "-"; NULL: none */
    bool quiet;       /* no progress */
};

/* Asks, and writes the table for people into `table`. The code: good, AOB_EXIT_BAD where something fails, AOB_EXIT_PART where
 * a backend could not be had, AOB_EXIT_USAGE after one line. */
enum aob_exit aob_stress(const struct aob_stress_desc *desc, struct aob_text *table, struct aob_error *error);

/* The properties, a line each, for people. */
void aob_stress_list(struct aob_text *out);
#endif
