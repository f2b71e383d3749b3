/* Ambient occlusion volumes: what of them is drawn, and what is refused before. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"
#include "technique/registry.h"

enum { W = 160, H = 90, PIXELS = W * H };

/* fov_deg, ortho_height 0: the scene's. */
static void scene_rig(struct aob_rig *rig, const char *scene, double fov_deg, double ortho_height, int width,
                      int height, int guard)
{
    const struct aob_scene_info *info = aob_scene_find(scene);
    struct aob_camera camera = aob_scene_view(info, NULL)->camera;
    struct aob_mesh mesh = {0};
    camera.fov_deg = fov_deg > 0 ? fov_deg : camera.fov_deg;
    camera.ortho_height = ortho_height;
    info->build(&mesh);
    aob_rig_init(rig, &mesh, &camera, width, height, guard);
    aob_mesh_finish(&mesh);
}

struct values { /* the technique's own */
    float radius;
    int32_t falloff, sides, cull, divisor;
};

static const struct aob_technique *ao_volumes(void)
{
    const struct aob_technique *const *t = aob_builtin_techniques;
    while (strcmp((*t)->name, "ao_volumes") != 0)
        t++;
    return *t;
}

enum { SHADERS = 16 };

/* The technique with another text in place of its shader of that name. `shaders`: SHADERS. */
static struct aob_technique altered(const char *name, const char *text, struct aob_shader *shaders)
{
    struct aob_technique copy = *ao_volumes();
    int i = 0;
    for (; copy.shaders[i].name; i++) {
        assert_true(i < SHADERS - 1);
        shaders[i] = copy.shaders[i];
        if (strcmp(shaders[i].name, name) == 0)
            shaders[i].text = text;
    }
    shaders[i] = (struct aob_shader){0};
    copy.shaders = shaders;
    return copy;
}

/* Each triangle drawn over the whole image. */
static void draw_everywhere(struct aob_gpu *gpu, const struct aob_rig *rig, const struct values *values,
                            float *ao)
{
    static const char text[] = "vec4 place(int triangle, int vertex)\n{\n"
                               "    vec2 corner = vec2(vertex == 1 || vertex == 2 || vertex == 4,\n"
                               "                       vertex == 2 || vertex == 4 || vertex == 5);\n"
                               "    return aob_clip(vec2(-8.0) + corner * (vec2(aob_size) + 16.0));\n}\n";
    struct aob_shader shaders[SHADERS];
    struct aob_technique everywhere = altered("bounds", text, shaders);
    aob_rig_probe(rig, gpu, &everywhere, values, &(struct aob_options){0}, ao);
}

/* A volume adds nothing outside of its rectangle. */
static void check_rectangles(struct aob_gpu *gpu, const struct aob_rig *rig, const struct values *values)
{
    static float all[PIXELS], some[PIXELS];
    float most = 0;
    draw_everywhere(gpu, rig, values, all);
    aob_rig_probe(rig, gpu, ao_volumes(), values, &(struct aob_options){0}, some);
    for (int i = 0; i < PIXELS; i++)
        most = fmaxf(most, fabsf(all[i] - some[i]));
    assert_true(most <= 1e-6F);
}

