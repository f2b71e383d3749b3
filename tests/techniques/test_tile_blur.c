#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <aobudget/steps.h>
#include "base/memory.h"
#include "rig.h"

/* The shared mean over a 4x4 tile, fed with patterns by a technique of the test's own. */

enum { N = 48 };

struct values {
    float blur_tolerance;
    int32_t pattern, turn;
};

enum { CONSTANT, TILE, NOISE, DEPTH };

static const struct aob_param params[] = {
    AOB_PARAM(struct values, blur_tolerance, .min = 0, .max = 1, .doc = "As of the step."),
    AOB_PARAM(struct values, pattern, .stage = AOB_CONSTANT, .max = 3, .doc = "What is blurred."),
    AOB_PARAM(struct values, turn, .stage = AOB_CONSTANT, .max = 3,
              .doc = "0 as it is, 1 mirrored left to right, 2 top to bottom, 3 transposed."),
};

static const char pattern_text[] = "void main()\n{\n"
                                   "    ivec2 p = aob_pixel, last = aob_size - 1;\n"
                                   "    p = TURN == 1 ? ivec2(last.x - p.x, p.y) : p;\n"
                                   "    p = TURN == 2 ? ivec2(p.x, last.y - p.y) : p;\n"
                                   "    p = TURN == 3 ? p.yx : p;\n"
                                   "    raw = PATTERN == 0 ? 0.375 : PATTERN == 1 ? aob_random(p & 3, 0)\n"
                                   "        : PATTERN == 2 ? aob_random(p, 0)\n"
                                   "        : aob_is_sky(p) ? 0.5 : aob_view_z(p) < 2.99 ? 0.0 : 1.0;\n"
                                   "}\n";

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex raw = aob_texture(graph, .name = "raw", .format = AOB_R32F);
    aob_pass(graph, .name = "pattern", .shader = "pattern", .reads = AOB_DEPTH,
             .out = {{.name = "raw", .tex = raw}});
    return aob_output(graph, AOB_OUT_VISIBILITY,
                      aob_step_tile_blur(graph, .tex = raw, .taps = 5, .divisor = 1));
}

static void blur(const struct aob_rig *rig, struct aob_gpu *gpu, int pattern, int turn, float *pixels)
{
    const struct aob_shader shaders[] = {
        {"pattern", pattern_text}, {"tile_blur", aob_rig_text("crytek_ssao", "tile_blur")}, {NULL, NULL}};
    const struct aob_technique technique = {.abi = AOB_ABI,
                                            .size = sizeof technique,
                                            .name = "patterns",
                                            .title = "",
                                            .citation = "",
                                            .params = params,
                                            .param_count = AOB_COUNT(params),
                                            .values_size = sizeof(struct values),
                                            .shaders = shaders,
                                            .build = build};
    const struct values values = {.blur_tolerance = 0.01f, .pattern = pattern, .turn = turn};
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_screen screen;
    struct aob_options options = {0};
    struct aob_error error = {{0}};
    bool ok = aob_screen_init(&screen, gpu, &rig->gbuffer, &options, &error) &&
              aob_frame_init(frame, &screen, &technique, &values, AOB_FETCH_SAMPLED, &error) &&
              aob_frame_run(frame, 1, NULL, &error) &&
              aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, pixels, &error);
    assert_string_equal(error.text, "");
    assert_true(ok);
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    free(frame);
}

/* A wall 3 before the eye, and `step` before its left half (or its top half) another. */
static void two_walls(struct aob_rig *rig, double step, bool top)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 0, 3}, .fov_deg = 60};
    aob_mesh_add_quad(&mesh, aob_vec(-9, -9, 0), aob_vec(18, 0, 0), aob_vec(0, 18, 0));
    if (step > 0 && top)
        aob_mesh_add_quad(&mesh, aob_vec(-9, 0, step), aob_vec(18, 0, 0), aob_vec(0, 9, 0));
    else if (step > 0)
        aob_mesh_add_quad(&mesh, aob_vec(-9, -9, step), aob_vec(9, 0, 0), aob_vec(0, 18, 0));
    aob_rig_init(rig, &mesh, &camera, N, N, 0);
    aob_mesh_finish(&mesh);
}

