#include "mean_gain.h"
#include <math.h>

/* The variance of a frame's noise: twice what the second frame of the mean makes of difference. */
static double variance_of(const struct aob_seen *seen, const struct aob_drawn *drawn, unsigned set)
{
    const unsigned mean = set | AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL);
    double sum = 0;
    for (size_t i = 0; i < seen->count; i++) {
        double one[3], two[3];
        aob_drawn_light(seen, &drawn[aob_effect_image_of(set)], set, i, one);
        aob_drawn_light(seen, &drawn[aob_effect_image_of(mean)], mean, i, two);
        for (int c = 0; c < 3; c++)
            sum += (two[c] - one[c]) * (two[c] - one[c]);
    }
    return 2 * sum / (3 * (double)seen->count * seen->mean_light * seen->mean_light);
}

double aob_effect_mean_gain(const struct aob_seen *seen, const struct aob_drawn *drawn, unsigned open)
{
    unsigned sets[AOB_EFFECT_SETS];
    size_t count = aob_effect_sets(open & ~AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL), sets);
    double most = 0;
    for (size_t i = 0; i < count; i++) {
        if (!sets[i])
            continue;
        double error = aob_drawn_error(seen, &drawn[aob_effect_image_of(sets[i])], sets[i]).rmse,
               left = fmax(error * error - variance_of(seen, drawn, sets[i]), 0);
        most = fmax(most, error - sqrt(left));
    }
    return most;
}
