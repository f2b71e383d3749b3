/* What thrift must not leave out of techniques that look at all that is drawn in front: G-buffers that hold what is none, and radii of
 * a few pixels. */
#include "ways.h"

/* Radii of a few pixels and less than one, beside the axis of a wide view. */
static void test_small_radii(void **state)
{
    static const char *const more[] = {"radius=0.03967", "radius=0.004853", "radius=0.08", "radius=0.02"};
    const struct aob_camera aside = {
        .eye = {0.7, 0.7, 1.7}, .target = {-0.3, 0.6, -0.6}, .fov_deg = 50, .shift = {1.707, 0.581}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_mesh mesh = {0};
    struct aob_rig rigs[2];
    double worst = 0;
    (void)state;
    aob_rig_scene(&rigs[0], "gallery", "hall", W, H, 0);
    aob_scene_find("scattered_rocks")->build(&mesh);
    aob_rig_init(&rigs[1], &mesh, &aside, W, H, 0);
    aob_mesh_finish(&mesh);
    for (size_t i = 0; i < AOB_COUNT(more); i++)
        worst = fmax(worst, worst_of(&rigs[i % 2], gpu, i % 2 ? FEW : FEW + 2, more[i]));
    check_worst(worst);
    aob_rig_finish(&rigs[0]);
    aob_rig_finish(&rigs[1]);
    aob_gpu_close(gpu);
}

/* A wall, and quads of less than a pixel before every other pixel of it, at scattered depths of 2 to 5. */
static void specks_rig(struct aob_rig *rig)
{
    enum { ACROSS = 64, DOWN = 36 };
    const struct aob_camera camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_deg = 90};
    const double pixel = 2.0 / DOWN;
    unsigned long long state = 77;
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-300, -300, -6), aob_vec(600, 0, 0), aob_vec(0, 600, 0));
    for (int y = 0; y < DOWN; y++)
        for (int x = (y + 1) % 2; x < ACROSS; x += 2) {
            state = state * 6364136223846793005ull + 1442695040888963407ull;
            unsigned long long mixed = (state ^ state >> 33) * 0xff51afd7ed558ccdull;
            double z = 2 + 3 * (double)((mixed ^ mixed >> 33) >> 11) / 0x1p53, half = pixel * z * 0.45;
            double right = (x + 0.5 - ACROSS / 2.0) * pixel * z, up = (DOWN / 2.0 - y - 0.5) * pixel * z;
            aob_mesh_add_quad(&mesh, aob_vec(right - half, up - half, -z), aob_vec(2 * half, 0, 0),
                              aob_vec(0, 2 * half, 0));
        }
    aob_rig_init(rig, &mesh, &camera, ACROSS, DOWN, 0);
    aob_mesh_finish(&mesh);
}

/* Samples that are points in space look the farther away the nearer they are to the eye. */
static void test_specks(void **state)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    (void)state;
    specks_rig(&rig);
    check_worst(difference(&rig, gpu, "crytek_ssao",
                           "blur=0 hemisphere=on radius=0.1398949 range=1000 range_default=0 "
                           "amplification=off samples=8 seed=36"));
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* On a disc of a pixel all lines may stand where the sphere is thin: a chequer of pixels that rises by less than the technique says. */
static void test_least_pixels(void **state)
{
    const struct aob_camera camera = {.eye = {0, 0, 5}, .target = {0, 0, 0}, .fov_deg = 60};
    const double pixel = 2 * tan(M_PI / 6) / 96 * 5;
    static const double radii[] = {1.0003, 1.4145, 2.2365};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    double worst = 0;
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(radii); i++) {
        struct aob_mesh mesh = {0};
        struct aob_rig rig;
        char params[96];
        double radius = radii[i] * pixel;
        aob_mesh_add_quad(&mesh, aob_vec(-20, -20, 0), aob_vec(40, 0, 0), aob_vec(0, 40, 0));
        for (int y = -48; y < 48; y += 2)
            for (int x = -80; x < 80; x += 2)
                aob_mesh_add_quad(&mesh, aob_vec(x * pixel, y * pixel, 3.9e-4 * radius), aob_vec(pixel, 0, 0),
                                  aob_vec(0, pixel, 0));
        aob_rig_init(&rig, &mesh, &camera, 160, 96, 0);
        aob_mesh_finish(&mesh);
        snprintf(params, sizeof params, "blur=0 radius=%g resolutions=one divisor=1", radius);
        worst = fmax(worst, difference(&rig, gpu, "volumetric_obscurance", params));
        aob_rig_finish(&rig);
    }
    check_worst(worst);
    aob_gpu_close(gpu);
}

