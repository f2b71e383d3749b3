/* What thrift leaves out: nothing that shows, and enough to be worth it. */
#include "reference/oracle.h"
#include "thrifty.h"

static const char *const techniques[] = {"gtao", "hbao", "ray_march", "alchemy"};

/* A room, rocks and bushes, full and half size, with normals that lean. */
static void test_nothing_shows(void **state)
{
    static const char *const views[][2] = {
        {"atrium", "aisle"}, {"thicket", "edge"}, {"scattered_rocks", "down"}};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    double worst = 0;
    (void)state;
    for (size_t v = 0; v < AOB_COUNT(views); v++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, views[v][0], views[v][1], W, H, 0);
        for (size_t t = 0; t < AOB_COUNT(techniques); t++)
            worst = fmax(worst, difference(&rig, gpu, techniques[t], "radius=0.7"));
        worst = fmax(worst, difference(&rig, gpu, "gtao", "radius=0.25 normal_encoding=rgb10"));
        worst = fmax(worst, difference(&rig, gpu, "gtao", "radius=0.5 divisor=2"));
        worst = fmax(worst, difference(&rig, gpu, "gtao", "radius=0.5 divisor=2 depth_divisor=2"));
        aob_rig_finish(&rig);
    }
    print_message("           a pixel differs by %.5f at most\n", worst);
    assert_true(worst <= 1 / 255.0);
    aob_gpu_close(gpu);
}

/* What rises hardly, everywhere about, and small steps before a long lens: with weights and strengths that make most of it. */
static void test_gentle_slopes(void **state)
{
    static const struct {
        const char *technique, *params;
    } rows[] = {{"gtao", "radius=1"},
                {"gtao", "radius=1 weighting=uniform"},
                {"hbao", "radius=1 intensity=10"},
                {"ray_march", "radius=1 attenuation=0"},
                {"alchemy", "radius=1 intensity=5 contrast=3"}};
    const struct aob_camera wide = {.eye = {0, 2.5, 4}, .target = {0, 0, 0}, .fov_deg = 60},
                            tele = {.eye = {0.3, 1.5, 0.1}, .target = {0, 0, 0}, .fov_deg = 10};
    static const double slopes[] = {0.015, 0.045}, steps[] = {2e-4, 0.95e-3};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    double worst = 0;
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(slopes) + AOB_COUNT(steps); k++) {
        struct aob_rig rig;
        if (k < AOB_COUNT(slopes))
            ramp_rig(&rig, slopes[k], 0, &wide);
        else
            ramp_rig(&rig, 0, steps[k - AOB_COUNT(slopes)], &tele);
        for (size_t i = 0; i < AOB_COUNT(rows); i++)
            worst = fmax(worst, difference(&rig, gpu, rows[i].technique, rows[i].params));
        aob_rig_finish(&rig);
    }
    print_message("           a pixel differs by %.5f at most\n", worst);
    assert_true(worst <= 1 / 255.0);
    aob_gpu_close(gpu);
}

