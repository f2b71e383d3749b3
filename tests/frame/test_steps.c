#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <aobudget/steps.h>
#include "base/memory.h"
#include "rig.h"

/* The shared steps over two outputs of one graph: whatever a step does to visibility it does to each component of a bent
 * normal. */

enum { W = 61, H = 47 };
enum { BLUR_STEP, GAUSSIAN, TILE_BLUR, CROSS5, UPSAMPLE, STEPS };

struct values {
    float blur_depth, blur_normal, blur_tolerance;
    int32_t step, blur;
};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, blur_depth, .max = 9, .initial = 0.1, .doc = "As in the step."),
    AOB_PARAM(struct values, blur_normal, .min = -1, .max = 1, .initial = 0.5, .doc = "As in the step."),
    AOB_PARAM(struct values, blur_tolerance, .max = 1, .initial = 0.05, .doc = "As in the step."),
    AOB_PARAM(struct values, step, .stage = AOB_HOST, .max = STEPS - 1, .doc = "Which of them."),
    AOB_PARAM(struct values, blur, .stage = AOB_CONSTANT, .max = 9, .initial = 5, .doc = "As in the step."),
};

static const char pattern_text[] = "void main()\n{\n"
                                   "    visibility = aob_random(aob_pixel, 0);\n"
                                   "    bent = vec4(visibility, 0.5 - 0.5 * visibility, 0.25, 0.0);\n}\n";

static aob_tex lay(struct aob_graph *graph, const struct values *v, aob_tex raw, enum aob_output output)
{
    switch (v->step) {
    case BLUR_STEP:
        return aob_step_blur(graph, .tex = raw, .taps = v->blur, .divisor = 1, .passes = 2, .output = output);
    case GAUSSIAN:
        return aob_step_gaussian(graph, .tex = raw, .taps = v->blur, .divisor = 1, .output = output);
    case TILE_BLUR:
        return aob_step_tile_blur(graph, .tex = raw, .taps = 5, .divisor = 1, .output = output);
    case CROSS5:
        return aob_step_cross5(graph, .tex = raw, .taps = 5, .output = output);
    default:
        return aob_step_upsample(graph, .tex = raw, .divisor = 2, .output = output);
    }
}

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    uint32_t divisor = v->step == UPSAMPLE ? 2 : 1;
    aob_tex visibility = aob_texture(graph, .name = "raw", .format = AOB_R16F, .divisor = divisor),
            bent = aob_texture(graph, .name = "raw_bent", .format = AOB_RGBA16F, .divisor = divisor);
    aob_pass(graph, .name = "pattern", .shader = "pattern", .reads = AOB_DEPTH,
             .out = {{.name = "visibility", .tex = visibility}, {.name = "bent", .tex = bent}});
    return aob_output(graph, AOB_OUT_VISIBILITY, lay(graph, v, visibility, AOB_OUT_VISIBILITY)) &&
           aob_output(graph, AOB_OUT_BENT_NORMAL, lay(graph, v, bent, AOB_OUT_BENT_NORMAL));
}

struct drawn {
    float visibility[W * H], bent[W * H][3];
};

static void draw(const struct aob_rig *rig, struct aob_gpu *gpu, const struct values *values,
                 struct drawn *drawn)
{
    const struct aob_shader shaders[] = {{"pattern", pattern_text},
                                         {"blur", aob_rig_text("gtao", "blur")},
                                         {"gaussian", aob_rig_text("starcraft2_ssao", "gaussian")},
                                         {"tile_blur", aob_rig_text("crytek_ssao", "tile_blur")},
                                         {"cross5", aob_rig_text("alchemy", "cross5")},
                                         {"upsample", aob_rig_text("gtao", "upsample")},
                                         {NULL, NULL}};
    const struct aob_technique technique = {.abi = AOB_ABI,
                                            .size = sizeof technique,
                                            .name = "both",
                                            .params = params,
                                            .param_count = AOB_COUNT(params),
                                            .values_size = sizeof *values,
                                            .shaders = shaders,
                                            .build = build};
    const struct aob_frame_desc desc = {
        .technique = &technique, .values = values, .wanted = 1u << AOB_OUT_BENT_NORMAL};
    struct aob_frame *frame = AOB_NEW(struct aob_frame);
    struct aob_screen screen;
    struct aob_error error = {{0}};
    if (!aob_screen_init(&screen, gpu, &rig->gbuffer, &(struct aob_options){0}, &error) ||
        !aob_frame_init_desc(frame, &screen, &desc, &error) || !aob_frame_run(frame, 1, NULL, &error) ||
        !aob_frame_read(frame, AOB_OUT_VISIBILITY, 1, drawn->visibility, &error) ||
        !aob_frame_read(frame, AOB_OUT_BENT_NORMAL, 3, drawn->bent[0], &error))
        fail_msg("step %d: %s", values->step, error.text);
    aob_frame_finish(frame);
    aob_screen_finish(&screen);
    free(frame);
}

/* The bound is half a step of the half floats below 1 in each of the four passes at most. */
static void check(const struct aob_rig *rig, int32_t step, const struct drawn *drawn)
{
    double varied = 0, mean = 0;
    int count = 0, sky = 0;
    for (int i = 0; i < W * H; i++) {
        float v = drawn->visibility[i];
        const float *b = drawn->bent[i];
        if (rig->hits.primitive[i] ==
            AOB_NO_PRIMITIVE) { /* what is upsampled is open there, and has no direction */
            assert_true(step != UPSAMPLE || (v == 1 && b[0] == 0 && b[1] == 0 && b[2] == 0));
            sky++;
            continue;
        }
        assert_near(b[0], v, 4 * 0x1p-11);
        assert_near(b[1], 0.5 - 0.5 * (double)v, 4 * 0x1p-11);
        assert_near(b[2], 0.25, 0);
        mean += (double)v;
        varied += (double)v * (double)v;
        count++;
    }
    assert_true(sky > 100);
    mean /= count;
    varied = sqrt(varied / count - mean * mean);
    /* Uniform noise has a mean of 1/2 and a deviation of sqrt(1/12) = 0.289: what a step mixes has less. */
    assert_near(mean, 0.5, 0.05);
    assert_true(varied > 0.02 && varied < 0.26);
}

static void test_each_component_takes_the_same_way(void **state)
{
    static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};
    struct aob_rig rig;
    struct drawn *drawn = AOB_NEW(struct drawn);
    (void)state;
    aob_rig_scene(&rig, "cornell", NULL, W, H, 0);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        for (int32_t step = 0; step < STEPS; step++) {
            draw(&rig, gpu, &(struct values){0.1F, 0.5F, 0.05F, step, 5}, drawn);
            check(&rig, step, drawn);
        }
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
    free(drawn);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_each_component_takes_the_same_way)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
