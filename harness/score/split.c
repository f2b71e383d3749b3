#include "split.h"
#include <math.h>

void aob_split(const struct aob_score_desc *desc, const float *definition, const float *screen,
               struct aob_metrics *metrics)
{
    double square[3] = {0}, product[3] = {0}, claim = 0;
    size_t count = 0;
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++) {
        if (aob_score_is_sky(desc, i))
            continue;
        double part[3] = {(double)definition[i] - (double)desc->truth[i],
                          (double)screen[i] - (double)definition[i],
                          (double)desc->image[i] - (double)screen[i]};
        for (int k = 0; k < 3; k++) {
            square[k] += part[k] * part[k];
            product[k] += part[k] * part[(k + 1) % 3];
        }
        claim += (double)desc->image[i] - (double)definition[i];
        count++;
    }
    double n = count ? (double)count : NAN;
    metrics->definition_rmse = sqrt(square[0] / n);
    metrics->missing_rmse = sqrt(square[1] / n);
    metrics->estimator_rmse = sqrt(square[2] / n);
    metrics->claim_bias = claim / n;
    metrics->definition_missing = product[0] / n;
    metrics->missing_estimator = product[1] / n;
    metrics->definition_estimator = product[2] / n;
}
