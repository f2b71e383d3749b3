#include <math.h>
#include "measure.h"

/* What 16 further samples, or a further pass, take off the noise and add to the time. */
struct ways {
    struct aob_paper_figure noise, time; /* passes / samples */
};

static struct ways compare_ways(const struct aob_paper_figure *m)
{
    struct aob_paper_figure one = aob_paper_exact(1);
    return (struct ways){
        aob_paper_quotient(aob_paper_difference(m[0], m[2]), aob_paper_difference(m[0], m[1])),
        aob_paper_quotient(aob_paper_difference(m[4], one), aob_paper_difference(m[3], one))};
}

/* The noise pattern: what two seeds' images differ by is twice its square. The passes pay if they take off more of it a
 * time. Their "loss of definition" is the same in both images. */
MEASURE(aob_paper_starcraft2_blur)
{
    static const char *const values[] = {"seed=0 samples=16 blur_passes=1", "seed=0 samples=32 blur_passes=1",
                                         "seed=0 samples=16 blur_passes=2"},
                             *const others[] = {"seed=1 samples=16 blur_passes=1",
                                                "seed=1 samples=32 blur_passes=1",
                                                "seed=1 samples=16 blur_passes=2"};
    const json_t *records[3], *seeds[3];
    struct aob_paper_figure *m = result->measured;
    if (!aob_paper_find_all(run, "starcraft2_ssao", values, 3, records, error) ||
        !aob_paper_find_all(run, "starcraft2_ssao", others, 3, seeds, error))
        return false;
    for (int i = 0; i < 3; i++) {
        if (!aob_paper_compare(run, records[i], seeds[i], &m[i], error))
            return false;
        m[i] = aob_paper_scaled(m[i], M_SQRT1_2);
    }
    for (int i = 1; i < 3; i++)
        m[2 + i] = aob_paper_quotient(aob_paper_cost(records[i], NULL), aob_paper_cost(records[0], NULL));
    struct ways ways = compare_ways(m);
    result->holds = aob_paper_above(aob_paper_difference(ways.noise, ways.time), 0);
    return true;
}

WHY(aob_paper_starcraft2_blur_why)
{
    struct ways ways = compare_ways(outcome->result.measured);
    aob_text_add(reason, "the second pass takes off ");
    aob_paper_figure_print(ways.noise, reason);
    aob_text_add(reason, " of the noise that 16 further samples do, in ");
    aob_paper_figure_print(ways.time, reason);
    aob_text_add(reason, " of their time");
}
