#include "measure.h"

/* The text speaks of the shader of the AO, so the blur is left out; what makes the smaller depth is not. */
static struct aob_paper_figure shader_cost(const json_t *record)
{
    return aob_paper_sum(aob_paper_cost(record, "access"), aob_paper_cost(record, "downsample"));
}

static bool find_sizes(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    static const char *const values[] = {"screen_radius=0.0936 depth_divisor=1",
                                         "screen_radius=0.0936 depth_divisor=2"};
    return aob_paper_find_all(run, "crytek_ssao", values, 2, records, error);
}

MEASURE(aob_paper_crytek_half)
{
    const json_t *records[2];
    if (!find_sizes(run, records, error))
        return false;
    result->measured[0] = aob_paper_quotient(shader_cost(records[0]), shader_cost(records[1]));
    return true;
}

/* The text's cause is reads that miss the cache. Within a ten-thousandth of the screen none does, with the same reads
 * and the same arithmetic: the most that a cache could give here. */
WHY(aob_paper_crytek_half_why)
{
    const json_t *records[2],
        *near = aob_paper_find(outcome->run, "crytek_ssao", "screen_radius=1e-4 depth_divisor=1", NULL);
    if (!near || !find_sizes(outcome->run, records, NULL))
        return;
    struct aob_paper_figure most = aob_paper_quotient(shader_cost(records[0]), shader_cost(near));
    if (aob_paper_below(most, 0.75 * outcome->row->figures[0]) != AOB_PAPER_YES)
        return;
    aob_text_add(reason, "the text's cause, reads that miss the cache, is not here: if all lie beside the "
                         "pixel, the shader is faster by a factor of ");
    aob_paper_figure_print(most, reason);
}
