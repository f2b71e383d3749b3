#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "reference/oracle.h"
#include "rig.h"

enum { W = 320, H = 180 };

/* Uniform weighting on a 90-degree corner: the share of directions that point towards the wall with a cosine above c is
 * (1 - c)/2, and such a ray is d/c long; W(r) = 1 or 1 - r^2. */
static double uniform_hard(double d, double r)
{
    return d < r ? 1 - 0.5 * (1 - d / r) : 1;
}
static double uniform_attenuated(double d, double r)
{
    return d < r ? 1 - 0.5 * (1 - d / r) * (1 - d / r) : 1;
}

static const struct {
    const char *name, *params;
    double (*truth)(double d, double r);
    double
        bar; /* perspective, 32x16: the text's even directions in the image are not even about the view axis */
} definitions[] = {{"uniform, 1 - r^2 (the text's)", "", uniform_attenuated, 0.032},
                   {"uniform, hard cutoff", "attenuation=0", uniform_hard, 0.042},
                   {"cosine, hard cutoff", "attenuation=0 weighting=cosine", aob_oracle_corner, 0.050}};

static double corner_rmse(struct aob_gpu *gpu, const struct aob_rig *rig, int definition, double radius,
                          const char *samples)
{
    char params[160];
    snprintf(params, sizeof params, "radius=%g blur=0 %s %s", radius, definitions[definition].params,
             samples);
    return aob_rig_corner_rmse(rig, gpu, "hbao", params, definitions[definition].truth, radius);
}

/* Converged it keeps the error of the text's approximation, and falls to it. */
static void test_corner_approaches_its_definition(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    aob_rig_scene(&rig, "corner", "front", W, H, 96);
    for (int i = 0; i < 3; i++)
        for (double radius = 0.5; radius <= 2; radius *= 4) {
            double coarse = corner_rmse(gpu, &rig, i, radius, "directions=4 steps=4");
            double fine = corner_rmse(gpu, &rig, i, radius, "directions=32 steps=16");
            printf("corner/front R=%g, %s: in-band RMSE 4x4 %.4f, 32x16 %.4f\n", radius, definitions[i].name,
                   coarse, fine);
            assert_true(fine < coarse);
            assert_true(fine <= definitions[i].bar);
        }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Without perspective the text's approximations hold exactly: directions in the image are azimuths, and horizons about
 * the view axis are what hides. What is left is the steps. */
static void test_orthographic_corner(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 3, 4}, .target = {0, 0.5, 0}, .ortho_height = 4};
    aob_scene_find("corner")->build(&mesh);
    aob_rig_init(&rig, &mesh, &camera, W, H, 96);
    for (int i = 0; i < 3; i++) {
        double before = 1;
        printf("orthographic corner R=1, %s: in-band RMSE by steps", definitions[i].name);
        for (int steps = 2; steps <= 32; steps *= 2) {
            char samples[40];
            snprintf(samples, sizeof samples, "directions=32 steps=%d", steps);
            double rmse = corner_rmse(gpu, &rig, i, 1, samples);
            printf(" %d %.4f", steps, rmse);
            assert_true(rmse < before);
            before = rmse;
        }
        printf("\n");
        assert_true(before <= 0.02);
    }
    aob_mesh_finish(&mesh);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static double mean_of(struct aob_gpu *gpu, const struct aob_rig *rig, const char *params, double *least)
{
    float *ao = AOB_NEW_ARRAY(float, (size_t)rig->width *(size_t)rig->height);
    int count = rig->width * rig->height;
    double sum = 0;
    *least = 1;
    aob_rig_run(rig, gpu, "hbao", params, AOB_FETCH_STORAGE, ao);
    for (int i = 0; i < count; i++) {
        sum += ao[i];
        *least = fmin(*least, ao[i]);
    }
    free(ao);
    return sum / count;
}

/* Snapped samples lie beside their direction; tangents for each sample remove the false occlusion (equation 6.2.9),
 * whatever is snapped and divided. Unsnapped, a sample mixes a texel's depth with another place. */
