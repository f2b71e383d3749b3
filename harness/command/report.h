/* `aobudget report`: the page of one or more runs, from their folders alone. */
#ifndef AOB_COMMAND_REPORT_H
#define AOB_COMMAND_REPORT_H
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_report_desc {
    const char *program;        /* of the running executable; the plot helper lies beside it */
    const char *const *folders; /* folder_count */
    size_t folder_count;
    const char *out;        /* folder of the page; NULL: report/ in the first folder */
    const char *techniques; /* file of the page of techniques, written in its place; NULL: none */
    const char *json;       /* summary document; NULL: none */
    bool quiet;
};

/* PART: a journal lacks cases of its run's plan (or the plan is not known), or some are not ok; the page says so. */
enum aob_exit aob_report(const struct aob_report_desc *desc, struct aob_error *error);
#endif
