/* The rows of `aobudget papers`: what a text claims, how it is measured, and the rules of the verdict. */
#ifndef AOB_PAPERS_ROW_H
#define AOB_PAPERS_ROW_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "store/image.h"

enum { AOB_PAPER_FIGURES = 6 };
enum aob_paper_verdict {
    AOB_PAPER_REPRODUCED,
    AOB_PAPER_SHAPE,
    AOB_PAPER_NOT_REPRODUCED,
    AOB_PAPER_NEEDS_MODEL,
    AOB_PAPER_NOT_RUN,
};
extern const char *const aob_paper_verdicts[]; /* their words */

struct aob_paper_run {
    const json_t *records; /* of the config's journal */
    const char *folder;    /* of the run; its images are below */
};
struct aob_paper_result {
    double measured[AOB_PAPER_FIGURES];
    bool holds, shape; /* of a claim without figures: it does; its shape does */
};
struct aob_paper_row {
    const char *name, *text; /* "hbao-samples", "HBAO table 6.2.1" */
    const char *claim, *unit;
    const char
        *config; /* file of configs/papers without .yaml; NULL: nothing is run, `fixed` is the verdict */
    double figures[AOB_PAPER_FIGURES]; /* the text's; all 0: it gives none, the claim is one of shape */
    size_t count;                      /* of figures that are measured */
    const char *setup; /* what stands for the text's scene, and what it leaves open; NULL: nothing */
    const char *why;   /* should it not be reproduced, or why the verdict is fixed */
    enum aob_paper_verdict fixed;
    bool (*measure)(const struct aob_paper_run *run, struct aob_paper_result *result,
                    struct aob_error *error);
};
extern const struct aob_paper_row aob_paper_rows[]; /* ended by a NULL name */

/* Figures: reproduced if each lies within 25 % of the text's; shape only if they lie in the text's order, each
 * on its side of 1, a single one within a factor of 2.5; else not reproduced. No figures: reproduced if the claim holds,
 * shape only if its shape does, else not. */
enum aob_paper_verdict aob_paper_judge(const struct aob_paper_row *row,
                                       const struct aob_paper_result *result);

/* The technique's record with these values, "name=value ..." of parameters, options and the camera ("eye=0,1,2"); NULL
 * after one line if there is none or it is not ok. */
const json_t *aob_paper_find(const struct aob_paper_run *run, const char *technique, const char *values,
                             struct aob_error *error);

/* Time in units of the fixed pass, of the passes whose name begins so ("blur"); NULL: of all. */
double aob_paper_cost(const json_t *record, const char *passes);
double aob_paper_error(const json_t *record, const char *field);

/* The image that the record's case kept; aob_image_finish frees. False after one line where it has none. */
bool aob_paper_image(const struct aob_paper_run *run, const json_t *record, struct aob_image *image,
                     struct aob_error *error);

/* RMS of the difference between two records' images, over all pixels. */
bool aob_paper_compare(const struct aob_paper_run *run, const json_t *a, const json_t *b, double *rmse,
                       struct aob_error *error);
#endif
