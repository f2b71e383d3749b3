/* The rows of `aobudget papers`: what a text claims, how it is measured, and the rules of the verdict. */
#ifndef AOB_PAPERS_ROW_H
#define AOB_PAPERS_ROW_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "base/text.h"
#include "figure.h"
#include "store/image.h"

enum { AOB_PAPER_FIGURES = 6 };
enum aob_paper_verdict {
    AOB_PAPER_REPRODUCED,
    AOB_PAPER_SHAPE,
    AOB_PAPER_NOT_REPRODUCED,
    AOB_PAPER_NOT_JUDGED,
    AOB_PAPER_NOT_RUN,
};
extern const char *const aob_paper_verdicts[]; /* their words */

/* Where a text says "indistinguishable", "corrected", "matches" or "exact" and gives no figure: the step of an image of
 * 8 bits, which is what two images on a screen may differ by and be the same. The bar is ours. */
#define AOB_PAPER_STEP (1.0 / 255)

struct aob_paper_run {
    const json_t *records; /* of the config's journal */
    const char *folder;    /* of the run; its images are below */
};
struct aob_paper_result {
    struct aob_paper_figure measured[AOB_PAPER_FIGURES];
    enum aob_paper_answer holds,
        shape; /* of a claim without figures: whether it does; whether its shape does */
};
struct aob_paper_outcome;
struct aob_paper_row {
    const char *name, *text; /* "hbao-samples", "HBAO table 6.2.1" */
    const char *claim, *unit;
    const char *config;                /* file of configs/papers without .yaml; NULL: nothing is run */
    double figures[AOB_PAPER_FIGURES]; /* the text's; all 0: it gives none, the claim is one of shape */
    double rounding;                   /* share by which its printed digits leave them open */
    size_t count;                      /* of figures that are measured */
    const char *setup; /* what stands for the text's scene, and what it leaves open; NULL: nothing */
    /* Why there is no verdict: what the text leaves open that it would depend on, or why nothing is run. NULL: there is
     * one. */
    const char *open;
    bool (*measure)(const struct aob_paper_run *run, struct aob_paper_result *result,
                    struct aob_error *error);
    /* Adds why the row is not reproduced if what was measured shows it, with the figure that does; else nothing. Called
     * only then. NULL: no reason was looked for. */
    void (*why)(const struct aob_paper_outcome *outcome, struct aob_text *reason);
};
struct aob_paper_outcome { /* of a row that was run */
    const struct aob_paper_row *row;
    const struct aob_paper_run *run;
    struct aob_paper_result result;
};
extern const struct aob_paper_row aob_paper_rows[]; /* ended by a NULL name */

/* Figures: reproduced if each lies within 25 % of the text's; shape only if they lie in the text's order, as far as its
 * digits tell them apart, each on its side of 1; else not reproduced. No figures: reproduced if the claim holds, shape
 * only if its shape does, else not. Not judged where the intervals leave the verdict open, or the row does. */
enum aob_paper_verdict aob_paper_judge(const struct aob_paper_row *row,
                                       const struct aob_paper_result *result);

/* Whether each of the first `count` figures lies within 25 % of the row's. */
enum aob_paper_answer aob_paper_near(const struct aob_paper_row *row, const struct aob_paper_figure *figures);

/* Adds what stands in the last column beside the verdict: nothing if it is reproduced, and never a reason that the
 * measured figures do not show. */
void aob_paper_explain(const struct aob_paper_outcome *outcome, struct aob_text *reason);

/* The technique's record with these values, "name=value ..." of parameters, options and the camera ("eye=0,1,2"); NULL
 * after one line if there is none or it is not ok. */
const json_t *aob_paper_find(const struct aob_paper_run *run, const char *technique, const char *values,
                             struct aob_error *error);

/* The records of `count` cases of one technique. */
bool aob_paper_find_all(const struct aob_paper_run *run, const char *technique, const char *const *values,
                        size_t count, const json_t **records, struct aob_error *error);

/* Time in units of the fixed pass, of the passes whose name begins so ("blur"); NULL: of all. */
struct aob_paper_figure aob_paper_cost(const json_t *record, const char *passes);

/* The costs of `count` records, each divided by that of the first, which is exactly 1. */
void aob_paper_costs_to_first(const json_t *const *records, size_t count, const char *passes,
                              struct aob_paper_figure *figures);
double aob_paper_error(const json_t *record, const char *field);
double aob_paper_member(const json_t *record, const char *object, const char *name); /* "params", "radius" */

/* The image that the record's case kept; aob_image_finish frees. False after one line where it has none. */
bool aob_paper_image(const struct aob_paper_run *run, const json_t *record, struct aob_image *image,
                     struct aob_error *error);

/* RMS of the difference between two records' images, over all pixels. */
bool aob_paper_compare(const struct aob_paper_run *run, const json_t *a, const json_t *b,
                       struct aob_paper_figure *rmse, struct aob_error *error);
#endif
