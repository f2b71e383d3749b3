#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"

/* Frames that follow each other: what one leaves is what the next one reads, and a screen shows one view after another. */

enum { W = 61, H = 37, PIXELS = W * H };

static const struct aob_shader shaders[] = {
    /* Two sums that take turns: a counts frames, b adds up a of the frame before. */
    {"count", "void main() { a = aob_fetch_before(aob_pixel) + 1.0; }\n"},
    {"sum", "void main() { b = aob_fetch_sums(aob_pixel) + aob_fetch_counts(aob_pixel); }\n"},
    {"both", "void main() { o = aob_fetch_a(aob_pixel) + aob_fetch_b(aob_pixel) / 1024.0; }\n"},
    {"shift", "void main() { o = aob_pixel.x == 0 ? float(aob_frame) : aob_sample_row((vec2(aob_pixel) - "
              "vec2(0.5, -0.5))\n"
              "    / vec2(aob_target_size)); }\n"},
    {"level", "void main() { fine = float(aob_frame + 1); }\n"},
    {"coarse", "void main() { coarse = 2.0 * aob_fetch_fine(aob_pixel * 2); }\n"},
    {"levels",
     "void main() { o = aob_fetch_old(aob_pixel / 2, 1) + aob_fetch_old(aob_pixel, 0) / 1024.0; }\n"},
    {"before", "void main() { vec3 then = aob_before(aob_pixel); o = vec4(then, aob_view_z(aob_pixel)); }\n"},
    {"paint",
     "void main() { o = vec4(aob_albedo(aob_pixel), aob_roughness(aob_pixel) + aob_view_z(aob_pixel)); }\n"},
    {"places", "void main() { vec3 v = aob_position(aob_pixel), n = aob_place_now(aob_place_before(v)) - v;\n"
               "    vec3 then = aob_place_before(v), d = aob_direction_before(v) - then + "
               "aob_place_before(vec3(0.0));\n"
               "    o = vec4(aob_project(then), -then.z, length(n) + length(d)); }\n"},
    {NULL, NULL}};

static bool build_sums(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex a = aob_texture(g, .name = "a", .format = AOB_R32F),
            b = aob_texture(g, .name = "b", .format = AOB_R32F),
            o = aob_texture(g, .name = "o", .format = AOB_R32F);
    aob_pass(g, .name = "count", .shader = "count", .in = {{.name = "before", .tex = aob_previous(g, a)}},
             .out = {{.name = "a", .tex = a}});
    aob_pass(
        g, .name = "sum", .shader = "sum",
        .in = {{.name = "sums", .tex = aob_previous(g, b)}, {.name = "counts", .tex = aob_previous(g, a)}},
        .out = {{.name = "b", .tex = b}});
    aob_pass(g, .name = "both", .shader = "both", .in = {{.name = "a", .tex = a}, {.name = "b", .tex = b}},
             .out = {{.name = "o", .tex = o}});
    return aob_output(g, AOB_OUT_VISIBILITY, o);
}

/* The output itself is kept; each frame moves it by a pixel, through the sampler. */
static bool build_shift(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex row = aob_texture(g, .name = "row", .format = AOB_R32F);
    aob_pass(g, .name = "shift", .shader = "shift",
             .in = {{.name = "row", .tex = aob_previous(g, row), .filter = AOB_BILINEAR}},
             .out = {{.name = "o", .tex = row}});
    return aob_output(g, AOB_OUT_VISIBILITY, row);
}

static bool build_levels(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex levels = aob_texture(g, .name = "levels", .format = AOB_R32F, .levels = 2),
            o = aob_texture(g, .name = "o", .format = AOB_R32F);
    aob_pass(g, .name = "read", .shader = "levels", .in = {{.name = "old", .tex = aob_previous(g, levels)}},
             .out = {{.name = "o", .tex = o}});
    aob_pass(g, .name = "fine", .shader = "level", .out = {{.name = "fine", .tex = levels}});
    aob_pass(g, .name = "coarse", .shader = "coarse", .in = {{.name = "fine", .tex = levels}},
             .out = {{.name = "coarse", .tex = levels, .level = 1}});
    return aob_output(g, AOB_OUT_VISIBILITY, o);
}

