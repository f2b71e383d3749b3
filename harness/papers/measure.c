#include <math.h>
#include "base/json.h"
#include "measure.h"

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

/* R2 of the straight line through the points. */
static double straightness(const double *x, const double *y, int count)
{
    double sx = 0, sy = 0, xx = 0, yy = 0, xy = 0;
    for (int i = 0; i < count; i++) {
        sx += x[i] / count;
        sy += y[i] / count;
    }
    for (int i = 0; i < count; i++) {
        xx += (x[i] - sx) * (x[i] - sx);
        yy += (y[i] - sy) * (y[i] - sy);
        xy += (x[i] - sx) * (y[i] - sy);
    }
    return xy * xy / (xx * yy);
}

/* The text does not say how much it grows. Shape: by more than a twentieth, which noise may be, up to 1.5 m, and less
 * than a tenth up or down from there. */
MEASURE(aob_paper_alchemy_radius)
{
    static const char *const values[] = {"radius=0.25", "radius=0.5", "radius=1",
                                         "radius=1.5",  "radius=2",   "radius=3"};
    static const double radii[] = {0.25, 0.5, 1, 1.5};
    const json_t *records[6];
    double *m = result->measured;
    if (!find_all(run, "alchemy", values, 6, records, error))
        return false;
    for (int i = 0; i < 6; i++)
        m[i] = aob_paper_cost(records[i], "obscurance") / aob_paper_cost(records[0], "obscurance");
    result->shape = m[3] > 1.05 && fabs(m[4] / m[3] - 1) < 0.1 && fabs(m[5] / m[3] - 1) < 0.1;
    result->holds = result->shape && straightness(radii, m, 4) >= 0.9;
    return true;
}

static bool distance_records(const struct aob_paper_run *run, const json_t **records, struct aob_error *error)
{
    static const char *const values[] = {"eye=0,1,2", "eye=0,2,4", "eye=0,4,8", "eye=0,8,16"};
    return find_all(run, "alchemy", values, 4, records, error);
}

/* Nowhere up by more than a twentieth, which noise may be; down by more than that in all. */
static bool falls(const double *m, int count)
{
    bool down = m[count - 1] < 0.95 * m[0];
    for (int i = 1; i < count; i++)
        down &= m[i] <= 1.05 * m[i - 1];
    return down;
}

MEASURE(aob_paper_alchemy_distance)
{
    const json_t *records[4] = {NULL};
    double *m = result->measured;
    if (!distance_records(run, records, error))
        return false;
    for (int i = 0; i < 4; i++)
        m[i] = aob_paper_cost(records[i], "obscurance") / aob_paper_cost(records[0], "obscurance");
    result->holds = falls(m, 4);
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
    result->holds = falls(m, 4);
    return true;
}

MEASURE(aob_paper_alchemy_field)
{
    static const char *const values[] = {"fov_deg=30", "fov_deg=60", "fov_deg=90", "fov_deg=120"};
    const json_t *records[4];
    double *m = result->measured;
    if (!find_all(run, "alchemy", values, 4, records, error))
        return false;
    for (int i = 0; i < 4; i++)
        m[i] = aob_paper_cost(records[i], "obscurance") / aob_paper_cost(records[0], "obscurance");
    result->holds = falls(m, 4);
    return true;
}

/* The fixed pass, which times are in, covers the guard band too: a pixel's cost, times the pixels of the config's
 * picture. --quick takes some of its columns, and beside these the band is no such part. */
MEASURE(aob_paper_alchemy_guard)
{
    static const char *const values[] = {"guard_band=0", "guard_band=32"};
    static const double larger = (1280 + 64) * (720 + 64) / (1280.0 * 720);
    const json_t *records[2];
    if (!find_all(run, "alchemy", values, 2, records, error))
        return false;
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

/* The share of all the darkening in the image that lies on surfaces that nothing is near to (truth above the band). */
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
    static const char *const values[] = {"epsilon=4e-6", "epsilon=4e-5", "epsilon=0.004", "epsilon=0.04"};
    const json_t *records[4], *middle = aob_paper_find(run, "alchemy", "epsilon=0.0004", error);
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

/* The truth of a plane is 1, so its mean visibility is 1 + bias. .995: the limit of the band. */
MEASURE(aob_paper_alchemy_beta)
{
    static const char *const values[] = {"bias=0", "bias=1e-4"};
    const json_t *records[2];
    double *m = result->measured;
    if (!find_all(run, "alchemy", values, 2, records, error))
        return false;
    for (int i = 0; i < 2; i++)
        m[i] = 1 + aob_paper_error(records[i], "bias");
    m[2] = (m[1] - m[0]) / (1 - m[0]);
    result->holds = m[0] < 0.995 && m[2] >= 0.9;
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

/* The noise pattern: what two seeds' images differ by is twice its square. The passes pay if they take off more of it a
 * time. Their "loss of definition" is the same in both images. */
MEASURE(aob_paper_starcraft2_blur)
{
    static const char *const values[] = {"seed=0 samples=16 blur_passes=1", "seed=0 samples=32 blur_passes=1",
                                         "seed=0 samples=16 blur_passes=2"},
                             *const others[] = {"seed=1 samples=16 blur_passes=1",
                                                "seed=1 samples=32 blur_passes=1",
                                                "seed=1 samples=16 blur_passes=2"};
    const json_t *records[3], *seeds[3];
    double *noise = result->measured, *time = noise + 3;
    if (!find_all(run, "starcraft2_ssao", values, 3, records, error) ||
        !find_all(run, "starcraft2_ssao", others, 3, seeds, error))
        return false;
    for (int i = 0; i < 3; i++) {
        if (!aob_paper_compare(run, records[i], seeds[i], &noise[i], error))
            return false;
        noise[i] *= M_SQRT1_2;
    }
    for (int i = 0; i < 2; i++)
        time[i] = aob_paper_cost(records[i + 1], NULL) / aob_paper_cost(records[0], NULL);
    double by_samples = noise[0] - noise[1], by_passes = noise[0] - noise[2];
    result->holds = by_passes > 0 && by_passes * (time[0] - 1) > by_samples * (time[1] - 1);
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
    result->measured[3] = aob_paper_error(records[2], "estimator_rmse");
    result->measured[4] = aob_paper_error(records[2], "missing_rmse");
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

/* The noise of the truth enters the RMSE's square. */
MEASURE(aob_paper_aov_solid)
{
    const json_t *record = aob_paper_find(run, "ao_volumes", "radius=0.25", error);
    double *m = result->measured;
    if (!record)
        return false;
    m[0] = aob_paper_error(record, "bias");
    m[1] = aob_paper_error(record, "rmse");
    m[2] = aob_paper_error(record, "reference_se");
    result->holds = fabs(m[0]) <= 0.005 && m[1] * m[1] <= 0.01 * 0.01 + m[2] * m[2];
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
