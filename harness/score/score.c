#include "score.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/statistics.h"

bool aob_score_is_sky(const struct aob_score_desc *desc, size_t i)
{
    return !(desc->depth[i] < desc->sky_depth);
}

static bool near_border(const struct aob_score_desc *desc, int x, int y, size_t i)
{
    double reach = desc->radius / (desc->pixel_scale * (desc->perspective ? desc->depth[i] : 1));
    double horizontal = fmin(x + 0.5, desc->width - x - 0.5),
           vertical = fmin(y + 0.5, desc->height - y - 0.5);
    return fmin(horizontal, vertical) < reach;
}

bool aob_score_judge(const struct aob_score_desc *desc, struct aob_error *error)
{
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        if (!aob_score_is_sky(desc, i) && !(desc->image[i] >= 0 && desc->image[i] <= 1))
            return aob_fail(error, "pixel (%zu, %zu) is %g: visibility must be finite and within 0..1",
                            i % (size_t)desc->width, i / (size_t)desc->width, (double)desc->image[i]);
    return true;
}

/* What all but a hundredth of the pixels at each end span: single pixels of noise, or of an edge, decide nothing. */
struct span {
    double low, high;
};

static struct span span_of(const struct aob_score_desc *desc, const float *image)
{
    double *values = AOB_NEW_ARRAY(double, (size_t)desc->width *(size_t)desc->height);
    size_t count = 0;
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        if (!aob_score_is_sky(desc, i))
            values[count++] = (double)image[i];
    struct span span = {NAN, NAN};
    if (count)
        span = (struct span){aob_quantile(values, count, 0.01), aob_quantile(values, count, 0.99)};
    free(values);
    return span;
}

static bool spans(struct span span, double least)
{
    return span.high - span.low > least;
}

bool aob_score_judge_drawn(const struct aob_score_desc *desc, const float *claim, struct aob_error *error)
{
    const double step = 0.002, shade = 0.05; /* half a step of eight bits; what nobody overlooks */
    struct span image = span_of(desc, desc->image), truth = span_of(desc, desc->truth);
    if (spans(image, step) || !spans(truth, shade) || (claim && !spans(span_of(desc, claim), shade)))
        return true;
    return aob_fail(error, "draws nothing: %g in 98 %% of the pixels, where the truth spans %.3f .. %.3f",
                    image.low, truth.low, truth.high);
}

struct sums {
    double square, band, border, se, bias;
    size_t count, band_count, border_count;
};

static void add_pixel(const struct aob_score_desc *desc, int x, int y, struct sums *sums, double *errors)
{
    size_t i = (size_t)y * (size_t)desc->width + (size_t)x;
    if (aob_score_is_sky(desc, i))
        return;
    double e = (double)desc->image[i] - desc->truth[i];
    sums->square += e * e;
    sums->bias += e;
    sums->se += desc->truth_se ? (double)desc->truth_se[i] * desc->truth_se[i] : 0;
    if (desc->truth[i] < AOB_BAND_LIMIT) {
        sums->band += e * e;
        sums->band_count++;
    }
    if (near_border(desc, x, y, i)) {
        sums->border += e * e;
        sums->border_count++;
    }
    errors[sums->count++] = fabs(e);
}

static double mean(double sum, size_t count)
{
    return count ? sum / (double)count : NAN;
}

void aob_score(const struct aob_score_desc *desc, struct aob_metrics *metrics)
{
    struct sums sums = {0};
    double *errors = AOB_NEW_ARRAY(double, (size_t)desc->width *(size_t)desc->height);
    for (int y = 0; y < desc->height; y++)
        for (int x = 0; x < desc->width; x++)
            add_pixel(desc, x, y, &sums, errors);
    double total = 0;
    for (size_t i = 0; i < sums.count; i++)
        total += errors[i];
    aob_metrics_init(metrics);
    metrics->rmse = sqrt(mean(sums.square, sums.count));
    metrics->mae = mean(total, sums.count);
    metrics->bias = mean(sums.bias, sums.count);
    metrics->p95 = sums.count ? aob_quantile(errors, sums.count, 0.95) : NAN;
    metrics->max = sums.count ? aob_quantile(errors, sums.count, 1) : NAN;
    metrics->band_rmse = sqrt(mean(sums.band, sums.band_count));
    metrics->border_rmse = sqrt(mean(sums.border, sums.border_count));
    metrics->border_share = sums.square > 0 ? sums.border / sums.square : 0;
    metrics->reference_se = sqrt(mean(sums.se, sums.count));
    metrics->pixels = (double)sums.count;
    metrics->band_pixels = (double)sums.band_count;
    free(errors);
}
