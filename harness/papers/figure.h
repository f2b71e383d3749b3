/* Measured figures with their intervals, and what such a figure says of a bar: yes, no, or nothing yet. */
#ifndef AOB_PAPERS_FIGURE_H
#define AOB_PAPERS_FIGURE_H
#include <stdbool.h>
#include <stddef.h>
#include "base/text.h"

/* A number and its interval: of a time 95 %, of what is made of times all that theirs allow. Where nothing is noise,
 * low and high are the value. An interval that is not known reaches from -INFINITY to INFINITY. */
struct aob_paper_figure {
    double value, low, high;
};

/* In order, so that the lesser of two is the answer to "both?", the greater to "either?". OPEN: the interval holds the
 * bar. */
enum aob_paper_answer { AOB_PAPER_NO, AOB_PAPER_OPEN, AOB_PAPER_YES };

struct aob_paper_figure aob_paper_exact(double value);

/* Of two figures whose noises need not be apart: the interval holds all that the two allow. A quotient is of positive
 * figures. */
struct aob_paper_figure aob_paper_sum(struct aob_paper_figure a, struct aob_paper_figure b);
struct aob_paper_figure aob_paper_difference(struct aob_paper_figure a, struct aob_paper_figure b);
struct aob_paper_figure aob_paper_quotient(struct aob_paper_figure a, struct aob_paper_figure b);
struct aob_paper_figure aob_paper_scaled(struct aob_paper_figure a, double factor); /* any factor but 0 */

enum aob_paper_answer aob_paper_above(struct aob_paper_figure figure, double bar);
enum aob_paper_answer aob_paper_below(struct aob_paper_figure figure, double bar);
enum aob_paper_answer aob_paper_within(struct aob_paper_figure figure, double low, double high);
enum aob_paper_answer aob_paper_both(enum aob_paper_answer a, enum aob_paper_answer b);
enum aob_paper_answer aob_paper_either(enum aob_paper_answer a, enum aob_paper_answer b);

/* "1.34 [1.29, 1.38]", or "1.34" where nothing is noise. */
void aob_paper_figure_print(struct aob_paper_figure figure, struct aob_text *text);
#endif
