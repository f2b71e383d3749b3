#include <math.h>
#include "base/json.h"
#include "measure.h"

static bool table_records(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    static const char *const values[] = {"samples_per_band=2", "samples_per_band=3", "samples_per_band=4"};
    return aob_paper_find_all(run, "alchemy", values, 3, records, error);
}

MEASURE(aob_paper_alchemy_samples)
{
    const json_t *records[3];
    if (!table_records(run, records, error))
        return false;
    aob_paper_costs_to_first(records, 3, "obscurance", result->measured);
    return true;
}

/* A straight line through the costs of 2 and 4 samples: what it says of none. The text's times have nothing there. */
WHY(aob_paper_alchemy_samples_why)
{
    struct aob_paper_figure before = aob_paper_difference(aob_paper_exact(2), outcome->result.measured[2]);
    if (aob_paper_above(before, 0) != AOB_PAPER_YES)
        return;
    aob_text_add(reason, "before its first sample a pixel costs ");
    aob_paper_figure_print(before, reason);
    aob_text_add(reason,
                 " of the time of 2 samples a band, by the line through 2 and 4; in the text nothing");
}

MEASURE(aob_paper_alchemy_filter)
{
    const json_t *records[3];
    if (!table_records(run, records, error))
        return false;
    result->measured[0] =
        aob_paper_quotient(aob_paper_cost(records[2], "blur"), aob_paper_cost(records[0], "blur"));
    return true;
}

/* The text's 1.0 and 0.7 ms leave at most a quarter: of times from 0.95 to 1.05 and 0.65 to 0.75 the nearest. */
WHY(aob_paper_alchemy_filter_why)
{
    const double most = 1 - 9.0 / 4 * (0.95 / 0.75 - 1);
    struct aob_paper_figure growth = aob_paper_difference(outcome->result.measured[0], aob_paper_exact(1)),
                            beside =
                                aob_paper_difference(aob_paper_exact(1), aob_paper_scaled(growth, 9.0 / 4));
    if (aob_paper_above(beside, most) != AOB_PAPER_YES)
        return;
    aob_text_add(reason, "beside its taps a pixel costs ");
    aob_paper_figure_print(beside, reason);
    aob_text_add(reason, " of the time of 9; the text's digits leave at most %.2g", most);
}

/* The text gives no figures: time grows up to 1.5 m, and by less a metre from there. */
MEASURE(aob_paper_alchemy_radius)
{
    static const char *const values[] = {"radius=0.25", "radius=0.5", "radius=1",
                                         "radius=1.5",  "radius=2",   "radius=3"};
    const json_t *records[6];
    struct aob_paper_figure *m = result->measured;
    if (!aob_paper_find_all(run, "alchemy", values, 6, records, error))
        return false;
    aob_paper_costs_to_first(records, 6, "obscurance", m);
    struct aob_paper_figure before = aob_paper_scaled(aob_paper_difference(m[3], m[0]), 1 / 1.25),
                            after = aob_paper_scaled(aob_paper_difference(m[5], m[3]), 1 / 1.5);
    result->shape = aob_paper_above(m[3], 1);
    result->holds = aob_paper_both(result->shape, aob_paper_above(aob_paper_difference(before, after), 0));
    return true;
}

static bool distance_records(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    static const char *const values[] = {"eye=0,1,2", "eye=0,2,4", "eye=0,4,8", "eye=0,8,16"};
    return aob_paper_find_all(run, "alchemy", values, 4, records, error);
}

/* Down in all, and no step that is up beyond its noise. */
static enum aob_paper_answer falls(const struct aob_paper_figure *m, size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (aob_paper_above(aob_paper_difference(m[i], m[i - 1]), 0) == AOB_PAPER_YES)
            return AOB_PAPER_NO;
    return aob_paper_above(aob_paper_difference(m[0], m[count - 1]), 0);
}

MEASURE(aob_paper_alchemy_distance)
{
    const json_t *records[4];
    if (!distance_records(run, records, error))
        return false;
    aob_paper_costs_to_first(records, 4, "obscurance", result->measured);
    result->holds = falls(result->measured, 4);
    return true;
}