static const char *chosen;

static bool build_motion(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex o = aob_texture(g, .name = "o", .format = AOB_RGBA32F);
    aob_pass(g, .name = "motion", .shader = chosen, .reads = AOB_DEPTH | AOB_VELOCITY | AOB_MATERIAL,
             .out = {{.name = "o", .tex = o}});
    return aob_output(g, AOB_OUT_BENT_NORMAL, o) && aob_output(g, AOB_OUT_VISIBILITY, o);
}

static struct aob_technique technique = {.abi = AOB_ABI,
                                         .size = sizeof technique,
                                         .name = "trial",
                                         .title = "t",
                                         .citation = "c",
                                         .values_size = 4,
                                         .shaders = shaders};
static const int32_t values;
static const char *backend;
static enum aob_depth_encoding encoding;

struct stage {
    struct aob_rig rig;
    struct aob_gpu *gpu;
    struct aob_screen screen;
    struct aob_frame frame;
    float pixels[4 * PIXELS];
};

static void frame_init(struct stage *stage, struct aob_screen *screen, enum aob_fetch fetch)
{
    struct aob_error error = {{0}};
    const struct aob_frame_desc desc = {
        .technique = &technique, .values = &values, .fetch = fetch, .wanted = 1u << AOB_OUT_BENT_NORMAL};
    if (!aob_frame_init_desc(&stage->frame, screen, &desc, &error))
        fail_msg("%s: %s", backend, error.text);
}

static struct stage *stage_create(enum aob_fetch fetch, bool (*build)(struct aob_graph *, const void *))
{
    struct stage *stage = AOB_NEW(struct stage);
    struct aob_error error = {{0}};
    const struct aob_options options = {.fetch = (int32_t)fetch, .depth_encoding = (int32_t)encoding};
    technique.build = build;
    stage->gpu = aob_rig_gpu(backend);
    aob_rig_scene(&stage->rig, "spheres", NULL, W, H, 0);
    if (!aob_screen_init(&stage->screen, stage->gpu, &stage->rig.gbuffer, &options, &error))
        fail_msg("%s: %s", backend, error.text);
    frame_init(stage, &stage->screen, fetch);
    return stage;
}

static void stage_destroy(struct stage *stage)
{
    aob_frame_finish(&stage->frame);
    aob_screen_finish(&stage->screen);
    aob_rig_finish(&stage->rig);
    aob_gpu_close(stage->gpu);
    free(stage);
}

/* Draws the frame of this number, `repeats` times; what its first component is everywhere. */
static double draw(struct stage *stage, int number, int repeats)
{
    struct aob_error error = {{0}};
    struct aob_frame_time time;
    if (!aob_frame_set(&stage->frame, number, &values, &error) ||
        !aob_frame_run(&stage->frame, repeats, &time, &error) ||
        !aob_frame_read(&stage->frame, AOB_OUT_VISIBILITY, 1, stage->pixels, &error))
        fail_msg("%s", error.text);
    assert_true(time.whole.wall_ns > 0);
    return (double)stage->pixels[PIXELS / 2];
}

static void test_a_frame_reads_what_the_one_before_left(void **state)
{
    (void)state;
    for (int fetch = AOB_FETCH_SAMPLED; fetch <= AOB_FETCH_STORAGE; fetch++) {
        struct stage *stage = stage_create((enum aob_fetch)fetch, build_sums);
        assert_int_equal(stage->frame.memory_bytes, 5 * 4 * PIXELS); /* two of a, two of b, and o */
        double sum = 0;
        for (int n = 0; n < 5; n++) { /* a is n + 1, b the sum of 1 .. n */
            sum += n;
            assert_true(draw(stage, n, 1) == n + 1 + sum / 1024);
        }
        for (int i = 0; i < PIXELS; i++)
            assert_true((double)stage->pixels[i] == 5 + 10 / 1024.0);
        assert_true(draw(stage, 5, 3) == 8 + 28 / 1024.0); /* three frames more */
        assert_true(draw(stage, 6, 2) == 10 + 45 / 1024.0);
        assert_true(draw(stage, 0, 1) == 1); /* a new sequence, whatever is left over */
        assert_true(draw(stage, 1, 1) == 2 + 1 / 1024.0);
        stage_destroy(stage);
    }
}

