#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "half.h"
#include "score/score.h"
#include "rig.h"
#include "spread.h"

enum { W = 160, H = 90, GUARD = 64 };

/* Without blur and amplification unless `params` says so: what comes last counts. */
static void run(const struct aob_rig *rig, struct aob_gpu *gpu, const char *params, float *ao)
{
    char all[200];
    snprintf(all, sizeof all, "blur=0 amplification=off %s", params);
    aob_rig_run(rig, gpu, "crytek_ssao", all, AOB_FETCH_SAMPLED, ao);
}

/* The article's own figure: half of the samples are inside the wall, in each pixel, before amplification. */
static void test_flat_wall_is_one_half(void **state)
{
    (void)state;
    static const char *const kinds[] = {"rotation=matrix", "rotation=mirror", "size=screen", "seed=3",
                                        "depth_divisor=2"};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    struct spread all = {0, 1, 0};
    float ao[W * H];
    aob_rig_plane(&rig, &(struct aob_rig_plane){.distance = 3, .fov_deg = 45, .width = W, .height = H});
    for (int samples = 8; samples <= 24; samples += 8)
        for (size_t k = 0; k < AOB_COUNT(kinds); k++) {
            char params[100];
            snprintf(params, sizeof params, "radius=%g samples=%d %s", k % 2 ? 0.5 : 1.37, samples, kinds[k]);
            run(&rig, gpu, params, ao);
            struct spread s = spread_of(ao, W * H);
            all.least = fmin(all.least, s.least);
            all.most = fmax(all.most, s.most);
        }
    printf("crytek_ssao, flat wall: %.4f to %.4f\n", all.least, all.most);
    assert_true(all.least >= 0.49 && all.most <= 0.51);
    run(&rig, gpu, "amplification=on blur=5", ao);
    struct spread s = spread_of(ao, W * H);
    printf("crytek_ssao, flat wall amplified and blurred: %.4f to %.4f\n", s.least, s.most);
    assert_true(s.least >= 0.749 && s.most <= 0.751);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Moves the pixels that are not sky to the front; their number. */
static int keep_seen(const struct aob_rig *rig, float *ao)
{
    int count = 0;
    for (int i = 0; i < W * H; i++) {
        struct aob_vec3 p;
        if (aob_rig_position(rig, i % W, i / W, &p))
            ao[count++] = ao[i];
    }
    assert_true(count > 5000);
    return count;
}

/* Opposite corners make up for each other at a tilt too; the range check then takes from the near side alone. */
static void test_tilted_wall(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float ao[W * H];
    for (double tilt = 30; tilt <= 60; tilt += 30) {
        struct aob_rig rig;
        aob_rig_plane(&rig, &(struct aob_rig_plane){.distance = 4,
                                                    .fov_deg = 45,
                                                    .tilt_deg = tilt,
                                                    .azimuth_deg = 30,
                                                    .width = W,
                                                    .height = H,
                                                    .guard = GUARD});
        run(&rig, gpu, "range=1e6", ao);
        struct spread free = spread_of(ao, keep_seen(&rig, ao));
        run(&rig, gpu, "", ao);
        struct spread checked = spread_of(ao, keep_seen(&rig, ao));
        run(&rig, gpu, "hemisphere=on", ao);
        struct spread half = spread_of(ao, keep_seen(&rig, ao));
        printf("crytek_ssao, wall of tilt %g: mean %.4f, with the range check %.4f, hemisphere %.4f\n", tilt,
               free.mean, checked.mean, half.mean);
        assert_near(free.mean, 0.5, 0.01);
        assert_true(checked.mean >= free.mean && checked.mean <= 0.53);
        assert_true(half.least >= 0.995);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* At distance d from the edge of a quarter space the shell of radius r is open but for its half below the face, of which
 * the part beyond the edge, (1 - d/r)/4, is open too; the longest offset is `radius`, the shells even in log r. */
static double beside_edge(double d, double radius)
{
    enum { SHELLS = 1000 };
    double sum = 0;
    for (int i = 0; i < SHELLS; i++)
        sum += 0.5 + fmax(0, 1 - d / (radius * exp(-2.4 * (i + 0.5) / SHELLS))) / 4;
    return sum / SHELLS;
}

/* Mean of the pixels within `far` and beyond `near` of the edge x = z = 1, and their error against the closed form. */
static double beside(const struct aob_rig *rig, const float *ao, double near, double far, double *rmse)
{
    double mean = 0, square = 0;
    int count = 0;
    for (int i = 0; i < W * H; i++) {
        struct aob_vec3 p;
        if (!aob_rig_position(rig, i % W, i / W, &p) || 1 - fmin(p.x, p.z) < near || 1 - fmin(p.x, p.z) > far)
            continue;
        mean += (double)ao[i];
        square += pow((double)ao[i] - beside_edge(1 - fmin(p.x, p.z), 0.25), 2);
        count++;
    }
    assert_true(count > 100);
    *rmse = sqrt(square / count);
    return mean / count;
}

static void test_convex_edge_is_brighter(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_mesh mesh = {0};
    struct aob_rig rig;
    struct aob_camera camera = {.eye = {4, 0, 4}, .fov_deg = 15};
    float ao[W * H];
    aob_mesh_add_box(&mesh, aob_vec(-1, -9, -1), aob_vec(1, 9, 1), 0);
    aob_rig_init(&rig, &mesh, &camera, W, H, 0);
    for (int samples = 8; samples <= 512; samples *= 4) {
        char params[60];
        double rmse;
        snprintf(params, sizeof params, "radius=0.25 range=1e6 samples=%d", samples);
        run(&rig, gpu, params, ao);
        double edge = beside(&rig, ao, 0, 0.02, &rmse), face = beside(&rig, ao, 0.3, 0.9, &rmse);
        beside(&rig, ao, 0, 0.9, &rmse);
        printf("crytek_ssao, cube, %d samples: edge %.3f, faces %.3f, RMSE against the closed form %.4f\n",
               samples, edge, face, rmse);
        assert_true(edge > 0.65);
        assert_near(face, 0.5, 0.01);
        if (samples == 512)
            assert_true(rmse <= 0.02);
    }
    aob_mesh_finish(&mesh);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Where the traced visibility of the definition is in band; not mapped. */
static double band_rmse(const float *ao, const float *truth, double open)
{
    double sum = 0;
    size_t count = 0;
    for (int i = 0; i < W * H; i++)
        if ((double)truth[i] < open) {
            sum += pow((double)ao[i] - (double)truth[i], 2);
            count++;
        }
    assert_true(count > 500);
    return sqrt(sum / (double)count);
}

/* Many samples against the ray tracer with the definition's falloff, uniform directions and the half below. */
static void test_corner_against_own_definition(void **state)
{
    (void)state;
    static const struct {
        const char *params;
        double open, bar;
    } rows[] = {{"radius=0.5 range=1e6", 0.4975, 0.01},
                {"radius=1 range=1e6", 0.4975, 0.01},
                {"radius=1 range=1e6 rotation=mirror", 0.4975, 0.01},
                {"radius=1 range=1e6 hemisphere=on", 0.995, 0.013},
                {"radius=1 range=1e6 amplification=on", 0.746, 0.013},
                {"radius=1", 0.4975, 0.018}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H], truth[W * H];
    aob_rig_scene(&rig, "corner", "front", W, H, GUARD);
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        char params[120];
        snprintf(params, sizeof params, "blur=0 amplification=off samples=512 %s", rows[i].params);
        run(&rig, gpu, params, ao);
        aob_rig_definition(&rig, "crytek_ssao", params, 128, truth);
        double rmse = band_rmse(ao, truth, rows[i].open);
        printf("crytek_ssao on corner, 512 samples, %s: in-band RMSE %.4f (bar %.3f)\n", rows[i].params, rmse,
               rows[i].bar);
        assert_true(rmse <= rows[i].bar);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* The text's three kernels against what they converge to, over 4 tiles of random rotations. */
static void test_kernels_of_8_16_24(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H], truth[W * H];
    aob_rig_scene(&rig, "corner", "front", W, H, GUARD);
    aob_rig_definition(&rig, "crytek_ssao", "radius=1 amplification=off samples=4096", 256, truth);
    for (int mirror = 0; mirror < 2; mirror++) {
        double rmse[3] = {0};
        for (int k = 0; k < 12; k++) {
            char params[120];
            snprintf(params, sizeof params, "radius=1 range=1e6 samples=%d rotation=%s seed=%d",
                     8 + k / 4 * 8, mirror ? "mirror" : "matrix", k % 4);
            run(&rig, gpu, params, ao);
            rmse[k / 4] += pow(band_rmse(ao, truth, 0.4975), 2) / 4;
        }
        printf("crytek_ssao on corner, 8, 16, 24 samples, %s, 4 seeds: in-band RMSE %.4f %.4f %.4f\n",
               mirror ? "mirror" : "matrix", sqrt(rmse[0]), sqrt(rmse[1]), sqrt(rmse[2]));
        assert_true(rmse[1] < rmse[0] && rmse[2] < rmse[1]);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_amplification_and_range(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float base[W * H], amplified[W * H], dark[W * H], bright[W * H], free[W * H];
    aob_rig_scene(&rig, "spheres", "close", W, H, 0);
    run(&rig, gpu, "range=0.2", base);
    run(&rig, gpu, "range=0.2 amplification=on", amplified);
    run(&rig, gpu, "range=0.2 range_default=0", dark);
    run(&rig, gpu, "range=0.2 range_default=1", bright);
    run(&rig, gpu, "range=1e6", free);
    size_t brighter = 0;
    for (int i = 0; i < W * H; i++) { /* a step of half precision is up to .0005 */
        if (rig.hits.depth[i] == 0)
            continue;
        assert_near(amplified[i], fminf(1, base[i] * base[i] + base[i]), 0.002);
        assert_near(0.5f * (dark[i] + bright[i]), base[i], 0.001);
        assert_true(dark[i] <= free[i] + 1e-6f && bright[i] >= free[i] - 1e-6f);
        brighter += bright[i] > dark[i] + 0.05f;
    }
    assert_true(brighter > 500);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* On a wall with a block before it, all at one depth: the sphere of 2 z s is the sphere of that radius. */
static void test_size_on_the_screen(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_mesh mesh = {0}, large = {0};
    struct aob_rig rig, scaled;
    struct aob_camera camera = {.eye = {0, 0, 3}, .fov_deg = 60}, far = {.eye = {0, 0, 30}, .fov_deg = 60};
    float scene[W * H], screen[W * H], other[W * H];
    aob_mesh_add_quad(&mesh, aob_vec(-50, -50, 0), aob_vec(100, 0, 0), aob_vec(0, 100, 0));
    aob_mesh_add_box(&mesh, aob_vec(-0.4, -0.4, 0.01), aob_vec(0.4, 0.4, 0.4), 0);
    aob_mesh_add_quad(&large, aob_vec(-500, -500, 0), aob_vec(1000, 0, 0), aob_vec(0, 1000, 0));
    aob_mesh_add_box(&large, aob_vec(-4, -4, 0.1), aob_vec(4, 4, 4), 0);
    aob_rig_init(&rig, &mesh, &camera, W, H, 0);
    aob_rig_init(&scaled, &large, &far, W, H, 0);
    run(&rig, gpu, "radius=0.6", scene);
    run(&rig, gpu, "size=screen screen_radius=0.1 radius=77", screen);
    run(&scaled, gpu, "size=screen screen_radius=0.1", other);
    size_t wall = 0, differ = 0, dark = 0;
    for (int i = 0; i < W * H; i++)
        if (fabs((double)rig.hits.depth[i] - 3) < 1e-4) {
            wall++;
            differ += fabsf(scene[i] - screen[i]) > 1e-3f;
            dark += scene[i] < 0.45f;
        }
    assert_true(wall > 5000 && dark > 200 &&
                differ <= wall / 500); /* a sample on an edge may fall either way */
    differ = 0;
    for (int i = 0; i < W * H; i++)
        differ += fabsf(screen[i] - other[i]) > 1e-3f;
    assert_true(differ <= W * H / 500);
    aob_mesh_finish(&mesh);
    aob_mesh_finish(&large);
    aob_rig_finish(&rig);
    aob_rig_finish(&scaled);
    aob_gpu_close(gpu);
}

/* Longer offsets darken the neighbourhood of the corner from farther. */
static void test_radius_reaches_farther(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H];
    double last = 1;
    aob_rig_scene(&rig, "corner", "front", W, H, GUARD);
    for (double radius = 0.25; radius <= 2; radius *= 2) {
        char params[60];
        snprintf(params, sizeof params, "radius=%g range=1e6", radius);
        run(&rig, gpu, params, ao);
        double mean = spread_of(ao, W * H).mean;
        assert_true(mean < last - 0.003);
        last = mean;
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_divided_sizes(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    enum { FULL_W = 320, FULL_H = 180, COUNT = FULL_W * FULL_H };
    float *full = AOB_NEW_ARRAY(float, COUNT), *low = AOB_NEW_ARRAY(float, COUNT);
    static const char *const rows[] = {"divisor=2",
                                       "divisor=4",
                                       "depth_divisor=2",
                                       "depth_divisor=4",
                                       "divisor=2 depth_divisor=2",
                                       "divisor=2 depth_divisor=4"};
    aob_rig_scene(&rig, "spheres", "front", FULL_W, FULL_H, 0);
    run(&rig, gpu, "samples=64 blur=5", full);
    for (size_t k = 0; k < AOB_COUNT(rows); k++) {
        char params[80];
        double sum = 0;
        size_t seen = 0, alone = 0;
        int divisor = strncmp(rows[k], "divisor=", 8) == 0 ? rows[k][8] - '0' : 1;
        snprintf(params, sizeof params, "samples=64 blur=5 %s", rows[k]);
        run(&rig, gpu, params, low);
        for (int i = 0; i < COUNT; i++)
            if (rig.hits.depth[i] > 0) {
                sum += pow((double)full[i] - (double)low[i], 2);
                seen++;
            }
        size_t phantoms = divisor > 1 ? aob_half_phantoms(&rig, low, divisor, &alone) : 0;
        printf("crytek_ssao, spheres, %s against full size: RMSE %.4f; %zu values between depths, %zu not "
               "judged\n",
               rows[k], sqrt(sum / (double)seen), phantoms, alone);
        assert_int_equal(phantoms, 0);
        assert_true(sqrt(sum / (double)seen) <= 0.05);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
    free(full);
    free(low);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_flat_wall_is_one_half),   cmocka_unit_test(test_tilted_wall),
        cmocka_unit_test(test_convex_edge_is_brighter), cmocka_unit_test(test_corner_against_own_definition),
        cmocka_unit_test(test_kernels_of_8_16_24),      cmocka_unit_test(test_amplification_and_range),
        cmocka_unit_test(test_size_on_the_screen),      cmocka_unit_test(test_radius_reaches_farther),
        cmocka_unit_test(test_divided_sizes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
