#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"

enum { W = 160, H = 90 };

static const double radius = 0.5, bias = 1e-4, epsilon = 1e-4;

static struct aob_vec3 position_at(const struct aob_rig *rig, int x, int y)
{
    const struct aob_projection *p = &rig->gbuffer.projection;
    bool inside = x >= 0 && y >= 0 && x < W && y < H;
    double z = inside ? (double)rig->gbuffer.depth[y * W + x] : 1e9; /* nothing there */
    return aob_vec((x + 0.5 - p->cx) * p->sx * z, -(y + 0.5 - p->cy) * p->sy * z, -z);
}

/* Equation 10 by another rule: a polar grid of equal areas in double precision, on the same depth buffer. */
static double by_quadrature(const struct aob_rig *rig, int x, int y)
{
    enum { RINGS = 48, SPOKES = 96 };
    const float *normal = &rig->gbuffer.normal[4 * (y * W + x)];
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
    aob_rig_run(&rig, gpu, "alchemy", "radius=0.5 samples=1024 blur=0", AOB_FETCH_SAMPLED, ao);
    size_t occluded = 0;
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            double truth = by_quadrature(&rig, x, y), e = ao[y * W + x] - truth;
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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_against_quadrature),
                                       cmocka_unit_test(test_intensity_and_contrast),
                                       cmocka_unit_test(test_open_plane)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
