#include <math.h>
#include "base/json.h"
#include "papers_measure.h"

#define MEASURE(name)                                                                                        \
    bool name(const struct aob_paper_run *run, struct aob_paper_result *result, struct aob_error *error)

/* The records of up to six cases of one technique. */
static bool find_all(const struct aob_paper_run *run, const char *technique, const char *const *values,
                     size_t count, const json_t **records, struct aob_error *error)
{
    for (size_t i = 0; i < count; i++)
        if (!(records[i] = aob_paper_find(run, technique, values[i], error)))
            return false;
    return true;
}

static bool table_records(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    static const char *const values[] = {"samples_per_band=2", "samples_per_band=3", "samples_per_band=4"};
    return find_all(run, "alchemy", values, 3, records, error);
}

MEASURE(aob_paper_alchemy_samples)
{
    const json_t *records[3];
    if (!table_records(run, records, error))
        return false;
    for (int i = 0; i < 3; i++)
        result->measured[i] =
            aob_paper_cost(records[i], "obscurance") / aob_paper_cost(records[0], "obscurance");
    return true;
}

MEASURE(aob_paper_alchemy_filter)
{
    const json_t *records[3];
    if (!table_records(run, records, error))
        return false;
    result->measured[0] = aob_paper_cost(records[2], "blur") / aob_paper_cost(records[0], "blur");
    return true;
}

/* Grows up to 1.5 m, by more than a tenth in all; flat within a tenth beyond. */
MEASURE(aob_paper_alchemy_radius)
{
    static const char *const values[] = {"radius=0.25", "radius=0.5", "radius=1",
                                         "radius=1.5",  "radius=2",   "radius=3"};
    const json_t *records[6];
    double *m = result->measured;
    if (!find_all(run, "alchemy", values, 6, records, error))
        return false;
    for (int i = 0; i < 6; i++)
        m[i] = aob_paper_cost(records[i], "obscurance") / aob_paper_cost(records[0], "obscurance");
    result->holds = m[1] > m[0] && m[2] > m[1] && m[3] > m[2] && m[3] > 1.1 && fabs(m[4] / m[3] - 1) < 0.1 &&
                    fabs(m[5] / m[3] - 1) < 0.1;
    return true;
}

/* The config's four eyes stand at z = 2, 4, 8 and 16. */
static bool distance_records(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    const json_t *record;
    size_t at;
    json_array_foreach(run->records, at, record)
    {
        const json_t *eye = json_object_get(json_object_get(record, "camera"), "eye");
        int i = (int)lround(log2(json_number_value(json_array_get(eye, 2)))) - 1;
        if (i >= 0 && i < 4 && aob_paper_cost(record, "obscurance") > 0)
            records[i] = record;
    }
    for (int i = 0; i < 4; i++)
        if (!records[i])
            return aob_fail(error, "alchemy: no time at distance x%d", 1 << i);
    return true;
}

MEASURE(aob_paper_alchemy_distance)
{
    const json_t *records[4] = {NULL};
    double *m = result->measured;
    if (!distance_records(run, records, error))
        return false;
    for (int i = 0; i < 4; i++)
        m[i] = aob_paper_cost(records[i], "obscurance") / aob_paper_cost(records[0], "obscurance");
    result->holds = m[1] <= m[0] && m[2] < m[1] && m[3] < m[2];
    return true;
}

static double member(const json_t *record, const char *object, const char *name)
{
    return aob_json_to_number(json_object_get(json_object_get(record, object), name));
}

/* By the rule of the technique's bands (shaders/alchemy/obscurance.glsl), from the depths of the image. */
static double samples_a_pixel(const json_t *record, const struct aob_image *image)
{
    const float *z = aob_image_channel(image, "Z");
    double fov = member(record, "camera", "fov_deg") * M_PI / 180;
    double pixels = member(record, "params", "radius") * image->height / (2 * tan(fov / 2)), sum = 0;
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; z && i < count; i++) {
        double bands = ceil((pixels / (double)z[i] - 0.5) / member(record, "params", "band_pixels"));
        sum += isfinite(z[i]) ? fmin(fmax(bands, 0), member(record, "params", "bands")) : 0;
    }
    return sum * member(record, "params", "samples_per_band") / (double)count;
}

MEASURE(aob_paper_alchemy_lod)
{
    const json_t *records[4] = {NULL};
    double *m = result->measured;
    if (!distance_records(run, records, error))
        return false;
    for (int i = 0; i < 4; i++) {
        struct aob_image image = {0};
        if (!aob_paper_image(run, records[i], &image, error))
            return false;
        m[i] = samples_a_pixel(records[i], &image);
        aob_image_finish(&image);
    }
    result->holds = m[1] <= m[0] && m[2] < m[1] && m[3] < m[2];
    return true;
}

