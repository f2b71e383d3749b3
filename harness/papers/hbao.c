#include "measure.h"

static bool find_sizes(const struct aob_paper_run *run, const json_t **full, const json_t **half,
                       struct aob_error *error)
{
    static const char *const fulls[] = {"directions=4 divisor=1", "directions=8 divisor=1",
                                        "directions=16 divisor=1"},
                             *const halves[] = {"directions=4 divisor=2", "directions=8 divisor=2",
                                                "directions=16 divisor=2"};
    return aob_paper_find_all(run, "hbao", fulls, 3, full, error) &&
           aob_paper_find_all(run, "hbao", halves, 3, half, error);
}

MEASURE(aob_paper_hbao_samples)
{
    const json_t *full[3], *half[3];
    if (!find_sizes(run, full, half, error))
        return false;
    aob_paper_costs_to_first(full, 3, "horizon", result->measured);
    return true;
}

/* A straight line through 4x4 and 16x16, 16 and 256 samples: what it says of none. The text's three devices take 7.9 to
 * 9.25 times as long for the second, so they have 0.45 to 0.54 there. */
WHY(aob_paper_hbao_samples_why)
{
    const double least = 1 - (9.25 - 1) / 15, most = 1 - (7.9 - 1) / 15;
    struct aob_paper_figure growth = aob_paper_difference(outcome->result.measured[2], aob_paper_exact(1)),
                            beside =
                                aob_paper_difference(aob_paper_exact(1), aob_paper_scaled(growth, 1.0 / 15));
    if (aob_paper_within(beside, least, most) != AOB_PAPER_NO)
        return;
    aob_text_add(reason, "beside its samples a pixel costs ");
    aob_paper_figure_print(beside, reason);
    aob_text_add(reason,
                 " of the time of 4x4, by the line through 4x4 and 16x16; on the text's devices %.2g to %.2g",
                 least, most);
}

MEASURE(aob_paper_hbao_blur)
{
    const json_t *full[3], *half[3];
    if (!find_sizes(run, full, half, error))
        return false;
    result->measured[0] =
        aob_paper_quotient(aob_paper_cost(full[0], "blur"), aob_paper_cost(full[0], "horizon"));
    return true;
}

MEASURE(aob_paper_hbao_half)
{
    const json_t *full[3], *half[3];
    if (!find_sizes(run, full, half, error))
        return false;
    for (int i = 0; i < 3; i++)
        result->measured[i] =
            aob_paper_quotient(aob_paper_cost(full[i], NULL), aob_paper_cost(half[i], NULL));
    return true;
}

/* The text blurs while it samples up, in one pass; here a pass does nothing else. */
WHY(aob_paper_hbao_half_why)
{
    const json_t *full[3], *half[3];
    struct aob_paper_figure without[3];
    if (!find_sizes(outcome->run, full, half, NULL))
        return;
    for (int i = 0; i < 3; i++)
        without[i] = aob_paper_quotient(
            aob_paper_cost(full[i], NULL),
            aob_paper_difference(aob_paper_cost(half[i], NULL), aob_paper_cost(half[i], "upsample")));
    if (aob_paper_near(outcome->row, without) != AOB_PAPER_YES)
        return;
    aob_text_add(reason,
                 "the pass that samples up, which the text has in its blur; without it the gains are ");
    for (int i = 0; i < 3; i++) {
        aob_text_add(reason, "%s", i ? ", " : "");
        aob_paper_figure_print(without[i], reason);
    }
}

MEASURE(aob_paper_hbao_half_ao)
{
    const json_t *full[3], *half[3];
    if (!find_sizes(run, full, half, error))
        return false;
    for (int i = 0; i < 3; i++)
        result->measured[i] =
            aob_paper_quotient(aob_paper_cost(full[i], "horizon"), aob_paper_cost(half[i], "horizon"));
    return true;
}
