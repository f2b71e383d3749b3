/* Every point of a history as a table for other programs: CSV by RFC 4180, or JSON lines. */
#ifndef AOB_HISTORY_EXPORT_H
#define AOB_HISTORY_EXPORT_H
#include "history.h"

struct aob_export_desc {
    const char *config; /* only nights of this name; NULL: all */
    const char *
        from; /* only nights that began at this date or later, "2026-11-30" or with a time behind; NULL: all */
    const char *path; /* it ends in .csv or .jsonl, and is written whole or not at all */
};

/* Whether the path and the date are such; false after a line. */
bool aob_export_check(const struct aob_export_desc *desc, struct aob_error *error);

/* A line a point, by night and then by line. Columns are called as in cases.csv wherever they are the same (docs/design.md,
 * "History"); every line has each of them. *rows: the points that were written. */
bool aob_history_export(struct aob_history *history, const struct aob_export_desc *desc, size_t *rows,
                        struct aob_error *error);
#endif
