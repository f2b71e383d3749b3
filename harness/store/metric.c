#include "metric.h"
#include <math.h>
#include <string.h>
#include "base/json.h"

#define METRIC(field, ...)                                                                                   \
    {                                                                                                        \
        .name = #field, .offset = offsetof(struct aob_metrics, field), __VA_ARGS__                           \
    }

const struct aob_metric aob_metric_table[] = {
    METRIC(rmse, .title = "RMSE", .brief = true, .better = AOB_BETTER_LESS,
           .doc = "Root of the mean squared error of visibility, 0 to 1, against the target."),
    METRIC(band_rmse, .title = "RMSE in band", .brief = true, .better = AOB_BETTER_LESS,
           .doc = "RMSE over the pixels whose true visibility is below 0.995: where there is occlusion."),
    METRIC(border_rmse, .title = "RMSE at the border", .better = AOB_BETTER_LESS,
           .doc =
               "RMSE over the pixels that lie nearer to the view's edge than the target's radius reaches."),
    METRIC(border_share, .title = "border share", .better = AOB_BETTER_NONE,
           .doc = "Share of the squared error that lies in those pixels."),
    METRIC(mae, .title = "MAE", .better = AOB_BETTER_LESS, .doc = "Mean of the absolute error."),
    METRIC(bias, .title = "bias", .brief = true, .better = AOB_BETTER_ZERO,
           .doc = "Mean of technique minus reference; a negative one is too dark."),
    METRIC(p95, .title = "p95", .brief = true, .better = AOB_BETTER_LESS,
           .doc = "95th percentile of the absolute error."),
    METRIC(max, .title = "max", .better = AOB_BETTER_LESS, .doc = "Largest absolute error of a pixel."),
    METRIC(reference_se, .title = "reference SE", .better = AOB_BETTER_NONE,
           .doc = "Standard error of the reference itself, as an RMS over the pixels."),
    METRIC(flip, .title = "FLIP", .better = AOB_BETTER_LESS,
           .doc = "Mean difference that one notices between the two images: 0 none, 1 most."),
    METRIC(ssim, .title = "SSIM", .better = AOB_BETTER_MORE,
           .doc = "Mean structural similarity: 1 where the two images are equal."),
    METRIC(pixels, .title = "pixels", .unit = "pixels", .whole = true, .better = AOB_BETTER_NONE,
           .doc = "Pixels that are scored; the sky is not."),
    METRIC(band_pixels, .title = "pixels in band", .unit = "pixels", .whole = true, .better = AOB_BETTER_NONE,
           .doc = "Those of them whose true visibility is below 0.995."),
    METRIC(flicker, .title = "flicker", .brief = true, .better = AOB_BETTER_LESS, .of_sequence = true,
           .doc = "RMS of how much the error changes from frame to frame at one point of a surface."),
    METRIC(definition_rmse, .title = "definition", .better = AOB_BETTER_LESS,
           .doc = "RMS of the part of the error that the technique's definition asks for."),
    METRIC(missing_rmse, .title = "missing", .better = AOB_BETTER_LESS,
           .doc = "RMS of the part that the depth buffer does not know."),
    METRIC(estimator_rmse, .title = "estimator", .better = AOB_BETTER_LESS,
           .doc = "RMS of the part that the technique could still gain from the same depth buffer."),
    METRIC(claim_bias, .title = "bias to own definition", .better = AOB_BETTER_ZERO,
           .doc =
               "Mean of technique minus its own traced definition; a negative one is darker than it claims."),
    METRIC(definition_missing, .group = "covariance", .title = "definition x missing",
           .better = AOB_BETTER_NONE, .doc = "Mean product of these two parts of the error."),
    METRIC(definition_estimator, .group = "covariance", .title = "definition x estimator",
           .better = AOB_BETTER_NONE, .doc = "Mean product of these two parts of the error."),
    METRIC(missing_estimator, .group = "covariance", .title = "missing x estimator",
           .better = AOB_BETTER_NONE, .doc = "Mean product of these two parts of the error."),
    METRIC(bent_mean, .output = AOB_OUT_BENT_NORMAL, .title = "bent normal", .unit = "degrees", .brief = true,
           .better = AOB_BETTER_LESS,
           .doc =
               "Mean angle between the technique's bent normal and the traced mean of the open directions."),
    METRIC(bent_p95, .output = AOB_OUT_BENT_NORMAL, .title = "bent normal p95", .unit = "degrees",
           .better = AOB_BETTER_LESS, .doc = "95th percentile of that angle."),
    METRIC(bent_pixels, .output = AOB_OUT_BENT_NORMAL, .title = "bent normal pixels", .unit = "pixels",
           .whole = true, .better = AOB_BETTER_NONE,
           .doc = "Pixels whose angle counts: those that are not nearly closed."),
    METRIC(bent_band, .output = AOB_OUT_BENT_NORMAL, .title = "bent normal in band", .unit = "degrees",
           .brief = true, .better = AOB_BETTER_LESS,
           .doc = "Mean of that angle over the pixels whose true visibility is below 0.995."),
    METRIC(bent_band_normal, .output = AOB_OUT_BENT_NORMAL, .title = "plain normal in band",
           .unit = "degrees", .better = AOB_BETTER_NONE,
           .doc = "The same of the surface's own normal: what there is to gain."),
    METRIC(bent_band_pixels, .output = AOB_OUT_BENT_NORMAL, .title = "bent normal pixels in band",
           .unit = "pixels", .whole = true, .better = AOB_BETTER_NONE, .doc = "Pixels of these two."),
    METRIC(bounce_rmse, .output = AOB_OUT_VISIBILITY_RGB, .title = "RMSE after bounces",
           .better = AOB_BETTER_LESS,
           .doc = "RMSE of visibility after bounces, over all channels, against the path-traced one."),
    METRIC(bounce_band, .output = AOB_OUT_VISIBILITY_RGB, .title = "RMSE after bounces in band",
           .brief = true, .better = AOB_BETTER_LESS,
           .doc = "The same over the pixels whose true visibility is below 0.995."),
    METRIC(bounce_bias, .output = AOB_OUT_VISIBILITY_RGB, .title = "bias after bounces",
           .better = AOB_BETTER_ZERO, .doc = "Mean of that difference; a negative one is too dark."),
    METRIC(bounce_se, .output = AOB_OUT_VISIBILITY_RGB, .title = "reference SE after bounces",
           .better = AOB_BETTER_NONE,
           .doc = "Standard error of the path-traced reference, as an RMS over pixels and channels."),
    METRIC(bounce_plain, .output = AOB_OUT_VISIBILITY_RGB, .title = "RMSE without bounces in band",
           .better = AOB_BETTER_NONE,
           .doc = "The error in band of the technique's plain visibility: what bounces gain."),
    METRIC(bounce_model, .output = AOB_OUT_VISIBILITY_RGB, .title = "RMSE of the bounce fit in band",
           .better = AOB_BETTER_NONE,
           .doc = "The error in band of the fit of bounces itself, given the true visibility."),
    METRIC(specular_rmse, .output = AOB_OUT_SPECULAR, .title = "relative RMSE of specular",
           .better = AOB_BETTER_LESS,
           .doc = "Relative RMSE of specular occlusion against the traced one of the surface's lobe."),
    METRIC(specular_band, .output = AOB_OUT_SPECULAR, .title = "relative RMSE of specular in band",
           .brief = true, .better = AOB_BETTER_LESS,
           .doc = "The same over the pixels whose true visibility is below 0.995."),
    METRIC(specular_bias, .output = AOB_OUT_SPECULAR, .title = "relative bias of specular",
           .better = AOB_BETTER_ZERO,
           .doc = "Sum of that difference over the sum of the truth; a negative one is too dark."),
    METRIC(specular_se, .output = AOB_OUT_SPECULAR, .title = "relative reference SE of specular",
           .better = AOB_BETTER_NONE,
           .doc = "Standard error of that reference over its own root mean square."),
    METRIC(specular_plain, .output = AOB_OUT_SPECULAR,
           .title = "relative RMSE of visibility as specular in band", .better = AOB_BETTER_NONE,
           .doc = "The relative error in band of the technique's visibility in its place."),
    METRIC(irradiance_rmse, .output = AOB_OUT_IRRADIANCE, .title = "relative RMSE of irradiance",
           .better = AOB_BETTER_LESS,
           .doc = "Relative RMSE of the occluded irradiance against the traced one, over all channels."),
    METRIC(irradiance_band, .output = AOB_OUT_IRRADIANCE, .title = "relative RMSE of irradiance in band",
           .brief = true, .better = AOB_BETTER_LESS,
           .doc = "The same over the pixels whose true visibility is below 0.995."),
    METRIC(irradiance_bias, .output = AOB_OUT_IRRADIANCE, .title = "relative bias of irradiance",
           .better = AOB_BETTER_ZERO,
           .doc = "Sum of that difference over the sum of the truth; a negative one is too dark."),
    METRIC(irradiance_se, .output = AOB_OUT_IRRADIANCE, .title = "relative reference SE of irradiance",
           .better = AOB_BETTER_NONE,
           .doc = "Standard error of that reference over its own root mean square."),
    METRIC(irradiance_plain, .output = AOB_OUT_IRRADIANCE,
           .title = "relative RMSE of plain irradiance in band", .better = AOB_BETTER_NONE,
           .doc = "The relative error in band of visibility times the irradiance of an open surface."),
    METRIC(lit_rmse, .output = AOB_OUT_LIT, .title = "relative RMSE of the lit image",
           .better = AOB_BETTER_LESS,
           .doc = "Relative RMSE of the lit image against the path-traced one, over all channels."),
    METRIC(lit_band, .output = AOB_OUT_LIT, .title = "relative RMSE of the lit image in band", .brief = true,
           .better = AOB_BETTER_LESS,
           .doc = "The same over the pixels whose true visibility is below 0.995."),
    METRIC(lit_bias, .output = AOB_OUT_LIT, .title = "relative bias of the lit image",
           .better = AOB_BETTER_ZERO,
           .doc = "Sum of that difference over the sum of the truth; a negative one is too dark."),
    METRIC(lit_se, .output = AOB_OUT_LIT, .title = "relative reference SE of the lit image",
           .better = AOB_BETTER_NONE,
           .doc = "Standard error of that reference over its own root mean square."),
    METRIC(
        lit_flip, .output = AOB_OUT_LIT, .title = "FLIP of the lit image", .brief = true,
        .better = AOB_BETTER_LESS,
        .doc =
            "Mean difference that one notices between the two lit images at the exposure: 0 none, 1 most."),
    METRIC(lit_exposure, .output = AOB_OUT_LIT, .title = "exposure of the lit image",
           .better = AOB_BETTER_NONE,
           .doc = "What both are multiplied by for that: a white matt surface that faces the light is 1."),
    {.name = NULL},
};

