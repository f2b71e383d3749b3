#include "measure.h"

MEASURE(aob_paper_gtao_error)
{
    static const char *const values[] = {"slices=1 divisor=1", "slices=3 divisor=1", "slices=9 divisor=1"};
    const json_t *records[3];
    struct aob_paper_figure *m = result->measured;
    if (!aob_paper_find_all(run, "gtao", values, 3, records, error))
        return false;
    for (int i = 0; i < 3; i++)
        m[i] = aob_paper_exact(aob_paper_error(records[i], "rmse"));
    m[3] = aob_paper_exact(aob_paper_error(records[2], "estimator_rmse"));
    m[4] = aob_paper_exact(aob_paper_error(records[2], "missing_rmse"));
    result->holds = aob_paper_below(m[2], AOB_PAPER_STEP);
    return true;
}

/* A part that is itself below the bar is no reason. */
WHY(aob_paper_gtao_error_why)
{
    const struct aob_paper_figure *m = outcome->result.measured;
    if (m[4].value >= AOB_PAPER_STEP)
        aob_text_add(reason,
                     "what the depth buffer does not know, such as hidden sides, makes an error of %.2g",
                     m[4].value);
    if (m[3].value >= AOB_PAPER_STEP)
        aob_text_add(reason, "%swhat the technique makes of what it knows, one of %.2g",
                     reason->size ? "; " : "", m[3].value);
}

static bool find_sizes(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    static const char *const values[] = {"slices=3 divisor=1", "slices=3 divisor=2"};
    return aob_paper_find_all(run, "gtao", values, 2, records, error);
}

MEASURE(aob_paper_gtao_half)
{
    const json_t *records[2];
    if (!find_sizes(run, records, error))
        return false;
    result->measured[0] =
        aob_paper_quotient(aob_paper_cost(records[0], NULL), aob_paper_cost(records[1], NULL));
    result->holds = aob_paper_above(result->measured[0], 1);
    return true;
}

WHY(aob_paper_gtao_half_why)
{
    const json_t *records[2];
    if (!find_sizes(outcome->run, records, NULL))
        return;
    struct aob_paper_figure without = aob_paper_quotient(
        aob_paper_cost(records[0], NULL),
        aob_paper_difference(aob_paper_cost(records[1], NULL), aob_paper_cost(records[1], "upsample")));
    if (aob_paper_above(without, 1) != AOB_PAPER_YES)
        return;
    aob_text_add(reason, "the pass that samples up costs more than is saved; without it the quotient is ");
    aob_paper_figure_print(without, reason);
}