static void test_volumes_lie_in_their_rectangles(void **state)
{
    (void)state;
    static const struct {
        const char *scene;
        struct values values;
        double fov_deg, ortho_height;
    } rows[] = {{"cornell", {0.1F, 0, 8, 0, 1}, 0, 0},   {"cornell", {0.5F, 0, 3, 0, 1}, 0, 0},
                {"cornell", {0.5F, 1, 8, 0, 1}, 0, 0},   {"cornell", {0.3F, 0, 8, 0, 4}, 0, 0},
                {"cornell", {0.3F, 0, 8, 0, 1}, 150, 0}, {"cornell", {0.3F, 0, 8, 0, 1}, 0, 2.5},
                {"corner", {5, 0, 8, 0, 1}, 0, 0},       {"plates", {0.4F, 0, 8, 0, 1}, 0, 0}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (size_t r = 0; r < AOB_COUNT(rows); r++) {
        struct aob_rig rig;
        scene_rig(&rig, rows[r].scene, rows[r].fov_deg, rows[r].ortho_height, W, H, 0);
        check_rectangles(gpu, &rig, &rows[r].values);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* A block seen from straight above, where the rectangles of its sides are hardly larger than what they reach. */
static void test_tight_rectangles_suffice(void **state)
{
    (void)state;
    const struct aob_camera above = {.eye = {0, 5, 0}, .ortho_height = 5};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_mesh mesh = {0};
    struct aob_rig rig;
    aob_mesh_add_quad(&mesh, aob_vec(-9, 0, -9), aob_vec(0, 0, 18), aob_vec(18, 0, 0));
    aob_mesh_add_box(&mesh, aob_vec(-0.6, 0, -0.4), aob_vec(0.6, 1, 0.4), 0);
    aob_rig_init(&rig, &mesh, &above, W, H, 0);
    for (int32_t falloff = 0; falloff < 2; falloff++)
        check_rectangles(gpu, &rig, &(struct values){1.5F, falloff, 16, 0, 1});
    aob_rig_finish(&rig);
    aob_mesh_finish(&mesh);
    aob_gpu_close(gpu);
}

/* What culling leaves out adds nothing. The spheres hide half of their triangles. */
static void test_culling_changes_nothing(void **state)
{
    (void)state;
    enum { WIDE = W - 3, HIGH = H - 1 };
    static float all[WIDE * HIGH], some[WIDE * HIGH];
    static const struct {
        const char *scene, *params;
        int guard;
        double fov_deg, ortho_height; /* 0: the scene's */
    } rows[] = {{"cornell", "radius=0.1", 0, 0, 0},
                {"cornell", "radius=0.5 falloff=1", 10, 0, 0},
                {"cornell", "radius=0.5 divisor=4", 0, 0, 0},
                {"cornell", "radius=0.3", 5, 150, 0},
                {"cornell", "radius=0.3", 5, 0, 2.5},
                {"cornell", "radius=0.3 depth_encoding=device24_reversed", 0, 0, 0},
                {"cornell", "radius=0.3 depth_encoding=r16f divisor=2", 0, 0, 0},
                {"corner", "radius=0.5 divisor=2", 10, 0, 0},
                {"corner", "radius=5", 0, 0, 0}, /* volumes about the eye */
                {"plates", "radius=0.1", 0, 0, 0},
                {"spheres", "radius=0.05", 0, 0, 0}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (size_t r = 0; r < AOB_COUNT(rows); r++) {
        struct aob_rig rig;
        char params[80];
        float most = 0;
        scene_rig(&rig, rows[r].scene, rows[r].fov_deg, rows[r].ortho_height, WIDE, HIGH, rows[r].guard);
        snprintf(params, sizeof params, "%s cull=off", rows[r].params);
        aob_rig_run(&rig, gpu, "ao_volumes", params, AOB_FETCH_SAMPLED, all);
        snprintf(params, sizeof params, "%s cull=on", rows[r].params);
        aob_rig_run(&rig, gpu, "ao_volumes", params, AOB_FETCH_STORAGE, some);
        for (int i = 0; i < WIDE * HIGH; i++)
            most = fmaxf(most, fabsf(all[i] - some[i]));
        assert_true(most <= 1e-6F);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Where every fragment adds 2^-16, which float sums hold exactly, the image counts them. */
static double drawn(struct aob_gpu *gpu, const struct aob_rig *rig, int32_t cull)
{
    static float ao[PIXELS];
    struct aob_shader shaders[SHADERS];
    struct aob_technique counter = altered("volume", "void main() { occlusion = 1.0 / 65536.0; }\n", shaders);
    aob_rig_probe(rig, gpu, &counter, &(struct values){0.1F, 0, 8, cull, 1}, &(struct aob_options){0}, ao);
    double sum = 0;
    for (int i = 0; i < PIXELS; i++)
        sum += 65536 * (1 - (double)ao[i]);
    return sum;
}

/* What a refusal would say, against what is drawn: less where boxes along the triangles are smaller, more by a pixel on
 * each side, which counts in a picture as small as this. */
static void test_fragments_are_estimated(void **state)
{
    (void)state;
    static const char *const rows[][2] = {
        {"cornell", "blocks"}, {"atrium", "column"}, {"spheres", "front"}, {"spheres", "top"}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    for (size_t r = 0; r < AOB_COUNT(rows); r++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, rows[r][0], rows[r][1], W, H, 0);
        /* reach of an 8-gon: 1.0539 radii */
        double estimate = aob_geometry_fragments(&rig.geometry, &rig.gbuffer.projection, 0.10539F, 1),
               all = drawn(gpu, &rig, 0), some = drawn(gpu, &rig, 1);
        printf("%s/%s: %.3g fragments drawn, %.2f of the estimate; %.2f of them when culled\n", rows[r][0],
               rows[r][1], all, all / estimate, some / all);
        assert_true(all / estimate > 0.7 && all / estimate < 1.4);
        assert_true(some < all);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

static void expect_refusal(struct aob_gpu *gpu, const struct aob_rig *rig,
                           const struct aob_geometry *geometry, const char *says)
{
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_screen screen;
    struct aob_error error = {{0}};
    const struct values values = {1, 0, 8, 1, 1};
    assert_true(aob_screen_init(&screen, gpu, &rig->gbuffer, &(struct aob_options){0}, &error));
    screen.geometry = geometry;
    assert_false(aob_frame_init(frame, &screen, ao_volumes(), &values, AOB_FETCH_SAMPLED, &error));
    assert_true(frame->unfit);
    assert_contains(error.text, says);
    aob_screen_finish(&screen);
    free(frame);
}

/* A capture has no triangles; a million of them as large as the image are too many. */
static void test_what_does_not_fit_is_refused(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    struct aob_mesh mesh = {0};
    aob_rig_scene(&rig, "corner", NULL, W, H, 0);
    expect_refusal(gpu, &rig, NULL, "a capture has none");
    for (int i = 0; i < 500000; i++)
        aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 0), aob_vec(0, 0, 40), aob_vec(40, 0, 0));
    struct aob_geometry large;
    aob_geometry_init(&large, &mesh, &rig.camera);
    assert_near(aob_geometry_fragments(&large, &rig.gbuffer.projection, 1, 1), 1e6 * PIXELS, 1);
    assert_near(aob_geometry_fragments(&large, &rig.gbuffer.projection, 1, 2), 1e6 * PIXELS / 4, 1);
    expect_refusal(gpu, &rig, &large, "1000000 triangles with a reach of 1.05");
    aob_geometry_finish(&large);
    aob_mesh_finish(&mesh);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* The radius is a uniform, but the estimate of the fragments stands on the reach that the frame was made with. */
static void test_another_reach_needs_another_frame(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    struct aob_screen screen;
    struct aob_error error = {{0}};
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct values values = {.radius = 0.5F, .sides = 8, .divisor = 1};
    aob_rig_scene(&rig, "corner", NULL, W, H, 0);
    struct aob_geometry geometry = rig.geometry;
    assert_true(aob_geometry_upload(&geometry, gpu, &error));
    assert_true(aob_screen_init(&screen, gpu, &rig.gbuffer, &(struct aob_options){0}, &error));
    screen.geometry = &geometry;
    assert_true(aob_frame_init(frame, &screen, ao_volumes(), &values, AOB_FETCH_SAMPLED, &error));
    assert_true(aob_frame_set(frame, 1, &values, &error));
    values.radius = 500;
    assert_false(aob_frame_set(frame, 1, &values, &error));
    assert_contains(error.text, "ao_volumes: these values lay out other passes");
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    aob_gpu_texture_destroy(gpu, geometry.texture);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
    free(frame);
}

/* An error says which of the two texts it is in. */
static void test_a_vertex_text_with_an_error_is_named(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    struct aob_rig rig;
    struct aob_screen screen;
    struct aob_error error = {{0}};
    struct aob_shader shaders[SHADERS];
    struct aob_technique broken =
        altered("bounds", "vec4 place(int triangle, int vertex) { return nothing; }\n", shaders);
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    const struct values values = {.radius = 0.5F, .sides = 8, .divisor = 1};
    aob_rig_scene(&rig, "corner", NULL, W, H, 0);
    assert_true(aob_screen_init(&screen, gpu, &rig.gbuffer, &(struct aob_options){0}, &error));
    screen.geometry = &rig.geometry;
    assert_false(aob_frame_init(frame, &screen, &broken, &values, AOB_FETCH_SAMPLED, &error));
    assert_contains(error.text, "pass 'volumes', shaders 'bounds' (vertex) and 'volume' (fragment)");
    assert_contains(error.text, "vertex shader, line 1: 'nothing' : undeclared identifier");
    aob_screen_finish(&screen);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
    free(frame);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_volumes_lie_in_their_rectangles),
                                       cmocka_unit_test(test_tight_rectangles_suffice),
                                       cmocka_unit_test(test_culling_changes_nothing),
                                       cmocka_unit_test(test_fragments_are_estimated),
                                       cmocka_unit_test(test_what_does_not_fit_is_refused),
                                       cmocka_unit_test(test_another_reach_needs_another_frame),
                                       cmocka_unit_test(test_a_vertex_text_with_an_error_is_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
