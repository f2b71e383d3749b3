#include "agreement.h"
#include <math.h>
#include "technique/graph.h"

/* Parts of the output's scale, but for the share of pixels. */
struct tolerance {
    double visible_share, bias, rmse;
};
static const struct tolerance of_software = {1e-3, 1e-4, 1e-4}, of_gpu = {0.1, 2e-3, 5e-4},
                              of_lobe = {0.25, 5e-3, 3e-3}, of_light = {0.15, 2e-3, 1e-3};

/* Two floats that stand for neighbouring values of 8 bits are a step and a rounding apart. */
static const double step = 1.0 / 255 + 1e-6;

enum { MOST_COMPONENTS = 4 };
struct sums {
    size_t visible;
    double bias[MOST_COMPONENTS], squares, errors, expected_errors;
};

static const struct tolerance *tolerance_of(enum aob_output output, bool software)
{
    if (software)
        return &of_software;
    switch (output) {
    case AOB_OUT_VISIBILITY:
    case AOB_OUT_BENT_NORMAL:
    case AOB_OUT_VISIBILITY_RGB:
        return &of_gpu;
    case AOB_OUT_SPECULAR:
        return &of_lobe;
    default:
        return &of_light;
    }
}

static bool is_surface(const struct aob_agreement_desc *desc, size_t i)
{
    return desc->depth[i] < desc->sky_depth;
}

/* The mean over the surfaces and channels of what nothing occludes. */
static double open_light(const struct aob_agreement_desc *desc)
{
    double sum = 0;
    size_t surfaces = 0;
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++) {
        const float *n = &desc->normal[4 * i];
        double rgb[3];
        if (!is_surface(desc, i))
            continue;
        aob_light_irradiance(desc->light, aob_vec((double)n[0], (double)n[1], (double)n[2]), rgb);
        sum += (rgb[0] + rgb[1] + rgb[2]) / 3;
        surfaces++;
    }
    return sum / (double)surfaces;
}

static double scale_of(const struct aob_agreement_desc *desc)
{
    switch (desc->output) {
    case AOB_OUT_VISIBILITY:
    case AOB_OUT_VISIBILITY_RGB:
    case AOB_OUT_SPECULAR:
        return 1;
    case AOB_OUT_BENT_NORMAL:
        return 2;
    default:
        return open_light(desc);
    }
}

static void add_pixel(const struct aob_agreement_desc *desc, size_t i, struct aob_agreement *agreement,
                      struct sums *sums)
{
    size_t count = (size_t)aob_output_components(desc->output);
    bool visible = false;
    for (size_t c = 0; c < count; c++) {
        double image = (double)desc->image[count * i + c], expected = (double)desc->expected[count * i + c];
        double truth = desc->truth ? (double)desc->truth[count * i + c] : NAN, d = image - expected;
        visible = visible || !(fabs(d) <= step * agreement->scale);
        sums->bias[c] += d;
        sums->squares += d * d;
        sums->errors += (image - truth) * (image - truth);
        sums->expected_errors += (expected - truth) * (expected - truth);
        if (!(fabs(d) <= agreement->max))
            agreement->max = isnan(d) ? INFINITY : fabs(d);
    }
    agreement->pixels++;
    sums->visible += visible;
}

/* What is no number is the farthest. */
static void choose_bias(const struct sums *sums, struct aob_agreement *agreement)
{
    for (int c = 0; c < aob_output_components(agreement->output); c++) {
        double bias = sums->bias[c] / (double)agreement->pixels;
        if (c > 0 && !isnan(bias) && !(fabs(bias) > fabs(agreement->bias)))
            continue;
        agreement->bias = bias;
        agreement->component = c;
    }
}

void aob_agreement_measure(const struct aob_agreement_desc *desc, struct aob_agreement *agreement)
{
    struct sums sums = {0};
    *agreement = (struct aob_agreement){.output = desc->output, .scale = scale_of(desc)};
    for (size_t i = 0; i < (size_t)desc->width * (size_t)desc->height; i++)
        if (is_surface(desc, i))
            add_pixel(desc, i, agreement, &sums);
    double values = (double)agreement->pixels * aob_output_components(desc->output);
    choose_bias(&sums, agreement);
    agreement->visible_share = (double)sums.visible / (double)agreement->pixels;
    agreement->rms = sqrt(sums.squares / values);
    agreement->rmse = sqrt(sums.errors / values);
    agreement->expected_rmse = sqrt(sums.expected_errors / values);
}

static bool refuse_bias(const struct aob_agreement *a, double most, struct aob_error *error)
{
    bool direction = a->output == AOB_OUT_BENT_NORMAL, less = a->bias < 0;
    const char *how = direction ? (less ? "lower" : "higher") : less ? "darker" : "brighter";
    if (aob_output_components(a->output) == 1)
        return aob_fail(error, "the image is %.5f %s on the whole (%g may be)", fabs(a->bias), how, most);
    return aob_fail(error, "its %c is %.5f %s on the whole (%.3g may be)",
                    (direction ? "XYZ" : "RGB")[a->component], fabs(a->bias), how, most);
}

bool aob_agreement_judge(const struct aob_agreement *a, bool software, struct aob_error *error)
{
    const struct tolerance *most = tolerance_of(a->output, software);
    if (!a->pixels)
        return aob_fail(error, "the view shows no surface");
    if (!(a->visible_share <= most->visible_share))
        return aob_fail(error, "%.2f %% of the pixels differ by more than %.3g/255 (%g %% may)",
                        100 * a->visible_share, a->scale, 100 * most->visible_share);
    if (!(fabs(a->bias) <= most->bias * a->scale))
        return refuse_bias(a, most->bias * a->scale, error);
    if (!isnan(a->expected_rmse) && !(fabs(a->rmse - a->expected_rmse) <= most->rmse * a->scale))
        return aob_fail(error,
                        "its RMSE against the truth is %.5f where that of the software drivers is %.5f",
                        a->rmse, a->expected_rmse);
    return true;
}
