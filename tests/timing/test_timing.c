#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "timing/fixed_pass.h"
#include "timing/timing.h"
#include "rig.h"
#include "technique/param.h"
#include "technique/registry.h"

/* The null backend's clock is exact: 100 ns a texel and target. So a case of n passes costs n fixed passes, to the
 * last digit, and its interval has no width. */

enum { W = 64, H = 36 };

static const struct aob_technique *builtin(const char *name)
{
    const struct aob_technique *const *t = aob_builtin_techniques;
    while (strcmp((*t)->name, name) != 0)
        t++;
    return *t;
}

static void init(struct aob_frame *frame, const struct aob_screen *screen,
                 const struct aob_technique *technique)
{
    double numbers[AOB_MAX_PARAM];
    unsigned char values[4 * AOB_MAX_PARAM] = {0};
    struct aob_error error = {{0}};
    aob_param_defaults(technique->params, technique->param_count, 1, numbers);
    aob_param_pack(technique->params, technique->param_count, numbers, values, sizeof values);
    if (!aob_frame_init(frame, screen, technique, values, AOB_FETCH_SAMPLED, &error))
        fail_msg("%s", error.text);
}

static void check_case(const struct aob_timing *t, const struct aob_frame *frame, double passes,
                       double pass_ms)
{
    assert_near(t->cpu_ms, passes * pass_ms, 1e-9);
    assert_near(t->to_fixed.ratio, passes, 1e-9);
    assert_true(t->to_fixed.bounded);
    assert_near(t->to_fixed.low, passes, 1e-9);
    assert_near(t->to_fixed.high, passes, 1e-9);
    assert_int_equal(t->rounds, 20); /* narrow enough at the first check point */
    for (int p = 0; p < frame->graph.pass_count; p++) {
        assert_near(t->pass_cpu_ms[p], pass_ms, 1e-9);
        assert_true(t->pass_to_fixed[p].bounded);
        assert_near(t->pass_to_fixed[p].low, 1, 1e-9);
        assert_near(t->pass_to_fixed[p].high, 1, 1e-9);
    }
}

static void test_exact_clock(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("null");
    struct aob_rig rig;
    struct aob_screen screen;
    struct aob_frame *frames = AOB_NEW_ARRAY(struct aob_frame, 3);
    struct aob_block_timing timing;
    aob_rig_scene(&rig, "corner", NULL, W, H, 0);
    assert_true(aob_screen_init(&screen, gpu, &rig.gbuffer, &(struct aob_options){0}, NULL));
    init(&frames[0], &screen, &aob_technique_fixed_pass);
    init(&frames[1], &screen, builtin("none"));
    init(&frames[2], &screen, builtin("gtao")); /* horizon, and two passes of the blur */
    struct aob_frame *const cases[] = {&frames[1], &frames[2]};
    assert_true(aob_timing_run(
        &(struct aob_timing_desc){
            .fixed = &frames[0], .frames = cases, .frame_count = 2, .seconds = 30, .seed = 7},
        &timing, NULL));
    const double pass_ms = W * H * 100e-6;
    const double passes[] = {1, 3};
    for (int i = 0; i < 2; i++)
        check_case(&timing.cases[i], &frames[i + 1], passes[i], pass_ms);
    assert_near(timing.control.ratio, 1, 1e-9);
    assert_near(timing.fixed_cpu_ms, pass_ms, 1e-9);
    assert_int_equal(frames[1].memory_bytes, W * H);         /* r8 */
    assert_int_equal(frames[2].memory_bytes, W * H * 2 * 3); /* three r16f */
    for (int i = 0; i < 3; i++)
        aob_frame_finish(&frames[i]);
    aob_screen_finish(&screen);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
    free(frames);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_exact_clock)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