/* Radii of about a pixel, where the depth is divided and where a ball is seen off the axis. */
static void test_small_radii(void **state)
{
    static const char *const params[] = {
        "radius=0.03967 weighting=uniform falloff=0.069 slices=4 steps=8 blur=0 depth_divisor=2",
        "radius=0.03967 blur=0", "radius=0.02 blur=0", "radius=0.01 blur=0 divisor=2 depth_divisor=2"};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_camera aside = {
        .eye = {0.7, 0.7, 1.7}, .target = {-0.3, 0.6, -0.6}, .fov_deg = 50, .shift = {1.707, 0.581}};
    struct aob_mesh mesh = {0};
    struct aob_rig rig;
    double worst = 0;
    (void)state;
    aob_rig_scene(&rig, "gallery", "hall", W, H, 0);
    for (size_t i = 0; i < AOB_COUNT(params); i++)
        worst = fmax(worst, difference(&rig, gpu, "gtao", params[i]));
    aob_rig_finish(&rig);
    aob_scene_find("thicket")->build(&mesh);
    aob_rig_init(&rig, &mesh, &aside, W, H, 0);
    aob_mesh_finish(&mesh);
    worst = fmax(worst, difference(&rig, gpu, "gtao", "radius=0.004853"));
    print_message("           a pixel differs by %.5f at most\n", worst);
    assert_true(worst <= 1 / 255.0);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* What is no normal, or another surface's, clears nothing: a technique mends it, and may find an occluder then. */
static void test_hostile_normals(void **state)
{
    static const float scales[] = {0, -1, 0.1f, NAN};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(scales); k++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, "spheres", "top", W, H, 0);
        for (int i = 0; i < 4 * PIXELS; i++)
            rig.gbuffer.normal[i] *= i % 4 < 3 ? scales[k] : 1;
        assert_true(share_of(&rig, gpu, "gtao", "radius=0.5 thrift=on") == 0);
        aob_rig_finish(&rig);
    }
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
        double share = share_of(&rig, gpu, "gtao", "radius=0.5 thrift=on");
        print_message("           %s, orthographic: %.3f left out\n", backends[b], share);
        assert_true(difference(&rig, gpu, "gtao", "radius=0.5") <= 1 / 255.0);
        assert_true(share > 0.4);
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
}

/* The bars: three fifths of a plain, 15 % of the hall; and without the option nothing. */
static void test_shares(void **state)
{
    static const struct {
        const char *scene, *view, *params;
        double least, most;
    } rows[] = {{"scattered_rocks", "down", "radius=0.5 thrift=on", 0.6, 1},
                {"scattered_rocks", "down", "radius=1 thrift=on", 0.6, 1},
                {"atrium", "nave", "radius=0.5 thrift=on", 0.15, 1},
                {"atrium", "aisle", "radius=0.5 thrift=on", 0.15, 1},
                {"atrium", "nave", "radius=0.5", 0, 0}};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, rows[i].scene, rows[i].view, 640, 360, 0);
        double share = share_of(&rig, gpu, "gtao", rows[i].params);
        print_message("           %s %s, %s: %.3f left out\n", rows[i].scene, rows[i].view, rows[i].params,
                      share);
        assert_true(share >= rows[i].least && share <= rows[i].most);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

static double tile_at(const struct drawn *drawn, const unsigned char *texels, int x, int y)
{
    const struct aob_gpu_texture *clear = drawn->frame.textures[drawn->frame.graph.clear];
    return texels[(size_t)(y / 8) * (size_t)clear->width + (size_t)(x / 8)] / 255.0;
}

/* Writes 0 where it is told that a surface is clear. */
struct probe_values {
    float radius;
};
static const struct aob_param probe_params[] = {
    AOB_PARAM(struct probe_values, radius, .min = 0, .max = 9, .initial = 1, .doc = ".")};
static const struct aob_shader probe_shaders[] = {
    {"probe", "void main() { v = aob_is_clear(aob_pixel) && !aob_surface_is_sky(aob_pixel) ? 0.0 : 1.0; }\n"},
    {NULL, NULL}};

