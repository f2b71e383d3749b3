#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "half.h"
#include "rig.h"

enum { W = 160, H = 90 };
#define NAME "starcraft2_ssao"

static void run(const struct aob_rig *rig, struct aob_gpu *gpu, const char *params, float *pixels)
{
    aob_rig_run(rig, gpu, NAME, params, AOB_FETCH_SAMPLED, pixels);
}

static double rmse(const float *a, const float *b)
{
    double sum = 0;
    for (int i = 0; i < W * H; i++)
        sum += pow((double)a[i] - (double)b[i], 2);
    return sqrt(sum / (W * H));
}

static double mean(const float *a)
{
    double sum = 0;
    for (int i = 0; i < W * H; i++)
        sum += (double)a[i];
    return sum / (W * H);
}

/* Single runs take their parts of the offsets' sequence: 4 small, then 12 wide. */
static void test_darker_of_two_radii(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float both[W * H], small[W * H], wide[W * H];
    int small_wins = 0, wide_wins = 0;
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    run(&rig, gpu, "blur=0 samples=16 radius=1 no_occlusion=1", both);
    run(&rig, gpu,
        "blur=0 radii=one samples=4 radius=0.125 full_occlusion=0.1 "
        "no_occlusion=0.125",
        small);
    run(&rig, gpu, "blur=0 radii=one samples=12 first_sample=4 radius=1 no_occlusion=1", wide);
    for (int i = 0; i < W * H; i++) {
        float dark = fminf(small[i], wide[i]);
        assert_memory_equal(&both[i], &dark, sizeof dark);
        small_wins += small[i] < wide[i];
        wide_wins += wide[i] < small[i];
    }
    printf("two radii: the small set is darker in %d pixels, the wide in %d\n", small_wins, wide_wins);
    assert_true(small_wins > 100 && wide_wins > 100);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_directions(void **state)
{
    (void)state;
    static const struct {
        const char *base, *more;
        int darker; /* 1: `more` is darker, -1 lighter */
    } rows[] = {
        {"radius=0.25", "radius=1", 1},
        {"full_occlusion=0.01", "full_occlusion=0.4", 1},
        {"no_occlusion=0.2", "no_occlusion=1", 1},
        {"power=0.5", "power=4", -1},
        {"epsilon=0.01", "epsilon=0.1", -1},
        {"radii=one", "radii=two", 1},
        {"small_radius=0.05", "small_radius=0.2", 1},
        {"small_full_occlusion=0.02", "small_full_occlusion=0.1", 1},
        {"small_full_occlusion=0.02 small_no_occlusion=0.05", "small_full_occlusion=0.02", 1},
        {"small_full_occlusion=0.02 small_power=0.5", "small_full_occlusion=0.02 small_power=4", -1},
        {"max_screen_radius=2", "max_screen_radius=20", 1},
        {"max_screen_radius=4000", "max_screen_radius=0", 0},
    };
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float base[W * H], more[W * H];
    bool all = true;
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char a[200], b[200];
        snprintf(a, sizeof a, "blur=0 samples=32 %s", rows[i].base);
        snprintf(b, sizeof b, "blur=0 samples=32 %s", rows[i].more);
        run(&rig, gpu, a, base);
        run(&rig, gpu, b, more);
        double change = mean(base) - mean(more);
        printf("%s -> %s: darker by %+.4f\n", rows[i].base, rows[i].more, change);
        all = all && (rows[i].darker ? change * rows[i].darker > 1e-4 : change == 0);
    }
    assert_true(all);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* The table rounds the depth to its nearest texel: away from epsilon's step, half a texel of slope. */
static void test_blocker_table(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float formula[W * H], table[W * H];
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    run(&rig, gpu, "blur=0 samples=64 radii=one epsilon=0", formula);
    run(&rig, gpu, "blur=0 samples=64 radii=one epsilon=0 blocker=table", table);
    double off = rmse(formula, table);
    printf("blocker by table against formula: RMSE %.5f\n", off);
    assert_true(off > 0 && off <= 0.005); /* half a texel: 0.5/255 of the range, over 0.8 of it */
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_against_definition(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H], traced[W * H];
    double sum = 0, bias = 0;
    size_t count = 0;
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    aob_rig_definition(&rig, NAME, "radii=one", 128, traced);
    run(&rig, gpu, "blur=0 samples=1024 radii=one", ao);
    for (int i = 0; i < W * H; i++)
        if (traced[i] < 0.995f) {
            double e = (double)ao[i] - (double)traced[i];
            sum += e * e;
            bias += e;
            count++;
        }
    double off = sqrt(sum / (double)count);
    printf("corner against its definition: in-band RMSE %.4f, bias %+.4f over %zu pixels\n", off,
           bias / (double)count, count);
    assert_true(count > 500);
    assert_true(off <= 0.041); /* measured 0.037: the depth along the view is no function of the ray's */
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_open_plane(void **state)
{
    (void)state;
    static const char *const params[] = {"", "blur=0", "normal_encoding=packed8 depth_encoding=packed16",
                                         "depth_divisor=4", "divisor=2 depth_divisor=2"};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H];
    for (int k = 0; k < 10; k++) {
        if (k < 5)
            aob_rig_scene(&rig, "plane", "front", W, H, 0);
        else
            aob_rig_plane(&rig, &(struct aob_rig_plane){.distance = 4,
                                                        .fov_deg = 45,
                                                        .tilt_deg = 60,
                                                        .azimuth_deg = 30,
                                                        .width = W,
                                                        .height = H});
        run(&rig, gpu, params[k % 5], ao);
        float least = 1;
        for (int i = 0; i < W * H; i++)
            least = fminf(least, ao[i]);
        printf("open plane, '%s': least %.4f, mean %.4f\n", params[k % 5], (double)least, mean(ao));
        assert_true(least >= 0.995f);
        if (k < 9)
            aob_rig_finish(&rig);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* A plane that faces the camera, columns first..end-1 of it nearer by `height`. */
static void strip_rig(struct aob_rig *rig, int first, int end, float height)
{
    aob_rig_plane(rig, &(struct aob_rig_plane){.distance = 4, .fov_deg = 45, .width = W, .height = H});
    for (int i = 0; i < W * H; i++)
        rig->gbuffer.depth[i] -= i % W >= first && i % W < end ? height : 0;
}

struct block {
    double radius, full, none, power, weight;
};

/* What pixel (x, H / 2) of that loses, by a midpoint rule over length, cosine and azimuth in double precision. */
static double strip_occlusion(const struct aob_rig *rig, int x, int first, int end, double height,
                              const struct block *b)
{
    enum { N = 64 };
    const struct aob_projection *p = &rig->gbuffer.projection;
    double z = 4, px = (x + 0.5 - p->cx) * p->sx * z, sum = 0, weights = 0;
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++)
            for (int k = 0; k < 4 * N; k++) {
                double s = 0.5 + 0.5 * (i + 0.5) / N, u = (j + 0.5) / N, a = 2 * M_PI * (k + 0.5) / (4 * N);
                double qz = z - b->radius * s * u, qx = px + b->radius * s * sqrt(1 - u * u) * cos(a);
                double column = floor(qx / (p->sx * qz) + p->cx), delta = qz - (z - height);
                double fall = fmin(1, fmax(0, (b->none - delta) / (b->none - b->full)));
                bool near = column >= first && column < end && delta > 0;
                sum += near ? pow(s, b->weight) * pow(fall, b->power) : 0;
                weights += pow(s, b->weight);
            }
    return sum / weights;
}

/* Thresholds, power and weight against quadrature; with a strip at the image's edge nothing beyond occludes. */
static void test_strips(void **state)
{
    (void)state;
    static const struct {
        int first, end, x;
        struct block block;
    } rows[] = {{0, W / 2, W / 2, {1, 10, 20, 1, 0}},
                {0, W / 2, W / 2, {1, 0.5, 1.25, 1, 0}},
                {0, W / 2, W / 2, {1, 0.5, 1.25, 3, 0}},
                {0, W / 2, W / 2, {1, 0.5, 1.25, 1, -8}},
                {0, W / 2, W / 2, {1, 0.5, 1.25, 1, 8}},
                {0, W / 2, W / 2 + 6, {1, 0.1, 1.25, 0.5, -1}},
                {0, 2, 2, {1, 10, 20, 1, 0}}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct aob_rig rig;
        float ao[W * H];
        char params[200];
        const struct block *b = &rows[i].block;
        snprintf(params, sizeof params,
                 "blur=0 samples=2048 radii=one epsilon=0 radius=%g full_occlusion=%g no_occlusion=%g "
                 "power=%g distance_weight=%g",
                 b->radius, b->full, b->none, b->power, b->weight);
        strip_rig(&rig, rows[i].first, rows[i].end, 1.25f);
        run(&rig, gpu, params, ao);
        double sum = 0, truth = strip_occlusion(&rig, rows[i].x, rows[i].first, rows[i].end, 1.25, b);
        for (int y = H / 2 - 8; y < H / 2 + 8; y++)
            sum += 1 - (double)ao[y * W + rows[i].x];
        printf("strip %zu: occlusion %.4f, quadrature %.4f\n", i, sum / 16, truth);
        assert_true(truth > 0.01);
        assert_near(sum / 16, truth, 0.004);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Eight times the samples where the depth is an eighth of near_distance, no more beyond it. */
static void test_near_samples(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float plain[W * H], more[W * H], eightfold[W * H];
    strip_rig(&rig, 0, W / 2, 0.5f);
    run(&rig, gpu, "blur=0 samples=8", plain);
    run(&rig, gpu, "blur=0 samples=64", eightfold);
    run(&rig, gpu, "blur=0 samples=8 near_factor=8 near_distance=1", more);
    assert_memory_equal(plain, more, sizeof plain); /* all is beyond 1 */
    run(&rig, gpu, "blur=0 samples=8 near_factor=8 near_distance=100", more);
    assert_memory_equal(eightfold, more, sizeof more);
    assert_true(rmse(plain, more) > 0.001);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static void test_encodings_and_sizes(void **state)
{
    (void)state;
    static const struct {
        const char *params;
        double bar;
    } rows[] = {{"blur=0 normal_encoding=packed8 depth_encoding=packed16", 0.001},
                {"blur=0 depth_divisor=4", 0.012},
                {"blur=0 divisor=2", 0.011}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float exact[W * H], other[W * H];
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    run(&rig, gpu, "blur=0 samples=256", exact);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char params[120];
        size_t alone;
        snprintf(params, sizeof params, "samples=256 %s", rows[i].params);
        run(&rig, gpu, params, other);
        printf("spheres, '%s' against exact full size: RMSE %.4f\n", rows[i].params, rmse(exact, other));
        assert_true(rmse(exact, other) <= rows[i].bar);
        if (i == 2)
            assert_int_equal(aob_half_phantoms(&rig, other, 2, &alone), 0);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Past 16 samples extra blur passes are said to pay better than samples. */
static void test_convergence(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    static float converged[W * H], image[W * H];
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    aob_rig_scene(&rig, "cornell", "blocks", W, H, 0);
    run(&rig, gpu, "blur=0 samples=4096", converged);
    printf("error against 4096 samples, 8..256:");
    for (int i = 0; i < 6; i++) {
        char params[40];
        snprintf(params, sizeof params, "blur=0 samples=%d", 8 << i);
        run(&rig, gpu, params, image);
        double x = log(8 << i), error = rmse(image, converged), y = log(error);
        printf(" %.4f", error);
        sx += x;
        sy += y;
        sxx += x * x;
        sxy += x * y;
    }
    double slope = (6 * sxy - sx * sy) / (6 * sxx - sx * sx);
    printf(", slope %.2f\n", slope);
    assert_true(slope <= -0.45);
    run(&rig, gpu, "blur=0 samples=16", image);
    double unblurred = rmse(image, converged);
    run(&rig, gpu, "samples=16 blur_passes=4", image);
    double blurred = rmse(image, converged);
    run(&rig, gpu, "samples=32 blur_passes=2", image);
    double sampled = rmse(image, converged);
    run(&rig, gpu, "samples=16 blur_passes=2", image);
    printf("16 samples, 2 passes: %.4f; 2 more passes: %.4f; 32 samples instead: %.4f\n",
           rmse(image, converged), blurred, sampled);
    assert_true(rmse(image, converged) < 0.5 * unblurred);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_darker_of_two_radii),
                                       cmocka_unit_test(test_directions),
                                       cmocka_unit_test(test_blocker_table),
                                       cmocka_unit_test(test_against_definition),
                                       cmocka_unit_test(test_open_plane),
                                       cmocka_unit_test(test_convergence),
                                       cmocka_unit_test(test_strips),
                                       cmocka_unit_test(test_near_samples),
                                       cmocka_unit_test(test_encodings_and_sizes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