static void test_keeps_constants(void **state)
{
    (void)state;
    static const char *const scenes[] = {"spheres", "corner", "cornell"};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float out[N * N];
    for (size_t s = 0; s < AOB_COUNT(scenes); s++) {
        struct aob_rig rig;
        aob_rig_scene(&rig, scenes[s], NULL, N, N, 0);
        blur(&rig, gpu, CONSTANT, 0, out);
        for (int i = 0; i < N * N; i++)
            assert_near(out[i], 0.375, 1e-6);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Noise that repeats every four pixels is gone, and what is left is the tile's mean: each place weighs the same. */
static void test_removes_the_tile(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float out[N * N], least = 1, most = 0;
    two_walls(&rig, 0, false);
    blur(&rig, gpu, TILE, 0, out);
    for (int y = 2; y < N - 2; y++)
        for (int x = 2; x < N - 2; x++) {
            least = fminf(least, out[y * N + x]);
            most = fmaxf(most, out[y * N + x]);
        }
    printf("tile blur of a tile of random values: %.5f to %.5f\n", (double)least, (double)most);
    assert_true(most - least <= 0.0005f); /* one step of half precision */
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Weights written out: the product of 1/8 1/4 1/4 1/4 1/8. */
static void test_against_the_box(void **state)
{
    (void)state;
    static const double w[] = {0.125, 0.25, 0.25, 0.25, 0.125};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float out[N * N];
    double random[N * N];
    two_walls(&rig, 0, false);
    for (uint32_t i = 0; i < N * N; i++) { /* the prelude's aob_random, without a seed */
        uint32_t x = (i % N) * 1664525u + 1013904223u, y = (i / N) * 1664525u + 1013904223u, z = 1013904223u;
        x += y * z, y += z * x, z += x * y;
        x ^= x >> 16, y ^= y >> 16, z ^= z >> 16;
        x += y * z;
        random[i] = (x >> 8) / 16777216.0;
    }
    blur(&rig, gpu, NOISE, 0, out);
    for (int y = 2; y < N - 2; y++)
        for (int x = 2; x < N - 2; x++) {
            double sum = 0;
            for (int k = 0; k < 25; k++)
                sum += w[k / 5] * w[k % 5] * random[(y + k / 5 - 2) * N + x + k % 5 - 2];
            assert_near(out[y * N + x], sum, 0.0005);
        }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

static int turned(int i, int turn)
{
    int x = i % N, y = i / N;
    return turn == 1 ? y * N + N - 1 - x : turn == 2 ? (N - 1 - y) * N + x : turn == 3 ? x * N + y : i;
}

/* Mirrored or transposed before or after: the same image. */
static void test_symmetry(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float out[N * N], other[N * N];
    two_walls(&rig, 0, false);
    blur(&rig, gpu, NOISE, 0, out);
    for (int turn = 1; turn <= 3; turn++) {
        blur(&rig, gpu, NOISE, turn, other);
        for (int i = 0; i < N * N; i++)
            assert_near(other[turned(i, turn)], out[i], 0.0005);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* One wall is black, the one before it white: nothing grey, however small the step above the tolerance, which is
 * .01 x 3; below it they are one surface. */
static void test_nothing_over_a_depth_edge(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float out[N * N];
    for (int top = 0; top < 2; top++)
        for (double step = 0.02; step < 2.6; step += step < 0.1 ? 0.02 : 1.2) {
            struct aob_rig rig;
            size_t grey = 0, black = 0;
            two_walls(&rig, step, top);
            blur(&rig, gpu, DEPTH, 0, out);
            for (int i = 0; i < N * N; i++) {
                bool front = rig.hits.depth[i] < 2.99f;
                grey += out[i] != (front ? 0.0f : 1.0f);
                black += front;
            }
            assert_int_equal(black, N * N / 2);
            assert_int_equal(grey, step < 0.03 ? 4 * N : 0);
            aob_rig_finish(&rig);
        }
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_keeps_constants), cmocka_unit_test(test_removes_the_tile),
        cmocka_unit_test(test_against_the_box), cmocka_unit_test(test_symmetry),
        cmocka_unit_test(test_nothing_over_a_depth_edge)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
