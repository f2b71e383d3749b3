#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "frame/prelude.h"
#include "rig.h"

/* The prelude's functions, run on a device by techniques made for the purpose. */

enum { W = 128, H = 72 };

struct values {
    int32_t seed, count;
    float scale;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, seed, .min = 0, .max = 1e6, .doc = "."),
    AOB_PARAM(struct values, count, .stage = AOB_CONSTANT, .min = 0, .max = 9, .doc = "."),
    AOB_PARAM(struct values, scale, .min = 0, .max = 9, .doc = "."),
};
static const struct aob_shader shaders[] = {
    {"round_trip", "void main() {\n"
                   "    vec2 q = vec2(aob_pixel) + vec2(0.25, 0.75);\n"
                   "    vec2 back = aob_project(aob_position_at(q, 2.5));\n"
                   "    o = 1.0 - max(abs(back.x - q.x), abs(back.y - q.y));\n}\n"},
    {"random", "void main() { o = aob_random(aob_pixel, 3); }\n"},
    {"values", "void main() { o = (float(COUNT) + param.scale + float(param.seed)) / 100.0; }\n"},
    {"position",
     "void main() { o = aob_is_sky(aob_pixel) ? 0.0 : -aob_position(aob_pixel).y / 10.0 + 0.5; }\n"},
    {"facing", "void main() { o = aob_is_sky(aob_pixel) ? 1.0 :\n"
               "    dot(aob_normal(aob_pixel), aob_view_vector(aob_position(aob_pixel))); }\n"},
    {"border", "void main() { o = aob_view_z(aob_pixel - ivec2(aob_size.x, 0)) > 1e8 ? 1.0 : 0.0; }\n"},
    {"radius", "void main() {\n"
               "    vec3 a = aob_position_at(vec2(40.0), 3.0), b = a + vec3(0.0, 0.5, 0.0);\n"
               "    o = distance(aob_project(a), aob_project(b)) / aob_pixel_radius(3.0, 0.5) / 2.0; }\n"},
    {NULL, NULL}};

static const char *chosen;
static enum aob_border border;

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex out = aob_texture(graph, .name = "o", .format = AOB_R32F);
    return aob_pass(graph, .name = "only", .shader = chosen, .reads = AOB_DEPTH | AOB_NORMAL,
                    .border = border, .out = {{.name = "o", .tex = out}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, out);
}
AOB_TECHNIQUE(prelude, .title = "t", .citation = "c", .params = params, .param_count = 3,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);

static void run(const struct aob_rig *rig, const char *shader, struct values values, float *pixels)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    chosen = shader;
    aob_rig_probe(rig, gpu, &aob_technique_prelude, &values, &(struct aob_options){0}, pixels);
    aob_gpu_close(gpu);
}

static void rig_of(struct aob_rig *rig, double ortho)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {
        .eye = {0, 2, 4}, .target = {0, 0.8, 0}, .fov_deg = 60, .ortho_height = ortho};
    aob_scene_find("spheres")->build(&mesh);
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
}

static void test_project_undoes_position(void **state)
{
    (void)state;
    float pixels[W * H];
    for (int ortho = 0; ortho < 2; ortho++) {
        struct aob_rig rig;
        rig_of(&rig, ortho ? 3 : 0);
        run(&rig, "round_trip", (struct values){0}, pixels);
        for (int i = 0; i < W * H; i++)
            assert_near(pixels[i], 1, 1e-4);
        run(&rig, "radius", (struct values){0}, pixels);
        assert_near(pixels[0], 0.5, 1e-4);
        aob_rig_finish(&rig);
    }
}

static void test_position_and_normal_are_the_surface(void **state)
{
    (void)state;
    float position[W * H], facing[W * H];
    for (int ortho = 0; ortho < 2; ortho++) {
        struct aob_rig rig;
        rig_of(&rig, ortho ? 3 : 0);
        struct aob_frame_axes axes = aob_camera_axes(&rig.camera);
        run(&rig, "position", (struct values){0}, position);
        run(&rig, "facing", (struct values){0}, facing);
        for (int y = 0; y < H; y++)
            for (int x = 0; x < W; x++) {
                struct aob_vec3 world;
                if (!aob_rig_position(&rig, x, y, &world))
                    continue;
                double view_y = aob_vec_dot(aob_vec_sub(world, rig.camera.eye), axes.up);
                assert_near(position[y * W + x], -view_y / 10 + 0.5, 1e-4);
                assert_true(facing[y * W + x] > 0);
            }
        aob_rig_finish(&rig);
    }
}

