#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/half.h"
#include "base/memory.h"
#include "frame/frame.h"
#include "rig.h"
#include "technique/param.h"
#include "technique/registry.h"

/* The separable blur of every technique that has one: constants stay, a mirrored or transposed image gives the mirrored
 * or transposed result, and nothing crosses a depth edge. One axis at a time, on a step of two walls facing the
 * camera. */

enum { N = 64, TAPS = 9 };
enum layout { STEP, MIRRORED, TRANSPOSED };
typedef float pattern(int x, int y);

static const struct aob_technique *owner; /* of the blur under test */
static const char *text_name;
static float raw[N * N];
static int axis;

static void fill(const void *values, void *texels)
{
    (void)values;
    memcpy(texels, raw, sizeof raw);
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex table =
        aob_texture(graph, .name = "pattern", .format = AOB_R32F, .width = N, .height = N, .fill = fill);
    aob_tex out = aob_texture(graph, .name = "blurred", .format = AOB_R32F);
    return aob_pass(graph, .name = "blur", .shader = text_name, .defines = {{"AXIS", axis}},
                    .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = "raw", .tex = table}},
                    .out = {{.name = "blurred", .tex = out}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, out);
}

/* Where a pixel of a layout lies in the step itself. */
static void place(enum layout layout, int x, int y, int *sx, int *sy)
{
    *sx = layout == TRANSPOSED ? y : layout == MIRRORED ? N - 1 - x : x;
    *sy = layout == TRANSPOSED ? x : y;
}

/* The near wall is narrower, so that the step is not its own mirror image. */
static float depth_at(int x)
{
    return x < 24 ? 3 : 5;
}

static void run(struct aob_gpu *gpu, enum layout layout, pattern *draw, float *result)
{
    struct aob_camera camera = {.eye = {0, 0, 1}, .fov_deg = 60};
    struct aob_gbuffer gbuffer = {.projection = aob_camera_projection(&camera, N, N, 0)};
    struct aob_technique technique = *owner;
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_screen screen;
    struct aob_error error = {{0}};
    double numbers[AOB_MAX_PARAM];
    unsigned char values[4 * AOB_MAX_PARAM];
    gbuffer.depth = AOB_NEW_ARRAY(float, N *N);
    gbuffer.normal = AOB_NEW_ARRAY(float, 4 * N * N);
    gbuffer.shading = AOB_NEW_ARRAY(float, 4 * N * N);
    for (int y = 0; y < N; y++)
        for (int x = 0; x < N; x++) {
            int sx, sy;
            place(layout, x, y, &sx, &sy);
            gbuffer.depth[y * N + x] = depth_at(sx);
            gbuffer.normal[4 * (y * N + x) + 2] = 1;
            raw[y * N + x] = draw(sx, sy);
        }
    technique.build = build;
    technique.check = NULL;
    axis = layout == TRANSPOSED;
    aob_param_defaults(owner->params, owner->param_count, 1, numbers);
    numbers[aob_param_find(owner->params, owner->param_count, "blur") - owner->params] = TAPS;
    aob_param_pack(owner->params, owner->param_count, numbers, values, sizeof values);
    if (!aob_screen_init(&screen, gpu, &gbuffer, &(struct aob_options){0}, &error) ||
        !aob_frame_init(frame, &screen, &technique, values, AOB_FETCH_SAMPLED, &error) ||
        !aob_frame_run(frame, 1, NULL, &error) ||
        !aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, result, &error))
        fail_msg("%s", error.text);
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    aob_gbuffer_finish(&gbuffer);
    free(frame);
}

static float constant(int x, int y)
{
    (void)x;
    (void)y;
    return 0.3f;
}

static float walls(int x, int y)
{
    (void)y;
    return depth_at(x) == 3 ? 0 : 1;
}

/* Something without any symmetry. */
static float noise(int x, int y)
{
    unsigned v = (unsigned)x * 73856093u ^ (unsigned)y * 19349663u;
    return (float)((v * 2654435761u) >> 16) / 65536.0f;
}

static void check_blur(struct aob_gpu *gpu)
{
    static float plain[N * N], other[N * N];
    double smoothed = 0, rough = 0;
    run(gpu, STEP, constant, plain);
    for (int i = 0; i < N * N; i++)
        assert_near(plain[i], 0.3, 1e-6);
    run(gpu, STEP, walls, plain);
    for (int i = 0; i < N * N; i++)
        assert_true(plain[i] == walls(i % N, i / N));
    run(gpu, STEP, noise, plain);
    for (int i = 1; i < N * N; i++) {
        smoothed += fabs((double)plain[i] - (double)plain[i - 1]);
        rough += fabs((double)noise(i % N, i / N) - (double)noise((i - 1) % N, (i - 1) / N));
    }
    assert_true(smoothed < 0.7 * rough); /* it does blur */
    for (enum layout layout = MIRRORED; layout <= TRANSPOSED; layout++) {
        run(gpu, layout, noise, other);
        for (int y = 0; y < N; y++)
            for (int x = 0; x < N; x++) {
                int sx, sy;
                place(layout, x, y, &sx, &sy);
                assert_near(other[y * N + x], plain[sy * N + sx], 2e-6);
            }
    }
}

static void test_separable_blurs(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    size_t count = 0;
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        for (const struct aob_shader *s = (*t)->shaders; s->name; s++) {
            if (strcmp(s->name, "blur") != 0 && strcmp(s->name, "gaussian") != 0)
                continue;
            owner = *t;
            text_name = s->name;
            printf("the blur of %s\n", owner->name);
            check_blur(gpu);
            count++;
        }
    assert_true(count >= 4);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_separable_blurs)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
