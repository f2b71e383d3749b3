/* The step temporal, laid over a technique whose frames are numbers: what of before counts, and what does not. */
#include "check.h"
#include <aobudget/steps.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "rig.h"

enum { W = 64, H = 48, PIXELS = W * H };

struct values {
    float radius;
    int32_t history;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .min = 0, .max = 9, .doc = "."),
    AOB_PARAM_HISTORY(struct values, history),
};

static bool open_normal; /* the image is a bent normal with the visibility behind it */

static bool build(struct aob_graph *graph, const void *values)
{
    enum aob_output kind = open_normal ? AOB_OUT_BENT_NORMAL : AOB_OUT_VISIBILITY;
    aob_tex raw = aob_texture(graph, .name = "raw", .format = open_normal ? AOB_RGBA32F : AOB_R32F);
    aob_pass(graph, .name = "raw", .shader = "raw", .defines = {{"BENT", open_normal}},
             .out = {{.name = "raw", .tex = raw}});
    int32_t frames = ((const struct values *)values)->history;
    aob_tex mean = aob_step_temporal(graph, .tex = raw, .output = kind, .frames = frames,
                                     .changes = aob_step_changes(graph, .frames = frames));
    return aob_open_outputs(graph, kind, mean);
}

/* Frame n is a ramp over the columns, times a number of its own; the pixel (5, 5) of frame 0 is no number. */
static struct aob_shader shaders[] = {
    {"raw",
     "void main() {\n"
     "    float v = float(aob_pixel.x) / 128.0 * (aob_frame == 0 ? 0.25 : aob_frame == 1 ? 1.0 : 0.5);\n"
     "    if (aob_frame == 0 && aob_pixel == ivec2(5)) v = uintBitsToFloat(0x7fc00000u);\n"
     "#if BENT == 1\n    raw = vec4(0.0, v, 0.5, v);\n#else\n    raw = v;\n#endif\n}\n"},
    {"changes", NULL},
    {"change_groups", NULL},
    {"changed", NULL},
    {"temporal", NULL},
    {NULL, NULL}};
static struct aob_technique technique = {.abi = AOB_ABI,
                                         .size = sizeof technique,
                                         .name = "trial",
                                         .title = "t",
                                         .citation = "c",
                                         .params = params,
                                         .param_count = 2,
                                         .values_size = sizeof(struct values),
                                         .shaders = shaders,
                                         .build = build};

static const char *backend;
static const struct values usual = {.radius = 0.1f, .history = 8};

/* A plane 3 units away, and what of it the second frame changes. */
struct stage {
    struct aob_gpu *gpu;
    struct aob_rig rig;
    struct aob_gbuffer second;
    float first_image[PIXELS], second_image[PIXELS], bent[3 * PIXELS];
};

static float *copy(const float *from, size_t count)
{
    float *into = AOB_NEW_ARRAY(float, count);
    memcpy(into, from, count * sizeof *from);
    return into;
}

static struct stage *stage_create(void)
{
    struct stage *stage = AOB_NEW(struct stage);
    stage->gpu = aob_rig_gpu(backend);
    aob_rig_plane(&stage->rig, &(struct aob_rig_plane){.width = W, .height = H});
    stage->second = stage->rig.gbuffer;
    stage->second.depth = copy(stage->rig.gbuffer.depth, PIXELS);
    stage->second.normal = copy(stage->rig.gbuffer.normal, 4 * PIXELS);
    stage->second.velocity = AOB_NEW_ARRAY(float, 3 * PIXELS);
    for (int i = 0; i < PIXELS; i++)
        stage->second.velocity[3 * i + 2] = stage->second.depth[i];
    return stage;
}

static void stage_destroy(struct stage *stage)
{
    free(stage->second.depth);
    free(stage->second.normal);
    free(stage->second.velocity);
    aob_rig_finish(&stage->rig);
    aob_gpu_close(stage->gpu);
    free(stage);
}