/* By the rule of the technique's bands (shaders/alchemy/obscurance.glsl), from the depths of the image. */
static double samples_a_pixel(const json_t *record, const struct aob_image *image)
{
    const float *z = aob_image_channel(image, "Z");
    double fov = aob_paper_member(record, "camera", "fov_deg") * M_PI / 180;
    double pixels = aob_paper_member(record, "params", "radius") * image->height / (2 * tan(fov / 2)),
           sum = 0;
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; z && i < count; i++) {
        double bands =
            ceil((pixels / (double)z[i] - 0.5) / aob_paper_member(record, "params", "band_pixels"));
        sum += isfinite(z[i]) ? fmin(fmax(bands, 0), aob_paper_member(record, "params", "bands")) : 0;
    }
    return sum * aob_paper_member(record, "params", "samples_per_band") / (double)count;
}

MEASURE(aob_paper_alchemy_lod)
{
    const json_t *records[4];
    if (!distance_records(run, records, error))
        return false;
    for (int i = 0; i < 4; i++) {
        struct aob_image image = {0};
        if (!aob_paper_image(run, records[i], &image, error))
            return false;
        result->measured[i] = aob_paper_exact(samples_a_pixel(records[i], &image));
        aob_image_finish(&image);
    }
    result->holds = falls(result->measured, 4);
    return true;
}

MEASURE(aob_paper_alchemy_field)
{
    static const char *const values[] = {"fov_deg=30", "fov_deg=60", "fov_deg=90", "fov_deg=120"};
    const json_t *records[4];
    if (!aob_paper_find_all(run, "alchemy", values, 4, records, error))
        return false;
    aob_paper_costs_to_first(records, 4, "obscurance", result->measured);
    result->holds = falls(result->measured, 4);
    return true;
}

/* The fixed pass, which times are in, covers the guard band too: a pixel's cost, times the pixels of the config's
 * picture. --quick takes some of its columns, and beside these the band is no such part. */
MEASURE(aob_paper_alchemy_guard)
{
    static const char *const values[] = {"guard_band=0", "guard_band=32"};
    static const double larger = (1280 + 64) * (720 + 64) / (1280.0 * 720);
    const json_t *records[2];
    if (!aob_paper_find_all(run, "alchemy", values, 2, records, error))
        return false;
    struct aob_paper_figure a_pixel =
        aob_paper_quotient(aob_paper_cost(records[1], NULL), aob_paper_cost(records[0], NULL));
    result->measured[0] = aob_paper_difference(aob_paper_scaled(a_pixel, larger), aob_paper_exact(1));
    return true;
}

/* Volumetric obscurance and Alchemy, side by side. */
static bool find_works(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    records[0] = aob_paper_find(run, "volumetric_obscurance", "samples=6", error);
    records[1] = records[0] ? aob_paper_find(run, "alchemy", "samples=4", error) : NULL;
    return records[1];
}

MEASURE(aob_paper_alchemy_volumetric)
{
    const json_t *records[2];
    if (!find_works(run, records, error))
        return false;
    result->measured[0] =
        aob_paper_quotient(aob_paper_cost(records[0], NULL), aob_paper_cost(records[1], NULL));
    return true;
}

WHY(aob_paper_alchemy_volumetric_why)
{
    const json_t *records[2];
    if (!find_works(outcome->run, records, NULL))
        return;
    struct aob_paper_figure up = aob_paper_cost(records[0], "upsample"),
                            without =
                                aob_paper_quotient(aob_paper_difference(aob_paper_cost(records[0], NULL), up),
                                                   aob_paper_cost(records[1], NULL));
    if (aob_paper_near(outcome->row, &without) != AOB_PAPER_YES)
        return;
    aob_text_add(reason, "VO samples its coarse image up in a pass of its own; without it the quotient is ");
    aob_paper_figure_print(without, reason);
}

/* The share of all the darkening in the image that lies on surfaces that nothing is near to (truth above the band). */
static bool floating(const struct aob_paper_run *run, const json_t *record, struct aob_paper_figure *share,
                     struct aob_error *error)
{
    struct aob_image image = {0};
    if (!aob_paper_image(run, record, &image, error))
        return false;
    const float *ao = aob_image_channel(&image, "technique.AO"),
                *truth = aob_image_channel(&image, "reference.AO"), *z = aob_image_channel(&image, "Z");
    double open = 0, all = 0;
    for (size_t i = 0; ao && truth && z && i < (size_t)image.width * (size_t)image.height; i++) {
        double dark = isfinite(z[i]) ? 1 - (double)ao[i] : 0;
        all += dark;
        open += (double)truth[i] >= 0.995 ? dark : 0;
    }
    *share = aob_paper_exact(open / all);
    aob_image_finish(&image);
    return all > 0 || aob_fail(error, "%s: an image without darkening, or without a reference", run->folder);
}

