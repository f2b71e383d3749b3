#include "check.h"
#include <aobudget/steps.h>
#include <math.h>
#include "rig.h"
#include "technique/option.h"
#include "technique/param.h"
#include "technique/registry.h"

/* shaders/steps/gaussian.glsl by itself: one axis over pictures that a table holds. */

enum { SIDE = 64 };
enum picture { CONSTANT, NOISE, NOISE_MIRRORED, NOISE_TRANSPOSED, REGION };
struct values {
    float blur_depth, blur_normal;
    int32_t blur, axis, picture;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, blur_depth, .min = 0, .max = 10, .initial = 0.1, .doc = "Depth."),
    AOB_PARAM(struct values, blur_normal, .min = -1, .max = 1, .initial = 0.9, .doc = "Cosine."),
    AOB_PARAM(struct values, blur, .stage = AOB_CONSTANT, .min = 0, .max = 33, .initial = 9, .doc = "Taps."),
    AOB_PARAM(struct values, axis, .stage = AOB_HOST, .min = 0, .max = 1, .doc = "Axis."),
    AOB_PARAM(struct values, picture, .stage = AOB_HOST, .min = 0, .max = 4, .doc = "Picture."),
};

/* A band and a block: edges along both axes, alike under no mirror and no transposition. */
static bool in_region(int x, int y)
{
    return (x >= 20 && x < 33) || (y >= 10 && y < 14 && x > 40);
}

static float noise(int x, int y)
{
    uint32_t h = (uint32_t)(x + SIDE * y) * 2654435761u;
    h = (h ^ h >> 15) * 2246822519u;
    return (float)(h >> 8) / 16777216;
}

static void fill_picture(const void *values, void *texels)
{
    int32_t picture = ((const struct values *)values)->picture;
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        const float pictures[] = {0.37f, noise(x, y), noise(SIDE - 1 - x, y), noise(y, x), in_region(x, y)};
        ((float *)texels)[i] = pictures[picture];
    }
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex raw = aob_texture(graph, .name = "picture", .format = AOB_R32F, .width = SIDE, .height = SIDE,
                              .fill = fill_picture);
    aob_tex blurred = aob_texture(graph, .name = "blurred", .format = AOB_R32F);
    return aob_pass(graph, .name = "blur", .shader = "gaussian", .defines = {{"AXIS", v->axis}},
                    .reads = AOB_DEPTH | AOB_NORMAL, .in = {{.name = "raw", .tex = raw}},
                    .out = {{.name = "blurred", .tex = blurred}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, blurred);
}

extern const struct aob_technique aob_technique_starcraft2_ssao; /* for its text "gaussian" */

static void blur_picture(const struct aob_rig *rig, struct aob_gpu *gpu, int axis, enum picture picture,
                         float *pixels)
{
    struct aob_technique technique = {.abi = AOB_ABI,
                                      .size = sizeof technique,
                                      .name = "gaussian",
                                      .title = "Gaussian",
                                      .citation = "none",
                                      .revision = 1,
                                      .params = params,
                                      .param_count = sizeof params / sizeof *params,
                                      .values_size = sizeof(struct values),
                                      .shaders = aob_technique_starcraft2_ssao.shaders,
                                      .build = build};
    const struct values values = {0.1f, 0.9f, 9, axis, (int32_t)picture};
    double chosen[AOB_OPTION_COUNT];
    struct aob_options options;
    struct aob_screen screen;
    static struct aob_frame frame;
    struct aob_error error = {{0}};
    aob_param_defaults(aob_option_params, AOB_OPTION_COUNT, 1, chosen);
    aob_param_pack(aob_option_params, AOB_OPTION_COUNT, chosen, &options, sizeof options);
    if (!aob_screen_init(&screen, gpu, &rig->gbuffer, &options, &error) ||
        !aob_frame_init(&frame, &screen, &technique, &values, AOB_FETCH_SAMPLED, &error) ||
        !aob_frame_run(&frame, 1, NULL, &error) ||
        !aob_frame_read(&frame, AOB_OUT_VISIBILITY, 1, pixels, &error))
        fail_msg("%s", error.text);
    aob_frame_finish(&frame);
    aob_screen_finish(&screen);
}

/* The region lies nearer by 0.2 (turned 0), or faces 40 degrees away; the G-buffer as it is, mirrored, transposed. */
static void region_rig(struct aob_rig *rig, bool turned, enum picture layout)
{
    aob_rig_plane(rig, &(struct aob_rig_plane){.width = SIDE, .height = SIDE});
    for (int i = 0; i < SIDE * SIDE; i++) {
        int x = i % SIDE, y = i / SIDE;
        bool in = layout == NOISE_MIRRORED     ? in_region(SIDE - 1 - x, y)
                  : layout == NOISE_TRANSPOSED ? in_region(y, x)
                                               : in_region(x, y);
        rig->gbuffer.depth[i] -= in && !turned ? 0.2f : 0;
        if (in && turned)
            memcpy(&rig->gbuffer.normal[4 * i], (float[]){0.6428f, 0, 0.7660f}, 3 * sizeof(float));
    }
}

static void test_keeps_constants_and_edges(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    static float pixels[SIDE * SIDE];
    for (int k = 0; k < 4; k++) {
        struct aob_rig rig;
        region_rig(&rig, k & 1, NOISE);
        blur_picture(&rig, gpu, k >> 1, CONSTANT, pixels);
        for (int i = 0; i < SIDE * SIDE; i++)
            assert_near(pixels[i], 0.37f, 1e-6);
        blur_picture(&rig, gpu, k >> 1, REGION, pixels);
        for (int i = 0; i < SIDE * SIDE; i++)
            assert_true(pixels[i] == (in_region(i % SIDE, i / SIDE) ? 1.0f : 0.0f));
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* A mirrored scene gives the mirrored picture; a transposed one that of the other axis. */
static void test_symmetry(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    static float own[SIDE * SIDE], mirrored[SIDE * SIDE], transposed[SIDE * SIDE];
    struct aob_rig rigs[3];
    double change = 0;
    region_rig(&rigs[0], false, NOISE);
    region_rig(&rigs[1], false, NOISE_MIRRORED);
    region_rig(&rigs[2], false, NOISE_TRANSPOSED);
    for (int axis = 0; axis < 2; axis++) {
        blur_picture(&rigs[0], gpu, axis, NOISE, own);
        blur_picture(&rigs[1], gpu, axis, NOISE_MIRRORED, mirrored);
        blur_picture(&rigs[2], gpu, 1 - axis, NOISE_TRANSPOSED, transposed);
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE, y = i / SIDE;
            assert_near(own[i], mirrored[y * SIDE + SIDE - 1 - x], 1e-6); /* the order of a sum */
            assert_near(own[i], transposed[x * SIDE + y], 1e-6);
            change += fabs((double)own[i] - (double)noise(x, y));
        }
    }
    assert_true(change / (2 * SIDE * SIDE) > 0.1);
    for (int k = 0; k < 3; k++)
        aob_rig_finish(&rigs[k]);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_keeps_constants_and_edges),
                                       cmocka_unit_test(test_symmetry)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