static void test_open_planes(void **state)
{
    (void)state;
    static const struct {
        const char *params;
        bool open;
    } rows[] = {{"", true},
                {"tangents=per_direction", false},
                {"snapping=per_direction", true},
                {"snapping=per_direction tangents=per_direction", false},
                {"snapping=off", false},
                {"weighting=cosine attenuation=0", true},
                {"weighting=cosine attenuation=0 tangents=per_direction", false},
                {"divisor=2 depth_divisor=2", true},
                {"depth_divisor=4", true}};
    static const double tilts[] = {0, 30, 60, 75};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    double mean[AOB_COUNT(rows)], least[AOB_COUNT(rows)];
    for (int p = 0; p < 8; p++) {
        struct aob_rig rig;
        aob_rig_plane(
            &rig, &(struct aob_rig_plane){
                      .tilt_deg = tilts[p / 2], .azimuth_deg = p % 2 ? 250 : 15, .width = 160, .height = 90});
        for (size_t r = 0; r < AOB_COUNT(rows); r++) {
            char params[120];
            double minimum, m;
            snprintf(params, sizeof params, "blur=0 radius=1 %s", rows[r].params);
            m = mean_of(gpu, &rig, params, &minimum);
            mean[r] = p ? fmin(mean[r], m) : m;
            least[r] = p ? fmin(least[r], minimum) : minimum;
        }
        aob_rig_finish(&rig);
    }
    for (size_t r = 0; r < AOB_COUNT(rows); r++) {
        printf("open planes, tilt 0..75, '%s': worst mean %.4f, minimum %.4f\n", rows[r].params, mean[r],
               least[r]);
        assert_true(rows[r].open ? mean[r] >= 0.999 && least[r] >= 0.995 : mean[r] < 0.99);
    }
    aob_gpu_close(gpu);
}

static double image_mean(const float *ao)
{
    double sum = 0;
    for (int i = 0; i < W * H; i++)
        sum += ao[i];
    return sum / (W * H);
}

static double image_rmse(const float *a, const float *b)
{
    double sum = 0;
    for (int i = 0; i < W * H; i++)
        sum += pow((double)a[i] - (double)b[i], 2);
    return sqrt(sum / (W * H));
}

