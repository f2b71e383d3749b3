/* What thrift leaves out of techniques that look at all that is drawn in front of a surface: nothing that shows. */
#include "technique/clearance.h"
#include "ways.h"

/* A room, rocks and bushes. */
static void test_nothing_shows(void **state)
{
    static const char *const views[][2] = {
        {"atrium", "nave"}, {"thicket", "edge"}, {"scattered_rocks", "down"}};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    double worst = 0;
    (void)state;
    for (size_t v = 0; v < AOB_COUNT(views); v++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, views[v][0], views[v][1], W, H, 0);
        worst = fmax(worst, worst_of(&rig, gpu, v == 0 ? ALL : FEW,
                                     v == 1 ? "radius=0.25 normal_encoding=rgb10" : "radius=0.7"));
        aob_rig_finish(&rig);
    }
    check_worst(worst);
    aob_gpu_close(gpu);
}

/* What rises hardly, and small steps, before a wide lens and a long one. */
static void test_gentle_slopes(void **state)
{
    const struct aob_camera wide = {.eye = {0, 2.5, 4}, .target = {0, 0, 0}, .fov_deg = 60},
                            tele = {.eye = {0.3, 1.5, 0.1}, .target = {0, 0, 0}, .fov_deg = 10};
    static const double slopes[] = {1e-5, 4e-4, 4e-3, 0.03}, steps[] = {3e-5, 3e-4, 2e-3, 0.012};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    double worst = 0;
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(slopes) + AOB_COUNT(steps); k++) {
        struct aob_rig rig;
        bool steep = k < AOB_COUNT(slopes);
        ramp_rig(&rig, steep ? slopes[k] : 0, steep ? 0 : steps[k - AOB_COUNT(slopes)],
                 k % 2 ? &tele : &wide);
        worst = fmax(worst, worst_of(&rig, gpu, FEW, "radius=0.5"));
        aob_rig_finish(&rig);
    }
    check_worst(worst);
    aob_gpu_close(gpu);
}

/* A wall, and a quad in front of it, which without perspective covers whole tiles: no tile holds surfaces of both then. */
static void halo_rig(struct aob_rig *rig, double gap, bool perspective)
{
    const struct aob_camera camera = {
        .eye = {0, 0, 6}, .target = {0, 0, 0}, .fov_deg = 60, .ortho_height = perspective ? 0 : 9};
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-20, -20, 0), aob_vec(40, 0, 0), aob_vec(0, 40, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-0.8, -0.3, gap), aob_vec(1.6, 0, 0), aob_vec(0, 0.8, 0));
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
}

/* What stands in front of a far wall darkens the wall about it: that stays, and the rest is left out. StarCraft II's ends with
 * no_occlusion before a sample. */
static void test_halos(void **state)
{
    static const struct way dark[] = {
        {"volumetric_obscurance", "radius=0.7 blur=0"},
        {"starcraft2_ssao", "radius=0.7 blur=0 no_occlusion=6 small_no_occlusion=6"},
        {"crytek_ssao", "radius=0.7 blur=0 hemisphere=on amplification=off range=1000"}};
    static const double gaps[] = {0.4, 3, 3};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(gaps); k++) {
        struct aob_rig rig;
        halo_rig(&rig, gaps[k], k < 2);
        for (size_t i = 0; i < AOB_COUNT(dark); i++) {
            float *images[2];
            int darkened = 0;
            double worst = 0;
            draw_both(&rig, gpu, dark[i].technique, dark[i].params, images);
            for (int p = 0; p < PIXELS; p++) {
                darkened += images[0][p] < 0.9f;
                worst = fmax(worst, fabs((double)images[1][p] - (double)images[0][p]));
            }
            double share = share_with(&rig, gpu, &dark[i], "");
            print_message("           %s, %g in front: %d pixels are dark, %.5f, %.3f left out\n",
                          dark[i].technique, gaps[k], darkened, worst, share);
            assert_true(darkened > 50 && worst <= 1 / 255.0 && share > 0.05);
            free(images[0]);
            free(images[1]);
        }
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Planes that fill the image: outside it reads of one technique find its edge, which bends them. */
static void test_edges(void **state)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    static const double tilts[] = {0, 30, 45, 75};
    double worst = 0;
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(tilts); i++) {
        struct aob_rig rig;
        aob_rig_plane(&rig, &(struct aob_rig_plane){
                                .tilt_deg = tilts[i], .azimuth_deg = 35 + tilts[i], .width = W, .height = H});
        worst = fmax(worst, worst_of(&rig, gpu, FEW + 2, "radius=0.4"));
        aob_rig_finish(&rig);
    }
    check_worst(worst);
    aob_gpu_close(gpu);
}

