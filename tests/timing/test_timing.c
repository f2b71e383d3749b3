#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "timing/fixed_pass.h"
#include "timing/summary.h"
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

static void init(struct aob_frame *frame, struct aob_screen *screen, const struct aob_technique *technique)
{
    double numbers[AOB_MAX_PARAM];
    unsigned char values[4 * AOB_MAX_PARAM] = {0};
    struct aob_error error = {{0}};
    aob_param_defaults(technique->params, technique->param_count, 1, numbers);
    aob_param_pack(technique->params, technique->param_count, numbers, values, sizeof values);
    if (!aob_frame_init(frame, screen, technique, values, AOB_FETCH_SAMPLED, &error))
        fail_msg("%s", error.text);
}

static void check_case(const struct aob_round_list *rounds, size_t slot, size_t passes, double pass_ms)
{
    struct aob_summary t;
    aob_summarise(rounds, slot, &t);
    assert_int_equal(t.rounds, 20); /* narrow enough at the first check point */
    assert_near(t.whole.ms[AOB_CLOCK_CPU], (double)passes * pass_ms, 1e-9);
    struct aob_ratio own = aob_rounds_ratio(rounds, slot);
    assert_near(own.ratio, (double)passes, 1e-9);
    assert_true(own.bounded);
    assert_near(own.low, (double)passes, 1e-9);
    assert_near(own.high, (double)passes, 1e-9);
    assert_int_equal(t.pass_count, passes);
    for (size_t p = 0; p < passes; p++) {
        assert_near(t.passes[p].ms[AOB_CLOCK_CPU], pass_ms, 1e-9);
        assert_near(t.pass_to_fixed[p].ratio, 1, 1e-9);
    }
}

static void test_exact_clock(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("null");
    struct aob_rig rig;
    struct aob_screen screen;
    struct aob_frame *frames = AOB_NEW_ARRAY(struct aob_frame, 3);
    struct aob_round_list rounds = {0};
    aob_rig_scene(&rig, "corner", NULL, W, H, 0);
    assert_true(aob_screen_init(&screen, gpu, &rig.gbuffer, &(struct aob_options){0}, NULL));
    init(&frames[0], &screen, &aob_technique_fixed_pass);
    init(&frames[1], &screen, builtin("none"));
    init(&frames[2], &screen, builtin("gtao")); /* horizon, and two passes of the blur */
    struct aob_frame *const cases[] = {&frames[1], &frames[2]};
    assert_true(aob_timing_run(&(struct aob_timing_desc){.fixed = &frames[0],
                                                         .frames = cases,
                                                         .frame_count = 2,
                                                         .seconds = 30,
                                                         .precision = 0.03,
                                                         .seed = 7},
                               &rounds, NULL));
    const double pass_ms = W * H * 100e-6;
    check_case(&rounds, AOB_SLOT_FIXED, 1, pass_ms);
    check_case(&rounds, AOB_SLOT_CONTROL, 1, pass_ms);
    check_case(&rounds, AOB_SLOT_CASES, 1, pass_ms);
    check_case(&rounds, AOB_SLOT_CASES + 1, 3, pass_ms);
    aob_rounds_finish(&rounds);
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
