/* The cases of one or more run folders, read from journal.jsonl and run.json.
 * Whatever is absent, null or of another type is "" or NaN, so that a partial or foreign journal still makes
 * a page. All strings belong to the rows. */
#ifndef AOB_REPORTS_PAGE_ROWS_H
#define AOB_REPORTS_PAGE_ROWS_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"

struct aob_run {
    const char *folder;
    json_t *info;     /* run.json, or NULL */
    json_t *lines;    /* the journal's objects */
    const char *name; /* run.json's, else the folder's path */
    size_t planned;   /* cases; 0: not known */
    size_t cases;     /* found in the journal */
};

struct aob_row {
    size_t run;
    const json_t *json;
    const char *key, *scene, *view, *technique, *backend, *status, *reason, *image;
    int width, height;
    double cost_ms;                /* of a frame: processor time, or wall time if that is the case's clock */
    double ratio, ci_low, ci_high; /* the 95 % interval is the ratio's */
    double rmse, band_rmse, bias, p95, flip, ssim, reference_se, memory_bytes;
    double definition_rmse, missing_rmse, estimator_rmse, border_share;
    double covariance; /* the three mean products added: rmse^2 is the squares of the three and twice this */
    char *label;       /* "radius=0.5 slices=2", then the run options that are not the same everywhere */
};

struct aob_rows {
    struct aob_run *runs;
    size_t run_count;
    struct aob_row *list;
    size_t count, capacity;
};

/* False if a folder has neither a journal nor run.json, or the journal cannot be read; damaged lines are left
 * out. */
bool aob_rows_read(struct aob_rows *rows, const char *const *folders, size_t folder_count,
                   struct aob_error *error);
void aob_rows_finish(struct aob_rows *rows);

bool aob_row_is_ok(const struct aob_row *row);

/* Does the record hold all three parts of its error? Without a definition, and in old journals, it does not. */
bool aob_row_is_split(const struct aob_row *row);

/* Is the screen-space bound what it was compared with? */
bool aob_row_is_captured(const struct aob_row *row);

/* The member, or "" / NaN. `object` may be NULL. */
const char *aob_member_text(const json_t *object, const char *name);
double aob_member_number(const json_t *object, const char *name);

/* "0.5", "cosine", "yes"; free() it. */
char *aob_member_show(const json_t *value);
#endif
