#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "half.h"
#include "score/score.h"
#include "rig.h"

enum { W = 160, H = 90 };

static const double bias = 1e-4, epsilon = 1e-4;

static struct aob_vec3 position_at(const struct aob_rig *rig, int x, int y)
{
    const struct aob_projection *p = &rig->gbuffer.projection;
    bool inside = x >= 0 && y >= 0 && x < p->width && y < p->height;
    double z = inside ? (double)rig->gbuffer.depth[y * p->width + x] : 1e9; /* nothing there */
    return aob_vec((x + 0.5 - p->cx) * p->sx * z, -(y + 0.5 - p->cy) * p->sy * z, -z);
}

/* Equation 10 by another rule: a polar grid of equal areas in double precision, on the same depth buffer; sigma is 1. */
static double by_quadrature(const struct aob_rig *rig, int x, int y, double radius)
{
    enum { RINGS = 48, SPOKES = 96 };
    x += rig->guard;
    y += rig->guard;
    const float *normal = &rig->gbuffer.normal[4 * (y * rig->gbuffer.projection.width + x)];
    struct aob_vec3 c = position_at(rig, x, y), n = aob_vec(normal[0], normal[1], normal[2]);
    double disc = radius / (rig->gbuffer.projection.sy * -c.z), sum = 0;
    for (int ring = 0; ring < RINGS; ring++)
        for (int spoke = 0; spoke < SPOKES; spoke++) {
            double r = disc * sqrt((ring + 0.5) / RINGS), a = 2 * M_PI * (spoke + 0.5 * (ring & 1)) / SPOKES;
            struct aob_vec3 v = aob_vec_sub(
                position_at(rig, x + (int)floor(0.5 + r * cos(a)), y + (int)floor(0.5 + r * sin(a))), c);
            double vv = aob_vec_dot(v, v);
            if (vv < radius * radius)
                sum += fmax(0, aob_vec_dot(v, n) + c.z * bias) / (vv + epsilon);
        }
    return fmax(0, 1 - 2 * sum / (RINGS * SPOKES));
}

static void test_against_quadrature(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H];
    double sum = 0, bright = 0;
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "alchemy", "radius=0.5 intensity=2 samples=1024 blur=0", AOB_FETCH_SAMPLED, ao);
    size_t occluded = 0;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            double truth = by_quadrature(&rig, x, y, 0.5), e = ao[y * W + x] - truth;
            sum += e * e;
            bright += e;
            occluded += truth < 0.9;
        }
    double rmse = sqrt(sum / (W * H));
    printf("alchemy, 1024 samples, against quadrature of equation 10: RMSE %.4f, bias %+.5f\n", rmse,
           bright / (W * H));
    assert_true(occluded > 500);
    assert_true(rmse <= 0.005);
    assert_true(fabs(bright / (W * H)) <= 0.001);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* contrast is the exponent, intensity the factor of what is subtracted. */