const struct aob_metric *aob_metric_find(const char *name)
{
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        if (strcmp(m->name, name) == 0)
            return m;
    return NULL;
}

double aob_metric_get(const struct aob_metrics *metrics, const struct aob_metric *metric)
{
    double value;
    memcpy(&value, (const char *)metrics + metric->offset, sizeof value);
    return value;
}

void aob_metric_set(struct aob_metrics *metrics, const struct aob_metric *metric, double value)
{
    memcpy((char *)metrics + metric->offset, &value, sizeof value);
}

void aob_metrics_init(struct aob_metrics *metrics)
{
    for (const struct aob_metric *m = aob_metric_table; m->name; m++)
        aob_metric_set(metrics, m, NAN);
}

void aob_metrics_print_brief(const struct aob_metrics *metrics, unsigned outputs, const char *between,
                             struct aob_text *text)
{
    for (const struct aob_metric *m = aob_metric_table; m->name; m++) {
        double value = aob_metric_get(metrics, m);
        if (m->brief && outputs >> m->output & 1 && isfinite(value))
            aob_text_add(text, "%s%s %s%.4f%s%s", between, m->title, value < 0 ? "\u2212" : "", fabs(value),
                         m->unit ? " " : "", m->unit ? m->unit : "");
    }
}

static json_t *value_to_json(const struct aob_metric *metric, double value)
{
    return metric->whole && isfinite(value) ? json_integer((json_int_t)value) : aob_json_number(value);
}

void aob_metrics_to_json(const struct aob_metrics *metrics, unsigned outputs, json_t *object)
{
    for (const struct aob_metric *m = aob_metric_table; m->name; m++) {
        json_t *into = object;
        double value = aob_metric_get(metrics, m);
        if (!(outputs >> m->output & 1) || (m->of_sequence && !isfinite(value)))
            continue;
        if (m->group) {
            into = json_object_get(object, m->group);
            if (!into)
                json_object_set_new(object, m->group, into = json_object());
        }
        json_object_set_new(into, m->name, value_to_json(m, value));
    }
}

void aob_metrics_from_json(struct aob_metrics *metrics, const json_t *object)
{
    for (const struct aob_metric *m = aob_metric_table; m->name; m++) {
        const json_t *from = m->group ? json_object_get(object, m->group) : object;
        aob_metric_set(metrics, m, aob_json_to_number(json_object_get(from, m->name)));
    }
}