static void test_an_output_may_be_kept(void **state)
{
    (void)state;
    struct stage *stage = stage_create(AOB_FETCH_SAMPLED, build_shift);
    for (int n = 0; n < 6; n++)
        draw(stage, n, 1);
    for (int x = 0; x < W; x++) /* frame 0 has zeros but for its column 0 */
        assert_true(stage->pixels[W + x] == (x < 6 ? (float)(5 - x) : 0));
    stage_destroy(stage);
}

static void test_levels_are_kept(void **state)
{
    (void)state;
    struct stage *stage = stage_create(AOB_FETCH_STORAGE, build_levels);
    assert_true(draw(stage, 0, 1) == 0);
    assert_true(draw(stage, 1, 1) == 2 + 1 / 1024.0);
    assert_true(draw(stage, 2, 1) == 4 + 2 / 1024.0);
    stage_destroy(stage);
}

static void read_motion(struct stage *stage, float vectors[4][PIXELS])
{
    static float three[3 * PIXELS];
    struct aob_error error = {{0}};
    draw(stage, 1, 1);
    if (!aob_frame_read(&stage->frame, AOB_OUT_BENT_NORMAL, 3, three, &error))
        fail_msg("%s", error.text);
    for (int i = 0; i < PIXELS; i++) {
        for (int c = 0; c < 3; c++)
            vectors[c][i] = three[3 * i + c];
        vectors[3][i] = stage->pixels[i];
    }
}

/* Where the points of pixels were, in double precision: the screen's other view. */
static void place_then(const struct aob_rig *rig, const struct aob_camera *before, int i, double q[3])
{
    struct aob_vec3 point;
    const struct aob_frame_axes axes = aob_camera_axes(before);
    assert_true(aob_rig_position(rig, i % W, i / W, &point));
    struct aob_vec3 from = aob_vec_sub(point, before->eye);
    assert_true(aob_camera_project(before, &rig->gbuffer.projection, from, q));
    q[2] = -aob_vec_dot(from, axes.back);
}

/* Velocities as a G-buffer holds them. */
static float *velocities(const struct aob_rig *rig, const struct aob_camera *before)
{
    float *velocity = AOB_NEW_ARRAY(float, 3 * PIXELS);
    for (int i = 0; i < PIXELS; i++) {
        double q[3] = {0, 0, (double)AOB_GBUFFER_SKY};
        if (rig->gbuffer.depth[i] < 0.5f * AOB_GBUFFER_SKY)
            place_then(rig, before, i, q);
        velocity[3 * i] = (float)(i % W + 0.5 - q[0]);
        velocity[3 * i + 1] = (float)(i / W + 0.5 - q[1]);
        velocity[3 * i + 2] = (float)q[2];
    }
    return velocity;
}

/* Half floats of differences are what aob_before has, and floats of places what aob_place_before has. */
static void check_motion(const struct aob_rig *rig, const struct aob_camera *before, float found[4][PIXELS],
                         float still[4][PIXELS])
{
    int surfaces = 0;
    for (int i = 0; i < PIXELS; i++) {
        double q[3];
        if (rig->gbuffer.depth[i] >= 0.5f * AOB_GBUFFER_SKY) {
            assert_true(found[2][i] == AOB_GBUFFER_SKY);
            continue;
        }
        surfaces++;
        place_then(rig, before, i, q);
        const double now[3] = {i % W + 0.5, i / W + 0.5, (double)rig->gbuffer.depth[i]};
        for (int c = 0; c < 3; c++) {
            assert_near(found[c][i], q[c], fabs(now[c] - q[c]) / 2048 + 1e-4 * (c < 2) + 1e-6 * q[c]);
            assert_near(still[c][i], q[c], c < 2 ? 1e-3 : 1e-5 * q[2]);
        }
        assert_true(still[3][i] < 1e-5f);
    }
    assert_true(surfaces > PIXELS / 2);
}