/* Where the depth is divided a sample reads a texel whose pixel lies beyond the ball: a screen in front of half a wall. */
static void test_divided_places(void **state)
{
    static const struct way dark[] = {
        {"starcraft2_ssao", "depth_divisor=4 no_occlusion=6 small_no_occlusion=6 samples=64"},
        {"crytek_ssao", "hemisphere=on depth_divisor=4 range=1000 range_default=0 amplification=off"},
        {"volumetric_obscurance", "divisor=4 resolutions=one"}};
    const struct aob_camera camera = {
        .eye = {0, 0, 6}, .target = {0, 0, 0}, .fov_deg = 60, .ortho_height = 9};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_mesh mesh = {0};
    struct aob_rig rig;
    double worst = 0;
    (void)state;
    aob_mesh_add_quad(&mesh, aob_vec(-20, -20, 0), aob_vec(40, 0, 0), aob_vec(0, 40, 0));
    aob_mesh_add_quad(&mesh, aob_vec(0.8, -2, 0.5), aob_vec(3.2, 0, 0), aob_vec(0, 4, 0));
    aob_rig_init(&rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
    for (size_t i = 0; i < AOB_COUNT(dark); i++) {
        char params[160];
        snprintf(params, sizeof params, "blur=0 radius=0.77 %s", dark[i].params);
        worst = fmax(worst, difference(&rig, gpu, dark[i].technique, params));
    }
    check_worst(worst);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* A floor that is seen at 2 and 4 degrees: a small step comes in front by much, along the view axis. */
static void test_grazing_steps(void **state)
{
    static const double angles[] = {2, 4}, steps[] = {4.4e-4, 2.2e-4};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    double worst = 0;
    (void)state;
    for (size_t i = 0; i < 4; i++) {
        double angle = angles[i / 2] * M_PI / 180;
        const struct aob_camera camera = {
            .eye = {0.3, 4 * sin(angle), 4 * cos(angle)}, .target = {0, 0, 0}, .fov_deg = 10};
        struct aob_rig rig;
        ramp_rig(&rig, 0, steps[i % 2], &camera);
        worst = fmax(worst, difference(&rig, gpu, "volumetric_obscurance",
                                       "blur=0 radius=1 resolutions=one divisor=1"));
        aob_rig_finish(&rig);
    }
    check_worst(worst);
    aob_gpu_close(gpu);
}

/* A plane whose G-buffer holds normals that lean from it by a twentieth, but in the first pixel of each tile: it rises before those. */
static void test_leaning_normals(void **state)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    (void)state;
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    for (int i = 0; i < PIXELS; i++)
        if (i % W % 8 || i / W % 8) {
            rig.gbuffer.normal[4 * i] = 0.05f;
            rig.gbuffer.normal[4 * i + 1] = 0;
            rig.gbuffer.normal[4 * i + 2] = sqrtf(1 - 0.05f * 0.05f);
        }
    check_worst(worst_of(&rig, gpu, FEW, "radius=0.4"));
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* A depth that is none is nearer than all else to these techniques, and what is no normal is mended. */
static void test_hostile_gbuffers(void **state)
{
    static const float depths[] = {0, -1}, scales[] = {0, 0.1f};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    double worst = 0;
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(depths); k++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, "scattered_rocks", "down", W, H, 0);
        for (int i = 0; i < PIXELS; i += 1777)
            rig.gbuffer.depth[i] = depths[k];
        worst = fmax(worst, worst_of(&rig, gpu, FEW, "radius=0.5"));
        for (int i = 0; i < 4 * PIXELS; i++)
            rig.gbuffer.normal[i] *= i % 4 < 3 ? scales[k] : 1;
        for (int i = 0; i < FEW; i++)
            assert_true(share_with(&rig, gpu, &ways[i], "radius=0.5") == 0);
        aob_rig_finish(&rig);
    }
    check_worst(worst);
    aob_gpu_close(gpu);
}

