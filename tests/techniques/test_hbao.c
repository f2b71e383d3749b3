#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"

enum { W = 320, H = 180 };

/* Uniform weighting, hard cutoff, on a 90-degree corner: towards the wall a cap of (1 - t)/2 of the hemisphere, t = d/R. */
static double uniform_corner(double d, double r)
{
    return d < r ? 0.5 + 0.5 * d / r : 1;
}

static double corner_rmse(struct aob_gpu *gpu, const struct aob_rig *rig, double radius, const char *samples)
{
    char params[160];
    snprintf(params, sizeof params, "radius=%g attenuation=0 blur=0 %s", radius, samples);
    return aob_rig_corner_rmse(rig, gpu, "hbao", params, uniform_corner, radius);
}

/* The text takes directions even in the image as even about the view axis (its own approximation), so converged it
 * keeps an error; it must fall as samples grow, and stay below what the cosine weighting alone would differ (.0425). */
static void test_corner_approaches_its_definition(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    aob_rig_scene(&rig, "corner", "front", W, H, 96);
    for (double radius = 0.5; radius <= 2; radius *= 2) {
        double coarse = corner_rmse(gpu, &rig, radius, "directions=4 steps=4");
        double fine = corner_rmse(gpu, &rig, radius, "directions=32 steps=16");
        printf("hbao on corner/front R=%g against its definition: 4x4 %.4f, 32x16 %.4f\n", radius, coarse,
               fine);
        assert_true(fine < 0.7 * coarse);
        assert_true(fine < 0.0425);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static double mean_of_plane(struct aob_gpu *gpu, const struct aob_rig *rig, const char *params, double *least)
{
    float ao[W * H];
    double sum = 0;
    *least = 1;
    aob_rig_run(rig, gpu, "hbao", params, AOB_FETCH_STORAGE, ao);
    for (int i = 0; i < W * H; i++) {
        sum += ao[i];
        *least = fmin(*least, ao[i]);
    }
    return sum / (W * H);
}

/* A tilted open plane: tangents for each sample remove the false occlusion of snapped taps (equation 6.2.9). */
static void test_open_plane(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (int tilt = 0; tilt <= 60; tilt += 30) {
        struct aob_rig rig;
        struct aob_mesh mesh = {0};
        double t = tilt * M_PI / 180, least, snapped_least;
        struct aob_camera camera = {.eye = {0, 3 * cos(t), 3 * sin(t)}, .fov_deg = 40};
        aob_mesh_add_quad(&mesh, aob_vec(-500, 0, -500), aob_vec(0, 0, 1000), aob_vec(1000, 0, 0));
        aob_rig_init(&rig, &mesh, &camera, W, H, 0);
        double with = mean_of_plane(gpu, &rig, "blur=0 radius=1", &least);
        double without = mean_of_plane(gpu, &rig, "blur=0 radius=1 tangents=per_direction", &snapped_least);
        printf("hbao on a plane tilted %d degrees: per sample mean %.4f min %.4f, per direction mean %.4f "
               "min %.4f\n",
               tilt, with, least, without, snapped_least);
        assert_true(with >= 0.999);
        assert_true(least >= 0.995);
        assert_true(with >= without);
        aob_mesh_finish(&mesh);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* W(r) = 1 - a r^2 lies between 0 and 1: more attenuation never darkens. A bias only brightens. */
static void test_attenuation_and_bias_brighten(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float plain[W * H], attenuated[W * H], biased[W * H];
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=0", AOB_FETCH_SAMPLED, plain);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=1", AOB_FETCH_SAMPLED, attenuated);
    aob_rig_run(&rig, gpu, "hbao", "blur=0 attenuation=0 angle_bias=0.5", AOB_FETCH_SAMPLED, biased);
    double sums[3] = {0};
    for (int i = 0; i < W * H; i++) {
        sums[0] += plain[i];
        sums[1] += attenuated[i];
        sums[2] += biased[i];
    }
    assert_true(sums[1] > sums[0] * 1.001);
    assert_true(sums[2] > sums[0] * 1.001);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_corner_approaches_its_definition),
                                       cmocka_unit_test(test_open_plane),
                                       cmocka_unit_test(test_attenuation_and_bias_brighten)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
