/* The texts' milliseconds beside those that the device model (profile/model.h) gives for the text's device. A row is one
 * published time; its case is traced and simulated here, at the text's size, on a scene that stands for the text's.
 * Nothing is fitted for a row, a device or a technique. */
#ifndef AOB_PAPERS_MODELLED_H
#define AOB_PAPERS_MODELLED_H
#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>
#include "base/error.h"
#include "base/text.h"
#include "row.h"

struct aob_modelled_row {
    const char *name, *text;        /* "hbao-ultra-full-8x8", "HBAO table 6.2.1" */
    const char *config;             /* file of configs/papers without .yaml; NULL: nothing is run */
    int width;                      /* of the picture that the text times, in pixels: that of the config */
    const char *technique, *values; /* the case, as aob_paper_find takes them */
    const char *passes;             /* those whose names begin so; NULL: the frame */
    const char *profile;            /* of the text's device */
    double ms, low, high;           /* the text's; low, high: what its digits leave open. 0: it prints none */
    const char *setup;              /* what stands for what the text does not give */
    const char *open;               /* why the row is printed and not counted; NULL: it counts */
};
extern const struct aob_modelled_row aob_modelled_rows[]; /* ended by a NULL name */

/* Two rows of one device that differ in one thing: samples, size, taps. Most of what the model does not know cancels. */
struct aob_modelled_pair {
    const char *row, *to;
};
extern const struct aob_modelled_pair aob_modelled_pairs[]; /* ended by a NULL row */

/* What the model's time is made of; fills: of all levels of cache. */
enum aob_modelled_part {
    AOB_MODELLED_ALU,
    AOB_MODELLED_TEXTURE,
    AOB_MODELLED_FILLS,
    AOB_MODELLED_MEMORY,
    AOB_MODELLED_TARGETS,
    AOB_MODELLED_PARTS
};
extern const char *const aob_modelled_part_names[]; /* their words */

struct aob_modelled {     /* milliseconds of a row's passes together */
    double ms, low, high; /* the point and its band */
    double parts[AOB_MODELLED_PARTS];
    char limit[16]; /* the resource that takes most of them */
};

/* From the row's record. Where that has fewer columns than the text's picture (papers --quick), each stands for more.
 * False after one line: there is no such case, or its figures have no time for the passes. */
bool aob_modelled_read(const struct aob_modelled_row *row, const struct aob_paper_run *run,
                       struct aob_modelled *modelled, struct aob_error *error);

/* Of ratios modelled / published: the geometric mean, one standard deviation of their logarithms as a factor (of n - 1),
 * and the share within a factor of 2. NAN where there are too few. */
struct aob_modelled_sum {
    size_t count;
    double mean, scatter, within;
};
struct aob_modelled_sum aob_modelled_summarise(const double *ratios, size_t count);
#endif