/* What is left out of a plain and of a hall. */
static void test_shares(void **state)
{
    static const struct {
        const char *scene, *view;
        struct way way;
        double least;
    } rows[] = {{"scattered_rocks", "down", {"volumetric_obscurance", ""}, 0.4},
                {"scattered_rocks", "down", {"starcraft2_ssao", ""}, 0.4},
                {"scattered_rocks", "down", {"crytek_ssao", "hemisphere=on"}, 0.4},
                {"atrium", "nave", {"volumetric_obscurance", ""}, 0.05},
                {"atrium", "nave", {"starcraft2_ssao", ""}, 0.1},
                {"atrium", "nave", {"crytek_ssao", "hemisphere=on"}, 0.05}};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, rows[i].scene, rows[i].view, 640, 360, 0);
        double share = share_with(&rig, gpu, &rows[i].way, "radius=0.5");
        print_message("           %s %s, %s: %.3f left out\n", rows[i].scene, rows[i].view,
                      rows[i].way.technique, share);
        assert_true(share >= rows[i].least && share < 1);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Draws 0 where it is told that a surface is clear, with what nothing in front may exceed. */
struct probe_values {
    float radius;
};
static const struct aob_param probe_params[] = {
    AOB_PARAM(struct probe_values, radius, .min = 0, .max = 9, .initial = 1, .doc = ".")};
static const struct aob_shader probe_shaders[] = {
    {"probe", "void main() { v = aob_is_clear(aob_pixel) && !aob_surface_is_sky(aob_pixel) ? 0.0 : 1.0; }\n"},
    {NULL, NULL}};
static const float probe_rise = 0.002f;

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
    return (struct aob_clearance){
        .occluders = AOB_OCCLUDERS_IN_FRONT, .sine = 1, .rise = probe_rise, .least_pixels = 2};
}

static struct aob_vec3 place_of(const struct aob_rig *rig, int x, int y)
{
    const struct aob_projection *view = &rig->gbuffer.projection;
    double z = (double)rig->gbuffer.depth[y * W + x];
    return aob_vec((x + 0.5 - view->cx) * view->sx * z, -(y + 0.5 - view->cy) * view->sy * z, -z);
}

/* How far what is drawn on the disc about a pixel lies in front of the pixel's plane, along the view axis, in shares of the radius:
 * by every pixel of the disc, and no deeper than the ball. */
static double in_front(const struct aob_rig *rig, int x, int y, double radius)
{
    const float *normal = &rig->gbuffer.normal[4 * (y * W + x)];
    const struct aob_vec3 n = aob_vec((double)normal[0], (double)normal[1], (double)normal[2]),
                          p = place_of(rig, x, y);
    double facing = -aob_vec_dot(n, p) / -p.z, worst = 0;
    int disc = (int)ceil(radius / (rig->gbuffer.projection.sy * -p.z));
    for (int v = y - disc < 0 ? 0 : y - disc; v <= y + disc && v < H; v++)
        for (int u = x - disc < 0 ? 0 : x - disc; u <= x + disc && u < W; u++) {
            struct aob_vec3 s = place_of(rig, u, v);
            if ((u - x) * (u - x) + (v - y) * (v - y) <= disc * disc && -s.z < -p.z + radius)
                worst = fmax(worst, aob_vec_dot(n, aob_vec_sub(s, p)) / (facing * radius));
        }
    return worst;
}