/* A floor that rises towards an orthographic eye which lies on its far side along the normal, and perhaps a small quad 1.5 in front
 * that covers the first tile of a group of 4 x 4 but for `rows_left` of its rows. */
static void steep_rig(struct aob_rig *rig, bool quad, int rows_left)
{
    const struct aob_camera camera = {
        .eye = {0, 0, 3}, .target = {0, 0, 0}, .fov_deg = 60, .ortho_height = 20};
    struct aob_mesh mesh = {0};
    double low = rows_left ? 8.5 : 8.34;
    aob_mesh_add_quad(&mesh, aob_vec(-30, -30, 35), aob_vec(60, 0, 0), aob_vec(0, 60, -60));
    if (quad)
        aob_mesh_add_quad(&mesh, aob_vec(-3.32, low, -2), aob_vec(1.6, 0, 0), aob_vec(0, 10.1 - low, 0));
    aob_rig_init(rig, &mesh, &camera, 160, 96, 0);
    aob_mesh_finish(&mesh);
}

/* The normals of that quad become 0, and the first pixel of its tile sky. */
static void blank_quad(struct aob_rig *rig)
{
    int blank = 0;
    rig->gbuffer.depth[64] = AOB_GBUFFER_SKY;
    for (int i = 0; i < rig->width * rig->height; i++) {
        float *n = &rig->gbuffer.normal[4 * i];
        if (fabs((double)rig->gbuffer.depth[i] - 5) < 1e-3 && (double)n[2] > 0.999) {
            n[0] = n[1] = n[2] = 0;
            blank++;
        }
    }
    assert_true(blank >= 40 && blank < 64);
}

/* Without perspective the eye is at no one height along a normal, and no more is what has no normal. */
static void test_hostile_orthographic(void **state)
{
    static const struct way dark[] = {
        {"volumetric_obscurance", "blur=0 radius=1"},
        {"starcraft2_ssao", "blur=0 radius=1 no_occlusion=50 small_no_occlusion=50"},
        {"crytek_ssao", "blur=0 radius=1 hemisphere=on range=1000 amplification=off range_default=0"},
        {"gtao", "blur=0 radius=3"}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    double worst = 0;
    (void)state;
    for (int k = 0; k < 4; k++) {
        struct aob_rig rig;
        steep_rig(&rig, k >= 2, k == 2);
        if (k >= 2)
            blank_quad(&rig);
        else
            rig.gbuffer.depth[20 * rig.width + 80] = k ? NAN : 0;
        for (size_t i = 0; i < AOB_COUNT(dark); i++) {
            double found = difference(&rig, gpu, dark[i].technique, dark[i].params);
            if (found > 1 / 255.0)
                print_message("           case %d, %s: %.5f\n", k, dark[i].technique, found);
            worst = fmax(worst, found);
        }
        aob_rig_finish(&rig);
    }
    check_worst(worst);
    aob_gpu_close(gpu);
}

/* The other backends, and an orthographic view. */
static void test_backends(void **state)
{
    static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};
    struct aob_rig rig;
    struct aob_camera camera = aob_scene_view(aob_scene_find("corner"), "front")->camera;
    struct aob_mesh mesh = {0};
    (void)state;
    camera.ortho_height = 4;
    aob_scene_find("corner")->build(&mesh);
    aob_rig_init(&rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        check_worst(worst_of(&rig, gpu, FEW, "radius=0.6"));
        for (int i = 0; i < FEW; i++) {
            double share = share_with(&rig, gpu, &ways[i], "radius=0.6");
            print_message("           %s, %s, orthographic: %.3f left out\n", backends[b], ways[i].technique,
                          share);
            assert_true(share > 0.05);
        }
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_small_radii),      cmocka_unit_test(test_specks),
        cmocka_unit_test(test_least_pixels),     cmocka_unit_test(test_divided_places),
        cmocka_unit_test(test_grazing_steps),    cmocka_unit_test(test_leaning_normals),
        cmocka_unit_test(test_hostile_gbuffers), cmocka_unit_test(test_hostile_orthographic),
        cmocka_unit_test(test_backends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
