#include "agreement.h"
#include <math.h>

struct tolerance {
    double visible_share, bias, rmse;
};
static const struct tolerance of_software = {1e-3, 1e-4, 1e-4}, of_gpu = {0.1, 2e-3, 5e-4};

static double root_mean(double sum, size_t count)
{
    return sqrt(sum / (double)count);
}

void aob_agreement_measure(const struct aob_agreement_desc *desc, struct aob_agreement *agreement)
{
    double sum = 0, squares = 0, error = 0, expected_error = 0;
    size_t visible = 0, count = (size_t)desc->width * (size_t)desc->height;
    *agreement = (struct aob_agreement){0};
    for (size_t i = 0; i < count; i++) {
        if (!(desc->depth[i] < desc->sky_depth))
            continue;
        double image = (double)desc->image[i], expected = (double)desc->expected[i], d = image - expected;
        double truth = desc->truth ? (double)desc->truth[i] : NAN;
        agreement->pixels++;
        visible += !(fabs(d) <= 1.0 / 255);
        sum += d;
        squares += d * d;
        error += (image - truth) * (image - truth);
        expected_error += (expected - truth) * (expected - truth);
        if (!(fabs(d) <= agreement->max))
            agreement->max = isnan(d) ? INFINITY : fabs(d);
    }
    agreement->visible_share = (double)visible / (double)agreement->pixels;
    agreement->bias = sum / (double)agreement->pixels;
    agreement->rms = root_mean(squares, agreement->pixels);
    agreement->rmse = root_mean(error, agreement->pixels);
    agreement->expected_rmse = root_mean(expected_error, agreement->pixels);
}

bool aob_agreement_judge(const struct aob_agreement *a, bool software, struct aob_error *error)
{
    const struct tolerance *most = software ? &of_software : &of_gpu;
    if (!a->pixels)
        return aob_fail(error, "the view shows no surface");
    if (!(a->visible_share <= most->visible_share))
        return aob_fail(error, "%.2f %% of the pixels differ by more than 1/255 (%g %% may)",
                        100 * a->visible_share, 100 * most->visible_share);
    if (!(fabs(a->bias) <= most->bias))
        return aob_fail(error, "the image is %.5f %s on the whole (%g may be)", fabs(a->bias),
                        a->bias < 0 ? "darker" : "brighter", most->bias);
    if (!isnan(a->expected_rmse) && !(fabs(a->rmse - a->expected_rmse) <= most->rmse))
        return aob_fail(error,
                        "its RMSE against the truth is %.5f where that of the software drivers is %.5f",
                        a->rmse, a->expected_rmse);
    return true;
}