/* Records stand in the config's order of fields. */
MEASURE(aob_paper_alchemy_field)
{
    double *m = result->measured;
    result->holds = true;
    for (size_t i = 0; i < 4; i++) {
        m[i] = aob_paper_cost(json_array_get(run->records, i), "obscurance");
        if (!(m[i] > 0))
            return aob_fail(error, "alchemy: no time at field %zu of 4", i + 1);
        result->holds &= i == 0 || m[i] < m[i - 1];
    }
    for (size_t i = 4; i--;)
        m[i] /= m[0];
    return true;
}

/* The fixed pass, which times are in, covers the guard band too: its cost goes with its pixels. */
MEASURE(aob_paper_alchemy_guard)
{
    static const char *const values[] = {"guard_band=0", "guard_band=32"};
    const json_t *records[2];
    if (!find_all(run, "alchemy", values, 2, records, error))
        return false;
    double width = json_number_value(json_object_get(records[0], "width")),
           height = json_number_value(json_object_get(records[0], "height"));
    double larger = (width + 64) * (height + 64) / (width * height);
    result->measured[0] = aob_paper_cost(records[1], NULL) * larger / aob_paper_cost(records[0], NULL) - 1;
    return true;
}

MEASURE(aob_paper_alchemy_volumetric)
{
    const json_t *volumetric = aob_paper_find(run, "volumetric_obscurance", "samples=6", error),
                 *alchemy = volumetric ? aob_paper_find(run, "alchemy", "samples=4", error) : NULL;
    if (alchemy)
        result->measured[0] = aob_paper_cost(volumetric, NULL) / aob_paper_cost(alchemy, NULL);
    return alchemy != NULL;
}

/* Of all the darkening in the image, the share on surfaces that nothing is near to (truth above the band). */
static bool floating(const struct aob_paper_run *run, const json_t *record, double *share,
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
    *share = open / all;
    aob_image_finish(&image);
    return all > 0 || aob_fail(error, "%s: an image without darkening, or without a reference", run->folder);
}

MEASURE(aob_paper_alchemy_floating)
{
    const json_t *volumetric = aob_paper_find(run, "volumetric_obscurance", "samples=6", error),
                 *alchemy = volumetric ? aob_paper_find(run, "alchemy", "samples=4", error) : NULL;
    if (!alchemy || !floating(run, volumetric, &result->measured[0], error) ||
        !floating(run, alchemy, &result->measured[1], error))
        return false;
    result->holds = result->measured[1] < result->measured[0];
    return true;
}

MEASURE(aob_paper_alchemy_dragon)
{
    static const char *const values[] = {"divisor=2", "divisor=1"};
    const json_t *hbao[2], *alchemy = aob_paper_find(run, "alchemy", "samples_per_band=4", error);
    if (!alchemy || !find_all(run, "hbao", values, 2, hbao, error))
        return false;
    for (int i = 0; i < 2; i++)
        result->measured[i] = aob_paper_cost(hbao[i], NULL) / aob_paper_cost(alchemy, NULL);
    return true;
}

MEASURE(aob_paper_alchemy_epsilon)
{
    static const char *const values[] = {"epsilon=1e-6", "epsilon=1e-5", "epsilon=1e-3", "epsilon=1e-2"};
    const json_t *records[4], *middle = aob_paper_find(run, "alchemy", "epsilon=1e-4", error);
    if (!middle || !find_all(run, "alchemy", values, 4, records, error))
        return false;
    result->holds = true;
    for (int i = 0; i < 4; i++) {
        if (!aob_paper_compare(run, records[i], middle, &result->measured[i], error))
            return false;
        result->holds &= result->measured[i] < 1.0 / 255;
    }
    return true;
}

/* The truth of a plane is 1, so its mean visibility is 1 + bias. Cured: above .995, the limit of the band. */
MEASURE(aob_paper_alchemy_beta)
{
    static const char *const values[] = {"bias=0", "bias=1e-4"};
    const json_t *records[2];
    if (!find_all(run, "alchemy", values, 2, records, error))
        return false;
    for (int i = 0; i < 2; i++)
        result->measured[i] = 1 + aob_paper_error(records[i], "bias");
    result->holds = result->measured[0] < 0.995 && result->measured[1] >= 0.995;
    return true;
}

static bool hbao_records(const struct aob_paper_run *run, const json_t **full, const json_t **half,
                         struct aob_error *error)
{
    static const char *const fulls[] = {"directions=4 divisor=1", "directions=8 divisor=1",
                                        "directions=16 divisor=1"},
                             *const halves[] = {"directions=4 divisor=2", "directions=8 divisor=2",
                                                "directions=16 divisor=2"};
    return find_all(run, "hbao", fulls, 3, full, error) && find_all(run, "hbao", halves, 3, half, error);
}