/* What is clear has nothing in front, by a search through all pixels. */
static void test_search(void **state)
{
    static const struct aob_technique probe = {.name = "probe",
                                               .params = probe_params,
                                               .param_count = 1,
                                               .values_size = sizeof(struct probe_values),
                                               .shaders = probe_shaders,
                                               .clearance = probe_clearance,
                                               .build = build_probe};
    static const char *const views[][2] = {
        {"scattered_rocks", "low"}, {"atrium", "nave"}, {"gallery", "hall"}, {"thicket", "edge"}};
    static float pixels[PIXELS];
    static const float radii[] = {0.15f, 0.5f};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    for (size_t k = 0; k < AOB_COUNT(views); k++) {
        const struct probe_values values = {radii[k % 2]};
        struct aob_rig rig;
        double worst = 0;
        int clear = 0;
        aob_rig_scene(&rig, views[k][0], views[k][1], W, H, 0);
        aob_rig_probe(&rig, gpu, &probe, &values, &(struct aob_options){.thrift = 1}, pixels);
        for (int i = 0; i < PIXELS; i++)
            if (pixels[i] == 0 &&
                radii[k % 2] / (rig.gbuffer.projection.sy * (double)rig.gbuffer.depth[i]) > 1) {
                worst = fmax(worst, in_front(&rig, i % W, i / W, (double)values.radius));
                clear++;
            }
        print_message("           %s %s, radius %g: %d are clear, with %.5f in front\n", views[k][0],
                      views[k][1], (double)values.radius, clear, worst);
        assert_true(worst <= (double)probe_rise);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Which values take part. */
static void test_who_takes_part(void **state)
{
    static const struct {
        const char *technique, *params, *because;
    } rows[] = {
        {"volumetric_obscurance", "", NULL},
        {"volumetric_obscurance", "amplification=off", NULL},
        {"volumetric_obscurance", "resolutions=one hemisphere=off", NULL},
        {"volumetric_obscurance", "hemisphere=off", "brighter than open"},
        {"volumetric_obscurance", "resolutions=one hemisphere=off amplification=off", "brighter than open"},
        {"volumetric_obscurance", "samples=4", "fewer than six"},
        {"starcraft2_ssao", "", NULL},
        {"starcraft2_ssao", "epsilon=0", "a millionth of the radius"},
        {"starcraft2_ssao", "radius=2 epsilon=1e-6", "a millionth of the radius"},
        {"starcraft2_ssao", "radius=2 epsilon=1e-5", NULL},
        {"starcraft2_ssao", "small_radius=0.6", "reaches farther"},
        {"starcraft2_ssao", "small_radius=0.6 radii=one", NULL},
        {"crytek_ssao", "hemisphere=on", NULL},
        {"crytek_ssao", "", "hemisphere = on"},
        {"crytek_ssao", "hemisphere=on size=screen", "another radius"},
        {"ao_volumes", "", "triangles"}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct aob_technique *technique = technique_of(rows[i].technique);
        unsigned char values[4 * AOB_MAX_PARAM];
        struct aob_options options;
        aob_rig_params(technique, rows[i].params, values, &options);
        struct aob_clearance way = aob_clearance_of(technique, values);
        assert_int_equal(way.sine > 0, !rows[i].because);
        if (rows[i].because)
            assert_contains(way.because, rows[i].because);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_nothing_shows),  cmocka_unit_test(test_gentle_slopes),
        cmocka_unit_test(test_halos),          cmocka_unit_test(test_shares),
        cmocka_unit_test(test_edges),          cmocka_unit_test(test_search),
        cmocka_unit_test(test_who_takes_part),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
