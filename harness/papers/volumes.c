#include <math.h>
#include "measure.h"

/* The truth's noise: 95 % of the mean over the pixels, whose rays are apart. */
static struct aob_paper_figure mean_error(const json_t *record)
{
    double bias = aob_paper_error(record, "bias"),
           noise = 1.96 * aob_paper_error(record, "reference_se") / sqrt(aob_paper_error(record, "pixels"));
    return (struct aob_paper_figure){bias, bias - noise, bias + noise};
}

/* The noise of the truth enters the RMSE's square. */
MEASURE(aob_paper_aov_solid)
{
    const json_t *record = aob_paper_find(run, "ao_volumes", "radius=0.25", error);
    struct aob_paper_figure *m = result->measured;
    if (!record)
        return false;
    double rmse = aob_paper_error(record, "rmse"), noise = aob_paper_error(record, "reference_se");
    m[0] = mean_error(record);
    m[1] = aob_paper_exact(rmse);
    m[2] = aob_paper_exact(noise);
    m[3] = aob_paper_exact(sqrt(fmax(rmse * rmse - noise * noise, 0)));
    result->holds = aob_paper_both(aob_paper_within(m[0], -AOB_PAPER_STEP, AOB_PAPER_STEP),
                                   aob_paper_below(m[3], AOB_PAPER_STEP));
    return true;
}

MEASURE(aob_paper_aov_thin)
{
    const json_t *record = aob_paper_find(run, "ao_volumes", "radius=0.8", error);
    if (!record)
        return false;
    result->measured[0] = mean_error(record);
    result->holds = aob_paper_below(result->measured[0], 0);
    return true;
}