MEASURE(aob_paper_hbao_samples)
{
    const json_t *full[3], *half[3];
    if (!hbao_records(run, full, half, error))
        return false;
    for (int i = 0; i < 3; i++)
        result->measured[i] = aob_paper_cost(full[i], "horizon") / aob_paper_cost(full[0], "horizon");
    return true;
}

MEASURE(aob_paper_hbao_blur)
{
    const json_t *full[3], *half[3];
    if (!hbao_records(run, full, half, error))
        return false;
    result->measured[0] = aob_paper_cost(full[0], "blur") / aob_paper_cost(full[0], "horizon");
    return true;
}

MEASURE(aob_paper_hbao_half)
{
    const json_t *full[3], *half[3];
    if (!hbao_records(run, full, half, error))
        return false;
    for (int i = 0; i < 3; i++)
        result->measured[i] = aob_paper_cost(full[i], NULL) / aob_paper_cost(half[i], NULL);
    return true;
}

MEASURE(aob_paper_hbao_half_ao)
{
    const json_t *full[3], *half[3];
    if (!hbao_records(run, full, half, error))
        return false;
    for (int i = 0; i < 3; i++)
        result->measured[i] = aob_paper_cost(full[i], "horizon") / aob_paper_cost(half[i], "horizon");
    return true;
}

MEASURE(aob_paper_crytek_half)
{
    static const char *const values[] = {"depth_divisor=1", "depth_divisor=2"};
    const json_t *records[2];
    if (!find_all(run, "crytek_ssao", values, 2, records, error))
        return false;
    result->measured[0] = aob_paper_cost(records[0], NULL) / aob_paper_cost(records[1], NULL);
    return true;
}

/* What the estimate errs by, taken off by each unit of added time. */
MEASURE(aob_paper_starcraft2_blur)
{
    static const char *const values[] = {"samples=16 blur_passes=1", "samples=32 blur_passes=1",
                                         "samples=16 blur_passes=2"};
    const json_t *records[3];
    if (!find_all(run, "starcraft2_ssao", values, 3, records, error))
        return false;
    for (int i = 0; i < 2; i++)
        result->measured[i] = (aob_paper_error(records[0], "estimator_rmse") -
                               aob_paper_error(records[i + 1], "estimator_rmse")) /
                              (aob_paper_cost(records[i + 1], NULL) - aob_paper_cost(records[0], NULL));
    result->holds = result->measured[1] > result->measured[0];
    return true;
}

/* 1/100: what two pictures of visibility may differ by to be called a match here. */
MEASURE(aob_paper_gtao_error)
{
    static const char *const values[] = {"slices=1 divisor=1", "slices=3 divisor=1", "slices=9 divisor=1"};
    const json_t *records[3];
    if (!find_all(run, "gtao", values, 3, records, error))
        return false;
    for (int i = 0; i < 3; i++)
        result->measured[i] = aob_paper_error(records[i], "rmse");
    result->measured[3] = aob_paper_error(records[2], "missing_rmse");
    result->holds = result->measured[2] <= 0.01;
    return true;
}

MEASURE(aob_paper_gtao_half)
{
    static const char *const values[] = {"slices=3 divisor=1", "slices=3 divisor=2"};
    const json_t *records[2];
    if (!find_all(run, "gtao", values, 2, records, error))
        return false;
    result->measured[0] = aob_paper_cost(records[0], NULL) / aob_paper_cost(records[1], NULL);
    result->holds = result->measured[0] > 1;
    return true;
}

/* Less the noise of the truth, which enters the squares. */
static double clean_rmse(const json_t *record)
{
    double rmse = aob_paper_error(record, "rmse"), noise = aob_paper_error(record, "reference_se");
    return sqrt(fmax(0, rmse * rmse - noise * noise));
}

MEASURE(aob_paper_aov_solid)
{
    const json_t *record = aob_paper_find(run, "ao_volumes", "radius=0.25", error);
    if (!record)
        return false;
    result->measured[0] = aob_paper_error(record, "bias");
    result->measured[1] = clean_rmse(record);
    result->holds = fabs(result->measured[0]) <= 0.005 && result->measured[1] <= 0.01;
    return true;
}

MEASURE(aob_paper_aov_thin)
{
    const json_t *record = aob_paper_find(run, "ao_volumes", "radius=0.8", error);
    if (!record)
        return false;
    result->measured[0] = aob_paper_error(record, "bias");
    result->holds = result->measured[0] <= -0.01;
    return true;
}