/* Two frames; `then` is the camera's motion before the second. */
static void draw(struct stage *stage, const struct values *values, struct aob_affine then)
{
    struct aob_screen screen;
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_error error = {{0}};
    const struct aob_screen_pose pose = {&stage->second, &aob_light_uniform, then};
    const struct aob_frame_desc desc = {
        .technique = &technique, .values = values, .wanted = open_normal ? 1u << AOB_OUT_BENT_NORMAL : 0};
    bool ok = aob_screen_init(&screen, stage->gpu, &stage->rig.gbuffer, &(struct aob_options){0}, &error) &&
              aob_frame_init_desc(frame, &screen, &desc, &error) && aob_frame_run(frame, 1, NULL, &error) &&
              aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, stage->first_image, &error) &&
              aob_screen_show(&screen, &pose, &error) && aob_frame_set(frame, 1, values, &error) &&
              aob_frame_run(frame, 1, NULL, &error) &&
              aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, stage->second_image, &error) &&
              (!open_normal || aob_frame_read(frame, AOB_OUT_BENT_NORMAL, 3, stage->bent, &error));
    if (!ok)
        fail_msg("%s: %s", backend, error.text);
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    free(frame);
}

/* What a pixel shows that is of both frames, where frame 0 is read at column x; and of the new one alone. */
static double both(double x, int now)
{
    return (0.25 * x + now) / 128 / 2;
}
static double alone(int now)
{
    return now / 128.0;
}

static void expect(const struct stage *stage, int x, int y, double value)
{
    double found = (double)stage->second_image[y * W + x];
    if (fabs(found - value) > 1e-5)
        fail_msg("%s: pixel %d, %d is %g, not %g", backend, x, y, found, value);
}

static void test_what_stands_still_counts(void **state)
{
    (void)state;
    for (int kind = 0; kind < 2; kind++) {
        struct stage *stage = stage_create();
        open_normal = kind;
        draw(stage, &usual, aob_affine_identity());
        for (int i = 0; i < PIXELS; i++) {
            bool hole = i == 5 * W + 5; /* no number of before goes on */
            expect(stage, i % W, i / W, hole ? alone(5) : both(i % W, i % W));
            if (kind && !hole)
                assert_near(stage->bent[3 * i + 1], both(i % W, i % W), 1e-5);
            if (kind)
                assert_near(stage->bent[3 * i + 2], 0.5, 1e-6);
        }
        open_normal = false;
        stage_destroy(stage);
    }
}

/* The camera moves along the plane by pixels, a whole number or not: what it stood over is found again. */
static void test_the_place_of_before(void **state)
{
    (void)state;
    static const double shifts[] = {3, -2.25};
    struct stage *stage = stage_create();
    for (size_t s = 0; s < AOB_COUNT(shifts); s++) {
        struct aob_affine then = aob_affine_identity();
        then.m[0][3] = -shifts[s] * 3 * stage->rig.gbuffer.projection.sx;
        for (int i = 0; i < PIXELS; i++)
            stage->second.velocity[3 * i] = (float)shifts[s];
        draw(stage, &usual, then);
        for (int y = 8; y < H; y++) /* the hole lies above */
            for (int x = 0; x < W; x++) {
                double from = x - shifts[s];
                if (from >= 0 && from <= W - 1)
                    expect(stage, x, y, both(from, x));
                else if (from < -0.95 || from > W - 0.05) /* hardly a share of the image's own column */
                    expect(stage, x, y, alone(x));
            }
    }
    stage_destroy(stage);
}

/* Another surface is there: nearer, or turned, or it was behind the camera. A small radius keeps this from the other pixels. */
static void test_another_surface_does_not_count(void **state)
{
    (void)state;
    const struct values narrow = {.radius = 1e-4f, .history = 8};
    struct stage *stage = stage_create();
    for (int i = 0; i < PIXELS; i++) {
        int x = i % W, y = i / W;
        if (y >= 32 && x < 16) /* it came from 2.9 units away, where nothing was seen */
            stage->second.velocity[3 * i + 2] = 2.9f;
        else if (y >= 32 && x < 32) { /* by 50 degrees */
            stage->second.normal[4 * i] = sinf(0.873f);
            stage->second.normal[4 * i + 2] = cosf(0.873f);
        } else if (y >= 32 && x < 48)
            stage->second.velocity[3 * i] = stage->second.velocity[3 * i + 1] =
                stage->second.velocity[3 * i + 2] = 1e9f;
        else if (y >= 32)
            stage->second.depth[i] = stage->second.velocity[3 * i + 2] = AOB_GBUFFER_SKY;
    }
    draw(stage, &narrow, aob_affine_identity());
    for (int y = 33; y < H; y++)
        for (int x = 0; x < W; x++)
            expect(stage, x, y, alone(x));
    for (int y = 8; y < 24; y++) /* tiles that nothing has changed near */
        for (int x = 0; x < W; x++)
            expect(stage, x, y, both(x, x));
    stage_destroy(stage);
}

