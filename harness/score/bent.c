#include "bent.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/statistics.h"

static double length_of(const float v[3])
{
    return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
}

bool aob_bent_judge(const struct aob_score_desc *desc, const float (*image)[3], struct aob_error *error)
{
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        if (!aob_score_is_sky(desc, i) && !(length_of(image[i]) <= 1.01))
            return aob_fail(
                error,
                "pixel (%zu, %zu) of the bent normal is (%g, %g, %g): it must be finite and no longer than 1",
                i % (size_t)desc->width, i / (size_t)desc->width, (double)image[i][0], (double)image[i][1],
                (double)image[i][2]);
    return true;
}

/* The angle comes from the length of the unit vectors' difference, which is exact for small angles, where the cosine
 * is not. */
static double degrees_between(const float a[3], const float b[3])
{
    double la = length_of(a), lb = length_of(b), square = 0;
    if (!(la > 0))
        return 90;
    for (int c = 0; c < 3; c++)
        square += pow(a[c] / la - b[c] / lb, 2);
    return 2 * asin(fmin(1, sqrt(square) / 2)) * 180 / M_PI;
}

void aob_bent_score(const struct aob_score_desc *desc, const float (*image)[3], const float (*truth)[3],
                    struct aob_metrics *metrics)
{
    size_t pixels = (size_t)desc->width * (size_t)desc->height, count = 0;
    double *angles = AOB_NEW_ARRAY(double, pixels), sum = 0;
    for (size_t i = 0; i < pixels; i++) {
        if (aob_score_is_sky(desc, i) || !(length_of(truth[i]) > AOB_BENT_LEAST))
            continue;
        angles[count] = degrees_between(image[i], truth[i]);
        sum += angles[count++];
    }
    metrics->bent_mean = count ? sum / (double)count : NAN;
    metrics->bent_p95 = count ? aob_quantile(angles, count, 0.95) : NAN;
    metrics->bent_pixels = (double)count;
    free(angles);
}