/* The view turns and moves; what aob_before says of what stands still is what aob_place_before says, and a hand's own
 * reprojection. */
static void test_motion_is_that_of_the_camera(void **state)
{
    (void)state;
    static float found[4][PIXELS], still[4][PIXELS];
    struct aob_camera camera = aob_scene_view(aob_scene_find("spheres"), NULL)->camera;
    camera.moves = true;
    camera.previous_eye = aob_vec_add(camera.eye, aob_vec(0.07, -0.03, 0.05));
    camera.previous_target = aob_vec_add(camera.target, aob_vec(-0.04, 0.06, 0));
    const struct aob_camera before = aob_camera_previous(&camera);
    for (int fetch = AOB_FETCH_SAMPLED; fetch <= AOB_FETCH_STORAGE; fetch++) {
        chosen = "before";
        struct stage *stage = stage_create((enum aob_fetch)fetch, build_motion);
        struct aob_gbuffer moved = stage->rig.gbuffer;
        moved.velocity = velocities(&stage->rig, &before);
        const struct aob_screen_pose pose = {&moved, &aob_light_uniform, aob_camera_then(&camera)};
        assert_true(aob_screen_show(&stage->screen, &pose, NULL));
        read_motion(stage, found);
        aob_frame_finish(&stage->frame);
        chosen = "places";
        frame_init(stage, &stage->screen, (enum aob_fetch)fetch);
        read_motion(stage, still);
        check_motion(&stage->rig, &before, found, still);
        free(moved.velocity);
        stage_destroy(stage);
    }
}

/* Depth and materials of a second view, in an encoding whose range is the view's own, are those of a screen made for it. */
static void compare_views(const char *shader, float shown[4][PIXELS])
{
    struct aob_rig other;
    struct aob_screen fresh;
    static float made[4][PIXELS];
    const struct aob_options options = {.depth_encoding = (int32_t)encoding};
    chosen = shader;
    struct stage *stage = stage_create(AOB_FETCH_SAMPLED, build_motion);
    aob_rig_scene(&other, "gallery", NULL, W, H, 0);
    read_motion(stage, shown);
    const struct aob_screen_pose pose = {&other.gbuffer, &aob_light_uniform, aob_affine_identity()};
    assert_true(aob_screen_show(&stage->screen, &pose, NULL));
    read_motion(stage, shown);
    aob_frame_finish(&stage->frame);
    assert_true(aob_screen_init(&fresh, stage->gpu, &other.gbuffer, &options, NULL));
    frame_init(stage, &fresh, AOB_FETCH_SAMPLED);
    read_motion(stage, made);
    assert_memory_equal(shown, made, sizeof made);
    aob_frame_finish(&stage->frame);
    aob_screen_finish(&fresh);
    aob_rig_finish(&other);
    stage_destroy(stage);
}

static void test_a_screen_shows_another_view(void **state)
{
    (void)state;
    static float shown[4][PIXELS];
    compare_views("before", shown);
    for (int i = 0; i < PIXELS; i++) /* without velocities all stands still */
        if (shown[2][i] < 0.5f * AOB_GBUFFER_SKY)
            assert_true(shown[0][i] == (float)(i % W) + 0.5f && shown[2][i] == shown[3][i]);
    encoding = AOB_DEPTH_UNORM16;
    compare_views("paint", shown);
    encoding = AOB_DEPTH_R32F;
    double red = 0;
    for (int i = 0; i < PIXELS; i++)
        red += fabs((double)shown[0][i] - (double)shown[2][i]);
    assert_true(red > 1); /* it has colours */
}

int main(void)
{
    static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};
    int failed = 0;
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_frame_reads_what_the_one_before_left),
                                       cmocka_unit_test(test_an_output_may_be_kept),
                                       cmocka_unit_test(test_levels_are_kept),
                                       cmocka_unit_test(test_motion_is_that_of_the_camera),
                                       cmocka_unit_test(test_a_screen_shows_another_view)};
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        backend = backends[b];
        failed += cmocka_run_group_tests(tests, NULL, NULL);
    }
    return failed;
}
