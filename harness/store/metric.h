/* The table of metrics: what a case's image is scored by, against one target. Scores fill a struct aob_metrics; the
 * record, the page, its CSV file and the docs are written from the table, so a new metric is a field and a row, and the
 * metrics of a second output are rows too. Units and meanings are in the rows. Threads: const data. */
#ifndef AOB_STORE_METRIC_H
#define AOB_STORE_METRIC_H
#include <aobudget/technique.h>
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/text.h"

/* Which of two values a reader should prefer. */
enum aob_better {
    AOB_BETTER_NONE, /* it describes; neither is better */
    AOB_BETTER_LESS,
    AOB_BETTER_MORE,
    AOB_BETTER_ZERO, /* the one nearer to 0 */
};

/* A score of one image against one target; NAN where a value is not known. Docs: the table. */
struct aob_metrics {
    double rmse, band_rmse, border_rmse, border_share, mae, bias, p95, max, reference_se;
    double definition_rmse, missing_rmse, estimator_rmse, claim_bias;
    double definition_missing, definition_estimator, missing_estimator;
    double flip, ssim, pixels, band_pixels, flicker;
    double bent_mean, bent_p95, bent_pixels, bent_band, bent_band_normal, bent_band_pixels;
    double bounce_rmse, bounce_band, bounce_bias, bounce_se, bounce_plain, bounce_model;
    double specular_rmse, specular_band, specular_bias, specular_se, specular_plain;
    double irradiance_rmse, irradiance_band, irradiance_bias, irradiance_se, irradiance_plain;
    double lit_rmse, lit_band, lit_bias, lit_se, lit_flip, lit_exposure;
};

struct aob_metric {
    const char *name;  /* of the JSON field, lower_snake; the column of the CSV file */
    const char *title; /* the head of a table's column: "RMSE in band" */
    const char *unit;  /* "pixels"; NULL: a number without one */
    const char *doc;   /* one sentence */
    enum aob_better better;
    enum aob_output output; /* whose image is scored */
    bool whole;             /* a count: written without a fraction */
    bool of_sequence;       /* only a sequence has it: a record leaves it out where it is not known */
    bool brief;             /* one of the few that a line or the caption of a picture has room for */
    const char *group;      /* NULL, or the JSON object below the target's that holds it: "covariance" */
    size_t offset;          /* of the double in struct aob_metrics */
};

/* Ended by a NULL name; in the order in which records and tables have them. */
extern const struct aob_metric aob_metric_table[];
const struct aob_metric *aob_metric_find(const char *name); /* or NULL */

double aob_metric_get(const struct aob_metrics *metrics, const struct aob_metric *metric);
void aob_metric_set(struct aob_metrics *metrics, const struct aob_metric *metric, double value);

/* Adds `between`, title and value of each brief metric of the outputs in `outputs` (bits 1 << enum aob_output) that is known,
 * with a true minus: " · RMSE 0.0458 · bias −0.0116". */
void aob_metrics_print_brief(const struct aob_metrics *metrics, unsigned outputs, const char *between,
                             struct aob_text *text);

/* All NAN. */
void aob_metrics_init(struct aob_metrics *metrics);

/* Into an object that is there already: the metrics of the outputs in `outputs` (bits 1 << enum aob_output), NAN as
 * null. */
void aob_metrics_to_json(const struct aob_metrics *metrics, unsigned outputs, json_t *object);

/* What the object lacks, or has as another type, is NAN. `object` may be NULL. */
void aob_metrics_from_json(struct aob_metrics *metrics, const json_t *object);
#endif