static bool build_probe(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex v = aob_texture(graph, .name = "v", .format = AOB_R8);
    return aob_pass(graph, .name = "probe", .shader = "probe", .reads = AOB_DEPTH | AOB_CLEARANCE,
                    .out = {{.name = "v", .tex = v}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, v);
}

static struct aob_clearance probe_clearance(const void *values)
{
    (void)values;
    return (struct aob_clearance){.sine = 0.05f};
}

enum { WIDE = 161, HIGH = 91 };

static void check_told(const struct aob_rig *rig, struct aob_gpu *gpu, float radius)
{
    static const struct aob_technique probe = {.name = "probe",
                                               .params = probe_params,
                                               .param_count = 1,
                                               .values_size = sizeof(struct probe_values),
                                               .shaders = probe_shaders,
                                               .clearance = probe_clearance,
                                               .build = build_probe};
    static float pixels[WIDE * HIGH];
    const struct probe_values values = {radius};
    const struct aob_frame_desc desc = {.technique = &probe, .values = &values, .wanted = AOB_WANT_THRIFT};
    struct drawn *drawn = AOB_NEW(struct drawn);
    int clear = 0, surfaces = 0;
    double share;
    assert_true(aob_screen_init(&drawn->screen, gpu, &rig->gbuffer, &(struct aob_options){0}, NULL));
    assert_true(aob_frame_init_desc(&drawn->frame, &drawn->screen, &desc, NULL));
    assert_true(aob_frame_run(&drawn->frame, 1, NULL, NULL));
    assert_true(aob_frame_read(&drawn->frame, AOB_OUT_VISIBILITY, 1, pixels, NULL));
    assert_true(aob_frame_left_out(&drawn->frame, &share, NULL));
    for (int i = 0; i < WIDE * HIGH; i++) {
        struct aob_vec3 p;
        surfaces += aob_rig_position(rig, i % WIDE, i / WIDE, &p);
        clear += pixels[i] == 0;
    }
    print_message("           radius %g: %.4f told, %d of %d pixels\n", (double)radius, share, clear,
                  surfaces);
    /* A pixel at the very limit may be rounded otherwise. */
    assert_near(share, (double)clear / surfaces, 2.0 / surfaces);
    assert_true(share > 0.05 && share < 1);
    drawn_finish(drawn);
}

/* The share that is told is that of the pixels which a shader is told are clear: in a guard band, at an odd size, off the axis, and
 * with a radius that is less than half a pixel far away. */
static void test_told_share(void **state)
{
    const struct aob_camera camera = {
        .eye = {0, 1.2, 3}, .target = {0.4, 0.2, -2}, .fov_deg = 95, .shift = {0.4, -0.2}};
    static const float radii[] = {0.03f, 0.08f, 0.5f};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_mesh mesh = {0};
    struct aob_rig rig;
    (void)state;
    aob_scene_find("scattered_rocks")->build(&mesh);
    aob_rig_init(&rig, &mesh, &camera, WIDE, HIGH, 13);
    aob_mesh_finish(&mesh);
    for (size_t r = 0; r < AOB_COUNT(radii); r++)
        check_told(&rig, gpu, radii[r]);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* In a corner all is known in closed form: what is clear is open, and what lies well outside the radius is clear. */
static void test_corner(void **state)
{
    const double radius = 0.5;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct drawn *drawn = AOB_NEW(struct drawn);
    struct aob_rig rig;
    double least = 1;
    int far = 0, far_clear = 0;
    (void)state;
    aob_rig_scene(&rig, "corner", "front", 320, 180, 0);
    draw_technique(&rig, gpu, "gtao", "radius=0.5 thrift=on", drawn);
    const struct aob_gpu_texture *clear = drawn->frame.textures[drawn->frame.graph.clear];
    unsigned char *texels = aob_alloc((size_t)clear->width * (size_t)clear->height, 1);
    assert_true(aob_gpu_texture_read(gpu, clear, 0, texels, NULL));
    for (int y = 0; y < 180; y++)
        for (int x = 0; x < 320; x++) {
            struct aob_vec3 p;
            if (!aob_rig_position(&rig, x, y, &p))
                continue;
            double d = fmax(p.y, p.z); /* from the other plane */
            bool is_clear = tile_at(drawn, texels, x, y) > 0.5;
            if (is_clear)
                least = fmin(least, d < radius ? aob_oracle_corner(d, radius) : 1);
            far += d > 1.5 * radius;
            far_clear += d > 1.5 * radius && is_clear;
        }
    print_message("           what is clear is open to %.5f; %d of %d far ones are clear\n", least, far_clear,
                  far);
    assert_true(least >= 1 - 1 / 255.0);
    assert_true(far > 1000 && far_clear > 0.8 * far);
    free(texels);
    drawn_finish(drawn);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nothing_shows), cmocka_unit_test(test_gentle_slopes),
        cmocka_unit_test(test_small_radii),   cmocka_unit_test(test_hostile_normals),
        cmocka_unit_test(test_backends),      cmocka_unit_test(test_shares),
        cmocka_unit_test(test_told_share),    cmocka_unit_test(test_corner),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