static void test_random_is_uniform_and_seeded(void **state)
{
    (void)state;
    float a[W * H], b[W * H];
    struct aob_rig rig;
    rig_of(&rig, 0);
    run(&rig, "random", (struct values){.seed = 0}, a);
    double sum = 0, square = 0, product = 0;
    size_t below[10] = {0};
    for (int i = 0; i < W * H; i++) {
        assert_true(a[i] >= 0 && a[i] < 1);
        sum += a[i];
        square += (double)a[i] * a[i];
        product += i ? (a[i] - 0.5) * (a[i - 1] - 0.5) : 0;
        below[(int)(a[i] * 10)]++;
    }
    assert_near(sum / (W * H), 0.5, 0.012); /* four standard errors */
    assert_near(square / (W * H), 1 / 3.0, 0.013);
    assert_near(product / (W * H) * 12, 0, 0.045);
    for (int k = 0; k < 10; k++)
        assert_in_range(below[k], W * H / 10 - 115, W * H / 10 + 115);
    for (int seed = 1; seed <= 65536; seed *= 256) {
        size_t same = 0;
        run(&rig, "random", (struct values){.seed = seed}, b);
        for (int i = 0; i < W * H; i++)
            same += a[i] == b[i];
        assert_true(same < 20);
    }
    aob_rig_finish(&rig);
}

static void test_values_arrive(void **state)
{
    (void)state;
    float pixels[W * H];
    struct aob_rig rig;
    rig_of(&rig, 0);
    run(&rig, "values", (struct values){.seed = 12, .count = 5, .scale = 2.5f}, pixels);
    assert_near(pixels[17], 0.195, 1e-6);
    border = AOB_FAR;
    run(&rig, "border", (struct values){0}, pixels);
    assert_true(pixels[W * H - 1] == 1);
    border = AOB_CLAMP;
    run(&rig, "border", (struct values){0}, pixels);
    assert_true(pixels[W * H - 1] == 0);
    aob_rig_finish(&rig);
}

/* Each number has one meaning; what may be a storage image fits the 16 image units that the drivers here have (the
 * standard asks for 8). */
static void test_bindings_are_apart(void **state)
{
    (void)state;
    static const enum aob_binding single[] = {AOB_BINDING_UNIFORMS,  AOB_BINDING_DEPTH,    AOB_BINDING_NORMAL,
                                              AOB_BINDING_OWN_DEPTH, AOB_BINDING_VELOCITY, AOB_BINDING_ALBEDO,
                                              AOB_BINDING_SHINE,     AOB_BINDING_TRIANGLES};
    uint32_t used = ((1u << AOB_MAX_IN) - 1) << AOB_BINDING_FIRST_INPUT;
    for (size_t i = 0; i < AOB_COUNT(single); i++) {
        assert_true((int)single[i] <= (int)AOB_GPU_MAX_BINDING);
        assert_false(used >> single[i] & 1);
        used |= 1u << single[i];
    }
    assert_int_equal(used, (1u << AOB_BINDING_COUNT) - 1);
    assert_true(AOB_BINDING_IMAGE_COUNT <= 16);
    assert_true(AOB_BINDING_FIRST_INPUT + AOB_MAX_IN <= AOB_BINDING_IMAGE_COUNT);
    assert_true(AOB_BINDING_VELOCITY < AOB_BINDING_IMAGE_COUNT &&
                AOB_BINDING_ALBEDO < AOB_BINDING_IMAGE_COUNT && AOB_BINDING_SHINE < AOB_BINDING_IMAGE_COUNT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_project_undoes_position),
                                       cmocka_unit_test(test_position_and_normal_are_the_surface),
                                       cmocka_unit_test(test_random_is_uniform_and_seeded),
                                       cmocka_unit_test(test_values_arrive),
                                       cmocka_unit_test(test_bindings_are_apart)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