static void test_intensity_and_contrast(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float base[W * H], doubled[W * H], squared[W * H];
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "alchemy", "samples=64 blur=0", AOB_FETCH_SAMPLED, base);
    aob_rig_run(&rig, gpu, "alchemy", "samples=64 blur=0 intensity=2", AOB_FETCH_SAMPLED, doubled);
    aob_rig_run(&rig, gpu, "alchemy", "samples=64 blur=0 contrast=2", AOB_FETCH_SAMPLED, squared);
    for (int i = 0; i < W * H; i++) { /* 0.002: three half-precision steps */
        assert_near(squared[i], base[i] * base[i], 0.002);
        if (base[i] > 0.51)
            assert_near(doubled[i], 1 - 2 * (1 - base[i]), 0.002);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_open_plane(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H];
    aob_rig_scene(&rig, "plane", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "alchemy", "", AOB_FETCH_SAMPLED, ao);
    for (int i = 0; i < W * H; i++)
        assert_true(ao[i] >= 0.995f);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static double rmse_of(const float *a, const float *b, int count, double *bias)
{
    double sum = 0;
    *bias = 0;
    for (int i = 0; i < count; i++) {
        sum += pow((double)a[i] - (double)b[i], 2);
        *bias += ((double)a[i] - (double)b[i]) / count;
    }
    return sqrt(sum / count);
}

/* Section 2.3: "values within two orders of magnitude of epsilon = 0.0001 produced indistinguishable results",
 * at a radius of 0.5 and sigma 1: shares 4e-4 and 2. The exponents are those of the shares' factor 4. */
static void test_epsilon_does_not_show(void **state)
{
    (void)state;
    static const char *const views[][2] = {{"corner", "front"}, {"atrium", "nave"}, {"machine", "front"}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (size_t s = 0; s < AOB_COUNT(views); s++) {
        struct aob_rig rig;
        float base[W * H], other[W * H], raw[W * H];
        aob_rig_scene(&rig, views[s][0], views[s][1], W, H, 0);
        aob_rig_run(&rig, gpu, "alchemy", "intensity=2", AOB_FETCH_SAMPLED, base);
        aob_rig_run(&rig, gpu, "alchemy", "intensity=2 blur=0", AOB_FETCH_SAMPLED, raw);
        printf("alchemy on %s, RMSE x 255 to epsilon 4e-4 (before the blur):", views[s][0]);
        for (int e = -6; e <= -2; e += e == -6 ? 3 : 1) {
            char params[64];
            double bias, filtered, plain;
            snprintf(params, sizeof params, "intensity=2 epsilon=4e%d", e);
            aob_rig_run(&rig, gpu, "alchemy", params, AOB_FETCH_SAMPLED, other);
            filtered = rmse_of(other, base, W * H, &bias);
            snprintf(params, sizeof params, "intensity=2 blur=0 epsilon=4e%d", e);
            aob_rig_run(&rig, gpu, "alchemy", params, AOB_FETCH_SAMPLED, other);
            plain = rmse_of(other, raw, W * H, &bias);
            printf(" 4e%d %.2f (%.2f)", e, 255 * filtered, 255 * plain);
            assert_true(e == -2 || filtered <= 1.0 / 255);
            assert_true(e == -6 || bias > 0); /* too large, it lets light into corners */
        }
        printf("\n");
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Where epsilon = 1e-2 leaks: at the crease, since it takes sqrt(epsilon) = 0.1 for a distance. */
static void test_large_epsilon_leaks_into_corners(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float base[W * H], leaking[W * H];
    double sums[2] = {0};
    size_t counts[2] = {0};
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "alchemy", "samples=64 intensity=2", AOB_FETCH_SAMPLED, base);
    aob_rig_run(&rig, gpu, "alchemy", "samples=64 intensity=2 epsilon=4e-2", AOB_FETCH_SAMPLED, leaking);
    for (int i = 0; i < W * H; i++) {
        struct aob_vec3 p;
        if (!aob_rig_position(&rig, i % W, i / W, &p) || fmax(p.y, p.z) > 0.4)
            continue;
        int far = fmax(p.y, p.z) > 0.2;
        sums[far] += leaking[i] - base[i];
        counts[far]++;
    }
    assert_true(counts[0] > 100 && counts[1] > 100);
    double near = sums[0] / (double)counts[0], far = sums[1] / (double)counts[1];
    printf("alchemy, epsilon 1e-2: brighter by %.3f within 0.2 m of the crease, %.3f at 0.2 to 0.4 m\n", near,
           far);
    assert_true(near > 0.02 && near > 2 * far);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

enum {
    WIDE = 2 * W,
    HIGH = 2 * H
}; /* at 160x90 the disc at 16 m is three pixels: a tap in ten is the pixel itself */

/* Mean over a plane's pixels within the far plane of the encodings. */
static double plane_mean(struct aob_gpu *gpu, const struct aob_rig *rig, const char *params)
{
    float ao[WIDE * HIGH];
    double sum = 0;
    size_t count = 0;
    aob_rig_run(rig, gpu, "alchemy", params, AOB_FETCH_SAMPLED, ao);
    for (int i = 0; i < WIDE * HIGH; i++)
        if (rig->gbuffer.depth[i] < 95) {
            sum += ao[i];
            count++;
        }
    assert_true(count > WIDE * HIGH / 2);
    return sum / (double)count;
}

/* Means over azimuths of the tilt: 8-bit normals round them differently. */
static void plane_means(struct aob_gpu *gpu, double distance, double tilt, const char *encoding,
                        double mean[2])
{
    enum { AZIMUTHS = 2 }; /* of a quarter turn: the others round alike */
    mean[0] = mean[1] = 0;
    for (int a = 0; a < AZIMUTHS; a++) {
        struct aob_rig rig;
        aob_rig_plane(&rig, &(struct aob_rig_plane){.distance = distance,
                                                    .fov_deg = 45,
                                                    .tilt_deg = tilt,
                                                    .azimuth_deg = 90.0 * a / AZIMUTHS,
                                                    .width = WIDE,
                                                    .height = HIGH});
        for (int i = 0; i < 2; i++) {
            char params[160];
            snprintf(params, sizeof params, "radius=0.5 intensity=2 blur=0 bias=%s far=100 %s",
                     i ? "1e-4" : "0", encoding);
            mean[i] += plane_mean(gpu, &rig, params) / AZIMUTHS;
        }
        aob_rig_finish(&rig);
    }
    printf("alchemy, plane at %g m, tilt %g, %s: mean %.4f without bias, %.4f with 1e-4\n", distance, tilt,
           encoding, mean[0], mean[1]);
}

/* Figure 4: 8-bit normals and 16-bit positions darken a plane by itself; a bias of 1e-4 cures it. */
static void test_bias_cures_coarse_encodings(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    double mean[2];
    for (double distance = 8; distance <= 16; distance *= 2)
        for (double tilt = 0; tilt <= 60; tilt += 30) {
            plane_means(gpu, distance, tilt, "normal_encoding=rgba8 depth_encoding=unorm16", mean);
            assert_true(tilt > 30 || mean[0] <= 0.99);
            assert_true(tilt > 30 || mean[1] >= 0.995);
            assert_true(mean[1] > mean[0]);
            plane_means(gpu, distance, tilt, "normal_encoding=rgba8 depth_encoding=r16f", mean);
        }
    aob_gpu_close(gpu);
}

/* By octaves of the depth from 5 m on. */
static void expect_fewer_farther(const double samples[4], const size_t pixels[4])
{
    double before = INFINITY;
    for (int i = 0; i < 4; i++)
        if (pixels[i]) {
            double mean = samples[i] / (double)pixels[i];
            printf("alchemy, bands: %.2f samples a pixel at %d m and beyond (%zu pixels)\n", mean, 5 << i,
                   pixels[i]);
            assert_true(mean < before);
            before = mean;
        }
}

/* Table 1, figure 5: a pixel whose disc covers b bands has the image of b times as many fixed samples. */
static void test_bands(void **state)
{
    (void)state;
    enum { BANDS = 3, EACH = 4, PIXELS = 2 };
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float banded[W * H], fixed[BANDS + 1][W * H];
    double samples[4] = {0};
    size_t other = 0, pixels[4] = {0};
    aob_rig_scene(&rig, "atrium", "nave", W, H, 0);
    for (double radius = 0.01; radius < 1; radius *= 40) { /* 0.01: less than half a pixel at most places */
        char params[160];
        snprintf(params, sizeof params, "blur=0 radius=%g samples_per_band=%d bands=%d band_pixels=%d",
                 radius, EACH, BANDS, PIXELS);
        aob_rig_run(&rig, gpu, "alchemy", params, AOB_FETCH_SAMPLED, banded);
        for (int b = 1; b <= BANDS; b++) {
            snprintf(params, sizeof params, "blur=0 radius=%g samples=%d", radius, b * EACH);
            aob_rig_run(&rig, gpu, "alchemy", params, AOB_FETCH_SAMPLED, fixed[b]);
        }
        for (int i = 0; i < W * H; i++) {
            double disc = radius / (rig.gbuffer.projection.sy * (double)rig.gbuffer.depth[i]);
            int b = (int)fmin(fmax(ceil((disc - 0.5) / PIXELS), 0), BANDS);
            other += fabs((double)banded[i] - (b ? (double)fixed[b][i] : 1)) > 1e-3;
            if (radius > 0.1 && rig.hits.depth[i] > 0) {
                int octave = (int)fmin(fmax(log2((double)rig.gbuffer.depth[i] / 5), 0), 3);
                samples[octave] += b * EACH;
                pixels[octave]++;
            }
        }
    }
    expect_fewer_farther(samples, pixels);
    printf("alchemy, bands: %zu of %d values differ from those of fixed counts\n", other, 2 * W * H);
    assert_true(pixels[0] && pixels[1] && pixels[2]);
    assert_true(other <= 4); /* a disc on the edge of two bands */
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* The cross is the mean of the pixels that are of the centre's surface: floor or wall of the corner, at right angles. */
static void test_composite_is_the_mean_of_a_cross(void **state)
{
    (void)state;
    static const int cross[5][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float off[W * H], on[W * H];
    size_t creases = 0;
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "alchemy", "blur=0 samples=3", AOB_FETCH_SAMPLED, off);
    aob_rig_run(&rig, gpu, "alchemy", "blur=0 samples=3 composite=on", AOB_FETCH_SAMPLED, on);
    for (int y = 1; y < H - 1; y++)
        for (int x = 1; x < W - 1; x++) {
            const float *n = &rig.gbuffer.normal[4 * (y * W + x)];
            double sum = 0, count = 0;
            for (int i = 0; i < 5; i++) {
                int j = (y + cross[i][1]) * W + x + cross[i][0];
                const float *m = &rig.gbuffer.normal[4 * j];
                bool same = n[0] * m[0] + n[1] * m[1] + n[2] * m[2] > 0.5f;
                sum += same ? (double)off[j] : 0;
                count += same;
            }
            creases += count < 5;
            assert_near(on[y * W + x], sum / count, 1e-3);
        }
    assert_true(creases > W / 2);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* A technique of discs is off its definition, of directions, by what equation 10 is ("this selection biases the samples",
 * section 2.3). The samples add at most what is asked of the techniques on this scene (test_gtao.c). */
static void test_corner_against_own_definition(void **state)
{
    (void)state;
    static const double bar = 0.012;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H], truth[W * H];
    aob_rig_scene(&rig, "corner", "front", W, H, 64);
    for (int i = 0; i < 3; i++) {
        char params[120];
        double sum = 0, loss = 0, apart = 0, count = 0, r = 0.5 * (1 << i);
        snprintf(params, sizeof params, "blur=0 samples=1024 radius=%g intensity=%g epsilon=%g", r, 1 / r,
                 1e-4 / (r * r));
        aob_rig_run(&rig, gpu, "alchemy", params, AOB_FETCH_SAMPLED, ao);
        aob_rig_definition(&rig, "alchemy", params, 128, truth);
        for (int k = 0; k < W * H; k++)
            if (truth[k] < (float)AOB_BAND_LIMIT) {
                double equation = by_quadrature(&rig, k % W, k / W, r);
                sum += pow((double)ao[k] - (double)truth[k], 2);
                loss += pow(equation - (double)truth[k], 2);
                apart += pow((double)ao[k] - equation, 2);
                count++;
            }
        printf(
            "alchemy on corner, R = %g: in-band RMSE %.4f to its own definition, from which equation 10 is "
            "%.4f; %.4f to the equation\n",
            r, sqrt(sum / count), sqrt(loss / count), sqrt(apart / count));
        assert_true(count > 1000);
        assert_true(sqrt(apart / count) <= bar);
        assert_true(sqrt(sum / count) <= sqrt(loss / count) + bar);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_divided_size(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float full[W * H], low[W * H];
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "alchemy", "samples=64 intensity=2", AOB_FETCH_SAMPLED, full);
    for (int divisor = 2; divisor <= 4; divisor *= 2) {
        char params[80];
        size_t alone, phantoms;
        double bias, rmse;
        snprintf(params, sizeof params, "samples=64 intensity=2 divisor=%d", divisor);
        aob_rig_run(&rig, gpu, "alchemy", params, AOB_FETCH_SAMPLED, low);
        phantoms = aob_half_phantoms(&rig, low, divisor, &alone);
        rmse = rmse_of(low, full, W * H, &bias);
        printf("alchemy, divisor %d: RMSE %.4f, bias %+.4f to full size; %zu phantoms, %zu pixels alone\n",
               divisor, rmse, bias, phantoms, alone);
        assert_int_equal(phantoms, 0);
        assert_true(alone < W * H / 50);
        assert_true(rmse <= (divisor == 2 ? 0.053 : 0.095));
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_against_quadrature),
                                       cmocka_unit_test(test_intensity_and_contrast),
                                       cmocka_unit_test(test_open_plane),
                                       cmocka_unit_test(test_epsilon_does_not_show),
                                       cmocka_unit_test(test_large_epsilon_leaks_into_corners),
                                       cmocka_unit_test(test_bias_cures_coarse_encodings),
                                       cmocka_unit_test(test_bands),
                                       cmocka_unit_test(test_composite_is_the_mean_of_a_cross),
                                       cmocka_unit_test(test_corner_against_own_definition),
                                       cmocka_unit_test(test_divided_size)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
