#include "bent.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/statistics.h"

static double length_of(const float v[3])
{
    return sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
}

bool aob_bent_is_sound(const float bent[3])
{
    return length_of(bent) <= 1.01; /* false of what is no number */
}

bool aob_bent_judge(const struct aob_score_desc *desc, const float (*image)[3], struct aob_error *error)
{
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        if (!aob_score_is_sky(desc, i) && !aob_bent_is_sound(image[i]))
            return aob_fail(
                error,
                "pixel (%zu, %zu) of the bent normal is (%g, %g, %g): it must be finite and no longer than 1",
                i % (size_t)desc->width, i / (size_t)desc->width, (double)image[i][0], (double)image[i][1],
                (double)image[i][2]);
    return true;
}

/* The angle comes from the length of the unit vectors' difference, which is exact for small angles, where the cosine
 * is not. */
double aob_bent_angle(const float a[3], const float b[3])
{
    double la = length_of(a), lb = length_of(b), square = 0;
    if (!(la > 0 && lb > 0))
        return 90;
    for (int c = 0; c < 3; c++)
        square += pow(a[c] / la - b[c] / lb, 2);
    return 2 * asin(fmin(1, sqrt(square) / 2)) * 180 / M_PI;
}

bool aob_bent_counts(const float open[3])
{
    return length_of(open) > AOB_BENT_LEAST;
}

static double mean_of(double sum, size_t count)
{
    return count ? sum / (double)count : NAN;
}

void aob_bent_score(const struct aob_score_desc *desc, const float (*image)[3],
                    const struct aob_bent_truth *truth, struct aob_metrics *metrics)
{
    size_t pixels = (size_t)desc->width * (size_t)desc->height, count = 0, in_band = 0;
    double *angles = AOB_NEW_ARRAY(double, pixels), sum = 0, band = 0, plain = 0;
    for (size_t i = 0; i < pixels; i++) {
        if (aob_score_is_sky(desc, i) || !aob_bent_counts(truth->open[i]))
            continue;
        angles[count] = aob_bent_angle(image[i], truth->open[i]);
        sum += angles[count];
        if ((double)desc->truth[i] < AOB_BAND_LIMIT) {
            band += angles[count];
            plain += aob_bent_angle(truth->normal[i], truth->open[i]);
            in_band++;
        }
        count++;
    }
    metrics->bent_mean = mean_of(sum, count);
    metrics->bent_p95 = count ? aob_quantile(angles, count, 0.95) : NAN;
    metrics->bent_pixels = (double)count;
    metrics->bent_band = mean_of(band, in_band);
    metrics->bent_band_normal = mean_of(plain, in_band);
    metrics->bent_band_pixels = (double)in_band;
    free(angles);
}
