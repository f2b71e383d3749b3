#include "row.h"

const char *const aob_paper_verdicts[] = {"reproduced", "shape only", "not reproduced", "not judged",
                                          "could not be run"};

static const double least = 0.75, most = 1.25; /* of the text's figure */

static enum aob_paper_answer is_near(const struct aob_paper_row *row, size_t i,
                                     const struct aob_paper_figure *figures)
{
    return aob_paper_within(figures[i], least * row->figures[i], most * row->figures[i]);
}

enum aob_paper_answer aob_paper_near(const struct aob_paper_row *row, const struct aob_paper_figure *figures)
{
    enum aob_paper_answer near = AOB_PAPER_YES;
    for (size_t i = 0; i < row->count; i++)
        near = aob_paper_both(near, is_near(row, i, figures));
    return near;
}

/* Two figures that the text's digits do not tell apart have no order. */
static enum aob_paper_answer in_order(const struct aob_paper_row *row, const struct aob_paper_figure *m)
{
    enum aob_paper_answer ordered = AOB_PAPER_YES;
    double less = 1 - row->rounding, more = 1 + row->rounding;
    for (size_t i = 0; i < row->count; i++) {
        if (row->figures[i] * less > 1)
            ordered = aob_paper_both(ordered, aob_paper_above(m[i], 1));
        if (row->figures[i] * more < 1)
            ordered = aob_paper_both(ordered, aob_paper_below(m[i], 1));
        for (size_t j = 0; j < row->count; j++)
            if (row->figures[i] * more < row->figures[j] * less)
                ordered = aob_paper_both(ordered, aob_paper_above(aob_paper_difference(m[j], m[i]), 0));
    }
    return ordered;
}

static enum aob_paper_verdict decide(enum aob_paper_answer holds, enum aob_paper_answer shape)
{
    if (holds == AOB_PAPER_YES)
        return AOB_PAPER_REPRODUCED;
    if (holds == AOB_PAPER_OPEN || shape == AOB_PAPER_OPEN)
        return AOB_PAPER_NOT_JUDGED;
    return shape == AOB_PAPER_YES ? AOB_PAPER_SHAPE : AOB_PAPER_NOT_REPRODUCED;
}

enum aob_paper_verdict aob_paper_judge(const struct aob_paper_row *row, const struct aob_paper_result *result)
{
    if (row->open)
        return AOB_PAPER_NOT_JUDGED;
    if (row->figures[0] == 0)
        return decide(result->holds, result->shape);
    return decide(aob_paper_near(row, result->measured), in_order(row, result->measured));
}

/* The first interval that reaches over the bar it is held to, where that decides. */
static void explain_open(const struct aob_paper_row *row, const struct aob_paper_figure *measured,
                         struct aob_text *reason)
{
    size_t i = 0;
    if (row->figures[0] == 0 || aob_paper_near(row, measured) != AOB_PAPER_OPEN) {
        aob_text_add(reason, "the intervals still leave %s open",
                     row->figures[0] == 0 ? "the claim" : "the order");
        return;
    }
    while (is_near(row, i, measured) != AOB_PAPER_OPEN)
        i++;
    const double low = least * row->figures[i], high = most * row->figures[i];
    aob_text_add(reason, "[%.3g, %.3g] still holds the bar %.4g", measured[i].low, measured[i].high,
                 measured[i].low < low ? low : high);
}

void aob_paper_explain(const struct aob_paper_outcome *outcome, struct aob_text *reason)
{
    const struct aob_paper_row *row = outcome->row;
    enum aob_paper_verdict verdict = aob_paper_judge(row, &outcome->result);
    size_t before = reason->size;
    if (verdict == AOB_PAPER_REPRODUCED)
        return;
    if (row->open)
        aob_text_add(reason, "%s", row->open);
    else if (verdict == AOB_PAPER_NOT_JUDGED)
        explain_open(row, outcome->result.measured, reason);
    else if (row->why)
        row->why(outcome, reason);
    if (reason->size == before)
        aob_text_add(reason, "no reason known");
}