MEASURE(aob_paper_alchemy_floating)
{
    const json_t *records[2];
    struct aob_paper_figure *m = result->measured;
    if (!find_works(run, records, error) || !floating(run, records[0], &m[0], error) ||
        !floating(run, records[1], &m[1], error))
        return false;
    result->holds = aob_paper_above(aob_paper_difference(m[0], m[1]), 0);
    return true;
}

MEASURE(aob_paper_alchemy_dragon)
{
    static const char *const values[] = {"divisor=2", "divisor=1"};
    const json_t *hbao[2], *alchemy = aob_paper_find(run, "alchemy", "samples_per_band=4", error);
    if (!alchemy || !aob_paper_find_all(run, "hbao", values, 2, hbao, error))
        return false;
    for (int i = 0; i < 2; i++)
        result->measured[i] =
            aob_paper_quotient(aob_paper_cost(hbao[i], NULL), aob_paper_cost(alchemy, NULL));
    return true;
}

MEASURE(aob_paper_alchemy_epsilon)
{
    static const char *const values[] = {"epsilon=4e-6", "epsilon=4e-5", "epsilon=4e-3", "epsilon=4e-2"};
    const json_t *records[4], *middle = aob_paper_find(run, "alchemy", "epsilon=4e-4", error);
    if (!middle || !aob_paper_find_all(run, "alchemy", values, 4, records, error))
        return false;
    result->holds = AOB_PAPER_YES;
    for (int i = 0; i < 4; i++) {
        if (!aob_paper_compare(run, records[i], middle, &result->measured[i], error))
            return false;
        result->holds = aob_paper_both(result->holds, aob_paper_below(result->measured[i], AOB_PAPER_STEP));
    }
    return true;
}

/* The denominator of equation 10 is at most r squared + epsilon: what epsilon adds there, where it fails alone. */
WHY(aob_paper_alchemy_epsilon_why)
{
    const struct aob_paper_figure *m = outcome->result.measured;
    const json_t *record = aob_paper_find(outcome->run, "alchemy", "epsilon=4e-2", NULL);
    double radius = record ? aob_paper_member(record, "params", "radius") : NAN;
    double others = fmax(fmax(m[0].value, m[1].value), m[2].value);
    if (others < AOB_PAPER_STEP && m[3].value >= AOB_PAPER_STEP && radius > 0)
        aob_text_add(
            reason,
            "1e-2 alone differs: it is %.2g of r squared (r = %.2g); the others differ by at most %.2g",
            1e-2 / (radius * radius), radius, others);
}

/* The truth of a plane is 1, so what is darkened there is -bias. The text shows two pictures, and no figure. */
static bool beta_records(const struct aob_paper_run *run, const char *normals, const json_t **records,
                         struct aob_error *error)
{
    for (int i = 0; i < 2; i++) {
        struct aob_text values = {0};
        aob_text_add(&values, "bias=%s normal_encoding=%s", i ? "1e-4" : "0", normals);
        records[i] = aob_paper_find(run, "alchemy", values.data, error);
        aob_text_finish(&values);
        if (!records[i])
            return false;
    }
    return true;
}

MEASURE(aob_paper_alchemy_beta)
{
    const json_t *records[2];
    struct aob_paper_figure *m = result->measured;
    if (!beta_records(run, "rgba8", records, error))
        return false;
    for (int i = 0; i < 2; i++)
        m[i] = aob_paper_exact(-aob_paper_error(records[i], "bias"));
    result->shape = aob_paper_above(aob_paper_difference(m[0], m[1]), 0);
    result->holds =
        aob_paper_both(aob_paper_above(m[0], AOB_PAPER_STEP), aob_paper_below(m[1], AOB_PAPER_STEP));
    return true;
}

WHY(aob_paper_alchemy_beta_why)
{
    const json_t *records[2];
    if (!beta_records(outcome->run, "rgba32f", records, NULL))
        return;
    double left = 0 - aob_paper_error(records[1], "bias"); /* never -0 */
    if (left < AOB_PAPER_STEP && outcome->result.measured[1].value >= AOB_PAPER_STEP)
        aob_text_add(reason, "the step of 8-bit normals: with normals of 32-bit floats 1e-4 leaves %.2g",
                     left);
}