/* Each parameter does what its sentence says, on `spheres`. */
static void test_parameters(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float base[W * H], other[W * H];
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=0", AOB_FETCH_SAMPLED, base);
    aob_rig_run(&rig, gpu, "hbao", "blur=0", AOB_FETCH_SAMPLED, other);
    assert_true(image_mean(other) > image_mean(base) + 0.001);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=0 angle_bias=0.5", AOB_FETCH_SAMPLED, other);
    assert_true(image_mean(other) > image_mean(base) + 0.001);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=0 radius=1", AOB_FETCH_SAMPLED, other);
    assert_true(image_mean(other) < image_mean(base) - 0.001);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=0 intensity=0.5", AOB_FETCH_SAMPLED, other);
    for (int i = 0; i < W * H; i++)
        if (base[i] > 0.01)                                    /* not clamped */
            assert_near(other[i], 0.5 + 0.5 * base[i], 0.002); /* half-precision steps */
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=0 min_step=64", AOB_FETCH_SAMPLED, other);
    assert_true(image_mean(other) == 1);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* The early exit: a pixel is open where radius/(steps + 1) covers less than min_step, and untouched elsewhere. It is
 * off by default: the pixels that it would open are occluded. */
static void test_early_exit(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float whole[W * H], cut[W * H];
    size_t exits = 0, darkened = 0;
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 radius=0.15 steps=8", AOB_FETCH_SAMPLED, whole);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 radius=0.15 steps=8 min_step=1", AOB_FETCH_SAMPLED, cut);
    for (int i = 0; i < W * H; i++) {
        double step = 0.15 / (rig.gbuffer.projection.sy * (double)rig.gbuffer.depth[i]) / 9;
        if (fabs(step - 1) < 1e-5)
            continue;
        exits += step < 1;
        darkened += step < 1 && whole[i] < 0.99f;
        assert_true(cut[i] == (step < 1 ? 1 : whole[i]));
    }
    printf("early exit: %zu of %d pixels, %zu of them occluded\n", exits, W * H, darkened);
    assert_true(exits > 500 && exits < W * H - 500 && darkened > 50);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* The taps take the noise of 4x4 samples away; blur_depth keeps depths apart: next to nothing passes the silhouettes of
 * the spheres at 1e-6, and more passes as it grows. */
static void test_blur(void **state)
{
    (void)state;
    static const char *const rows[] = {"blur=0", "blur=9", "blur=9 blur_depth=1e-6", "blur=9 blur_depth=10"};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float converged[W * H], image[W * H];
    double rmse[4];
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "hbao", "directions=64 steps=4 blur=0", AOB_FETCH_SAMPLED, converged);
    for (int i = 0; i < 4; i++) {
        char params[80];
        snprintf(params, sizeof params, "directions=4 steps=4 %s", rows[i]);
        aob_rig_run(&rig, gpu, "hbao", params, AOB_FETCH_SAMPLED, image);
        rmse[i] = image_rmse(image, converged);
        printf("spheres, 4x4 against 64x4, %s: RMSE %.4f\n", rows[i], rmse[i]);
    }
    assert_true(rmse[1] < 0.5 * rmse[0]);
    assert_true(rmse[1] < rmse[2] && rmse[2] < rmse[0]);
    assert_true(rmse[1] < rmse[3]);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Which of the scene's floor (0) and spheres (1..5) a pixel shows. */
static int surface_at(const struct aob_rig *rig, int x, int y)
{
    static const double spheres[5][4] = {{0, 1, 0, 1},
                                         {M_SQRT2, 0.5, 0, 0.5},
                                         {-0.6, 0.25, 0.8, 0.25},
                                         {0.5, 0.125, 1.5, 0.125},
                                         {-1.5, 0.6, 0.6, 0.4}};
    struct aob_vec3 p;
    if (!aob_rig_position(rig, x, y, &p))
        return -1;
    for (int i = 0; i < 5; i++) {
        const double *s = spheres[i];
        if (fabs(hypot(hypot(p.x - s[0], p.y - s[1]), p.z - s[2]) - s[3]) < 0.02 * s[3] && p.y > 1e-5)
            return i + 1;
    }
    return 0;
}

struct edge {
    int own; /* its surface; pixels of the half image around it that show it, and the range of their AO */
    int shared;
    float low, high;
    double gap; /* least distance in depth to those that show another */
};

/* The pixels of the half image are the even pixels of the whole one: what upsampling had around pixel (x, y). */
static struct edge edge_at(const struct aob_rig *rig, const float *half, int x, int y)
{
    struct edge edge = {.own = surface_at(rig, x, y), .low = 1, .gap = INFINITY};
    for (int k = 0; k < 4; k++) {
        int u = (int)fmin(x / 2 + (k & 1), W / 2 - 1) * 2, v = (int)fmin(y / 2 + (k >> 1), H / 2 - 1) * 2;
        float value = half[v * W + u];
        double apart = fabs((double)rig->gbuffer.depth[v * W + u] - (double)rig->gbuffer.depth[y * W + x]);
        if (surface_at(rig, u, v) != edge.own) {
            edge.gap = fmin(edge.gap, apart);
            continue;
        }
        edge.shared++;
        edge.low = fminf(edge.low, value);
        edge.high = fmaxf(edge.high, value);
    }
    return edge;
}

/* At an edge each pixel keeps to the range of its own surface: no value between two depths appears, but for the odd
 * pixel whose tangent plane runs into the other surface (one of 1,412 measured). Where surfaces touch (nearer than
 * 0.3 m in depth) that is less rare. */
static void test_half_size(void **state)
{
    (void)state;
    static const char *const rows[] = {"divisor=2", "divisor=2 depth_divisor=2", "depth_divisor=2"};
    static const double bars[] = {0.015, 0.015, 0.012};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float full[W * H], half[W * H];
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "hbao", "directions=16 blur=0", AOB_FETCH_SAMPLED, full);
    for (size_t r = 0; r < AOB_COUNT(rows); r++) {
        char params[80];
        size_t edges[2] = {0}, phantoms[2] = {0};
        snprintf(params, sizeof params, "directions=16 blur=0 %s", rows[r]);
        aob_rig_run(&rig, gpu, "hbao", params, AOB_FETCH_SAMPLED, half);
        for (int i = 0; i < W * H; i++) {
            struct edge edge = edge_at(&rig, half, i % W, i / W);
            bool apart = edge.gap > 0.3;
            if (edge.own < 0 || edge.shared == 0 || edge.shared == 4)
                continue;
            edges[apart]++;
            phantoms[apart] += half[i] < edge.low - 1e-3f || half[i] > edge.high + 1e-3f;
        }
        printf("spheres, %s against full size: RMSE %.4f; out of their surface's range: %zu of %zu pixels at "
               "edges, %zu of %zu at contacts\n",
               rows[r], image_rmse(full, half), phantoms[1], edges[1], phantoms[0], edges[0]);
        assert_true(image_rmse(full, half) <= bars[r]);
        if (r == 2) /* nothing is upsampled */
            continue;
        assert_true(edges[1] > 1000 && phantoms[1] <= edges[1] / 500);
        assert_true(phantoms[0] <= edges[0] / 25);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_corner_approaches_its_definition),
                                       cmocka_unit_test(test_orthographic_corner),
                                       cmocka_unit_test(test_open_planes),
                                       cmocka_unit_test(test_parameters),
                                       cmocka_unit_test(test_early_exit),
                                       cmocka_unit_test(test_blur),
                                       cmocka_unit_test(test_half_size)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
