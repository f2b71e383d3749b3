#include "effect.h"
#include <math.h>
#include "flip.h"
#include "technique/graph.h"

static bool is_light(const struct aob_effect *effect)
{
    return effect->output == AOB_OUT_IRRADIANCE || effect->output == AOB_OUT_LIT;
}

static bool is_sound(const struct aob_effect *effect, double value)
{
    return value >= 0 && (is_light(effect) ? isfinite(value) : value <= 1.01);
}

bool aob_effect_judge(const struct aob_score_desc *desc, const struct aob_effect *effect,
                      struct aob_error *error)
{
    size_t stride = (size_t)effect->components;
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        for (size_t c = 0; c < stride && !aob_score_is_sky(desc, i); c++)
            if (!is_sound(effect, (double)effect->image[i * stride + c]))
                return aob_fail(error, "pixel (%zu, %zu) of the %s is %g: it must be %s",
                                i % (size_t)desc->width, i / (size_t)desc->width,
                                aob_output_name(effect->output), (double)effect->image[i * stride + c],
                                is_light(effect) ? "finite and not negative" : "finite and within 0..1");
    return true;
}

/* Sums over the channels of the pixels that are no sky, and of those in the band. */
struct sums {
    double square, truth, bias, mean, se, band, band_truth, plain, model;
    size_t count, band_count;
};

static double squared_difference(const float *a, const float *b, size_t at)
{
    return a ? ((double)a[at] - (double)b[at]) * ((double)a[at] - (double)b[at]) : NAN;
}

static void add_channel(const struct aob_effect *effect, size_t at, bool in_band, struct sums *sums)
{
    double truth = (double)effect->truth[at], error = (double)effect->image[at] - truth;
    sums->square += error * error;
    sums->truth += truth * truth;
    sums->bias += error;
    sums->mean += truth;
    sums->se += (double)effect->se[at] * (double)effect->se[at];
    sums->count++;
    if (!in_band)
        return;
    sums->band += error * error;
    sums->band_truth += truth * truth;
    sums->plain += squared_difference(effect->plain, effect->truth, at);
    sums->model += squared_difference(effect->model, effect->truth, at);
    sums->band_count++;
}

struct scores {
    double rmse, band, bias, se, plain, model;
};

static double share(double part, double whole)
{
    return whole > 0 ? part / whole : NAN;
}

/* A relative error is over what the truth is; NAN where there is none. */
static struct scores scores_of(const struct sums *sums, bool relative)
{
    double all = relative ? sums->truth : (double)sums->count;
    double band = relative ? sums->band_truth : (double)sums->band_count;
    double mean = relative ? sums->mean : (double)sums->count;
    return (struct scores){.rmse = sqrt(share(sums->square, all)),
                           .band = sqrt(share(sums->band, band)),
                           .bias = share(sums->bias, mean),
                           .se = sqrt(share(sums->se, all)),
                           .plain = sqrt(share(sums->plain, band)),
                           .model = sqrt(share(sums->model, band))};
}

void aob_effect_score(const struct aob_score_desc *desc, const struct aob_effect *effect,
                      struct aob_metrics *metrics)
{
    struct sums sums = {0};
    size_t stride = (size_t)effect->components;
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        for (size_t c = 0; c < stride && !aob_score_is_sky(desc, i); c++)
            add_channel(effect, i * stride + c, (double)desc->truth[i] < AOB_BAND_LIMIT, &sums);
    struct scores s = scores_of(&sums, effect->output != AOB_OUT_VISIBILITY_RGB);
    switch (effect->output) {
    case AOB_OUT_VISIBILITY_RGB:
        metrics->bounce_rmse = s.rmse, metrics->bounce_band = s.band, metrics->bounce_bias = s.bias;
        metrics->bounce_se = s.se, metrics->bounce_plain = s.plain, metrics->bounce_model = s.model;
        break;
    case AOB_OUT_SPECULAR:
        metrics->specular_rmse = s.rmse, metrics->specular_band = s.band, metrics->specular_bias = s.bias;
        metrics->specular_se = s.se, metrics->specular_plain = s.plain;
        break;
    case AOB_OUT_LIT:
        metrics->lit_rmse = s.rmse, metrics->lit_band = s.band, metrics->lit_bias = s.bias;
        metrics->lit_se = s.se;
        metrics->lit_exposure = effect->exposure;
        metrics->lit_flip = aob_flip_colour(desc, effect->image, effect->truth, effect->exposure);
        break;
    default:
        metrics->irradiance_rmse = s.rmse, metrics->irradiance_band = s.band;
        metrics->irradiance_bias = s.bias, metrics->irradiance_se = s.se;
        metrics->irradiance_plain = s.plain;
    }
}

double aob_effect_bounced(double v, double albedo)
{
    double a = 2.0404 * albedo - 0.3324, b = -4.7951 * albedo + 0.6417, c = 2.7552 * albedo + 0.6903;
    return fmax(v, ((v * a + b) * v + c) * v);
}
