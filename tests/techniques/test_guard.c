#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"

/* The guard band, through the frame of each technique: a view with a band is the middle of a larger view, and without
 * one only pixels that an occluder outside the image could reach are brighter. A wall stands before another outside the
 * left edge of the view. */

enum { W = 48, H = 32, GUARD = 16 };
#define SPAN 2.0 /* height of the view; the wall before ends 4 pixels beside it */

static const char *const settings[][2] = {
    {"none", ""},
    {"gtao", "radius=0.5 blur=5 divisor=2"},
    {"hbao", "radius=0.5 blur=5 min_step=0"},
    {"ray_march", "radius=0.5"},
    {"alchemy", "radius=0.5 blur=5"},
    {"volumetric_obscurance", "radius=0.5 blur=5 divisor=2"},
    {"crytek_ssao", "radius=0.5 size=scene blur=5 range=4 range_default=0.5"},
    {"starcraft2_ssao", "radius=0.5 blur=5 radii=one near_factor=1 full_occlusion=1 no_occlusion=2"},
    {"ao_volumes", "radius=0.5 divisor=1"},
};

static void draw(struct aob_gpu *gpu, size_t which, double span, int width, int height, int guard,
                 float *pixels)
{
    struct aob_rig rig;
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 0, 5}, .ortho_height = span};
    double edge = -SPAN * (W / 2 + 4) / H;
    aob_mesh_add_quad(&mesh, aob_vec(-9, -9, 0), aob_vec(18, 0, 0), aob_vec(0, 18, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-9, -9, 0.25), aob_vec(9 + edge, 0, 0), aob_vec(0, 18, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-9, -9, 0.25), aob_vec(0, 18, 0), aob_vec(9 + edge, 0, 0));
    aob_rig_init(&rig, &mesh, &camera, width, height, guard);
    aob_rig_run(&rig, gpu, settings[which][0], settings[which][1], AOB_FETCH_SAMPLED, pixels);
    aob_mesh_finish(&mesh);
    aob_rig_finish(&rig);
}

/* The noise of a technique follows the pixels of the whole image, so the two are equal to rounding. */
static void test_a_band_is_a_larger_view(void **state)
{
    enum { WIDE = W + 2 * GUARD, TALL = H + 2 * GUARD };
    static float view[W * H], larger[WIDE * TALL];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    for (size_t t = 0; t < AOB_COUNT(settings); t++) {
        draw(gpu, t, SPAN, W, H, GUARD, view);
        draw(gpu, t, SPAN * TALL / H, WIDE, TALL, 0, larger);
        for (int i = 0; i < W * H; i++) {
            float whole = larger[(i / W + GUARD) * WIDE + i % W + GUARD];
            if (fabsf(view[i] - whole) > 0.002f)
                fail_msg("%s, pixel (%d, %d): %.4f, in the larger view %.4f", settings[t][0], i % W, i / W,
                         (double)view[i], (double)whole);
        }
    }
    aob_gpu_close(gpu);
}

/* Without a band the wall before is not known: columns within its reach, 4 pixels off, are darker with one. What draws
 * the scene's triangles knows it anyway. */
static void test_a_band_knows_what_is_outside(void **state)
{
    static float bare[W * H], banded[W * H];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    for (size_t t = 0; t < AOB_COUNT(settings); t++) {
        double near[2] = {0}, middle[2] = {0};
        bool blind = strcmp(settings[t][0], "none") != 0 && strcmp(settings[t][0], "ao_volumes") != 0;
        draw(gpu, t, SPAN, W, H, 0, bare);
        draw(gpu, t, SPAN, W, H, GUARD, banded);
        for (int i = 0; i < W * H; i++) {
            bool rows = i / W >= 12 && i / W < 20; /* away from the upper and the lower edge */
            near[0] += rows && i % W < 2 ? (double)bare[i] / 16 : 0;
            near[1] += rows && i % W < 2 ? (double)banded[i] / 16 : 0;
            middle[0] += rows && i % W >= 16 && i % W < 32 ? (double)bare[i] / 128 : 0;
            middle[1] += rows && i % W >= 16 && i % W < 32 ? (double)banded[i] / 128 : 0;
        }
        if (blind ? near[0] - near[1] < 0.01 : fabs(near[0] - near[1]) > 0.01)
            fail_msg("%s: %.4f at the edge, %.4f with a band", settings[t][0], near[0], near[1]);
        assert_near(middle[0], middle[1], 0.01);
        if (strcmp(settings[t][0], "none") == 0)
            assert_true(near[1] == 1 && middle[1] == 1);
    }
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_band_is_a_larger_view),
                                       cmocka_unit_test(test_a_band_knows_what_is_outside)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