/* In one tile a nearer patch slides over the plane, or is there of a sudden and says that it always was: about it nothing of before counts,
 * as far as the radius reaches and no farther. */
static void test_a_change_reaches_as_far_as_the_radius(void **state)
{
    (void)state;
    for (int sudden = 0; sudden < 2; sudden++) {
        struct stage *stage = stage_create();
        const struct values wide = {.radius = (float)(30 * stage->rig.gbuffer.projection.sx), .history = 8};
        for (int y = 24; y < 32; y++)
            for (int x = 32; x < 40; x++) {
                float *velocity = &stage->second.velocity[3 * (y * W + x)];
                stage->second.depth[y * W + x] = velocity[2] = sudden ? 2.9f : 2.999f;
                velocity[0] = sudden ? 0 : 0.25f;
            }
        draw(stage, &wide, aob_affine_identity());
        for (int y = 8; y < H; y++)
            for (int x = 0; x < W; x++) {
                /* The radius covers 10 pixels: tiles that are 8 from that of the patch are within it, those at 16 are not. */
                int across = abs(x / 8 - 4), down = abs(y / 8 - 3);
                double far = hypot(fmax(0, 8 * across - 8), fmax(0, 8 * down - 8));
                if (far < 9 || far > 11.5)
                    expect(stage, x, y, far < 9 ? alone(x) : both(x, x));
            }
        stage_destroy(stage);
    }
}

/* The camera turns by 30 degrees before a plane: normals and bent normals of before are in its old view space. */
static void test_a_camera_that_turns(void **state)
{
    (void)state;
    struct stage *stage = stage_create();
    struct aob_mesh mesh = {0};
    struct aob_rig turned;
    struct aob_camera camera = stage->rig.camera;
    double angle = M_PI / 6;
    camera.moves = true;
    camera.previous_eye = camera.eye;
    camera.previous_target = camera.target;
    camera.target = aob_vec_add(camera.eye, aob_vec(sin(angle), 0, -cos(angle)));
    aob_mesh_add_quad(&mesh, aob_vec(-99, -99, 0), aob_vec(198, 0, 0), aob_vec(0, 198, 0));
    aob_rig_init(&turned, &mesh, &camera, W, H, 0);
    aob_mesh_finish(&mesh);
    struct aob_gbuffer still = stage->second;
    stage->second = turned.gbuffer;
    open_normal = true;
    draw(stage, &usual, aob_camera_then(&camera));
    open_normal = false;
    stage->second = still;
    int found = 0;
    for (int y = 12; y < H - 12; y++)
        for (int x = 0; x < W; x++) {
            const float *velocity = &turned.gbuffer.velocity[3 * (y * W + x)];
            double from = x - (double)velocity[0], up = y - (double)velocity[1];
            if (from < 2 || from > W - 3 || up < 8 || up > H - 3)
                continue;
            found++;
            assert_near(stage->second_image[y * W + x], both(from, x),
                        2e-3); /* a ramp that perspective bends */
            assert_near(stage->bent[3 * (y * W + x)], 0.25 * sin(angle),
                        1e-3); /* of (0, ., .5) along (cos, 0, sin) */
        }
    assert_true(found > 200);
    aob_rig_finish(&turned);
    stage_destroy(stage);
}

int main(void)
{
    static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};
    int failed = 0;
    for (struct aob_shader *s = shaders; s->name; s++)
        s->text = s->text ? s->text : aob_rig_text("gtao", s->name);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_what_stands_still_counts),
                                       cmocka_unit_test(test_the_place_of_before),
                                       cmocka_unit_test(test_another_surface_does_not_count),
                                       cmocka_unit_test(test_a_change_reaches_as_far_as_the_radius),
                                       cmocka_unit_test(test_a_camera_that_turns)};
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        backend = backends[b];
        failed += cmocka_run_group_tests(tests, NULL, NULL);
    }
    return failed;
}
