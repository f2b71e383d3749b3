#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "gpu_check/trial.h"
#include "rig.h"
#include "technique/param.h"
#include "technique/registry.h"
#include "timing/fixed_pass.h"
#include "timing/timing.h"

/* The null backend's clocks are exact: 100 ns a texel and target, so a technique of n passes costs n fixed passes. */

enum { W = 64, H = 36 };
static const double pass_ms = 1e-4 * W * H;

static void start_gtao(struct aob_frame *frame, struct aob_screen *screen)
{
    const struct aob_technique *const *t = aob_builtin_techniques;
    double numbers[AOB_MAX_PARAM];
    unsigned char values[4 * AOB_MAX_PARAM] = {0};
    while (strcmp((*t)->name, "gtao") != 0)
        t++;
    aob_param_defaults((*t)->params, (*t)->param_count, 1, numbers);
    aob_param_pack((*t)->params, (*t)->param_count, numbers, values, sizeof values);
    assert_true(aob_frame_init(frame, screen, *t, values, AOB_FETCH_SAMPLED, NULL));
}

static void check_trial(const struct aob_frame *frame, const struct aob_trial *trial)
{
    int passes = frame->graph.pass_count;
    assert_true(passes > 1);
    assert_int_equal(trial->rounds, 20); /* narrow at the first look */
    assert_near(trial->whole.ms, passes * pass_ms, 1e-9);
    assert_near(trial->whole.low, passes * pass_ms, 1e-9);
    assert_near(trial->whole.high, passes * pass_ms, 1e-9);
    assert_near(trial->fixed.ms, pass_ms, 1e-9);
    assert_near(trial->to_fixed.ratio, passes, 1e-9);
    assert_near(trial->control.ratio, 1, 1e-9);
    assert_near(trial->passes_share, 1, 1e-9);
    for (int p = 0; p < passes; p++)
        assert_near(trial->passes[p].ms, pass_ms, 1e-9);
}

/* The host's clocks see each pass only where a submit holds one (gpu/gpu.h), so they are tried on a plain device. */
static void try_clock(const struct aob_rig *rig, enum aob_clock clock)
{
    struct aob_gpu *gpu =
        aob_gpu_open("null", &(struct aob_gpu_desc){.as_gpu = clock == AOB_CLOCK_DEVICE}, NULL);
    struct aob_screen screen;
    struct aob_trial trial;
    struct aob_frame *fixed = AOB_NEW(struct aob_frame), *frame = AOB_NEW(struct aob_frame);
    struct aob_trial_desc desc = {
        .fixed = fixed, .frame = frame, .clock = clock, .seconds = 1000, .precision = 0.01};
    assert_true(aob_screen_init(&screen, gpu, &rig->gbuffer, &(struct aob_options){0}, NULL));
    assert_true(
        aob_frame_init(fixed, &screen, &aob_technique_fixed_pass, &(int32_t){0}, AOB_FETCH_SAMPLED, NULL));
    start_gtao(frame, &screen);
    assert_true(aob_trial_run(&desc, &trial, NULL));
    check_trial(frame, &trial);
    desc.seconds = 0; /* two rounds all the same, and no interval */
    assert_true(aob_trial_run(&desc, &trial, NULL));
    assert_int_equal(trial.rounds, AOB_ROUNDS_LEAST);
    assert_near(trial.whole.ms, frame->graph.pass_count * pass_ms, 1e-9);
    assert_true(isnan(trial.whole.low) && isnan(trial.whole.high) && !trial.to_fixed.bounded);
    aob_frame_finish(frame);
    aob_frame_finish(fixed);
    aob_screen_finish(&screen);
    aob_gpu_close(gpu);
    free(frame);
    free(fixed);
}

static void exact_clocks_give_exact_times(void **state)
{
    struct aob_rig rig;
    (void)state;
    aob_rig_scene(&rig, "corner", "front", W, H, 0);
    try_clock(&rig, AOB_CLOCK_CPU);
    try_clock(&rig, AOB_CLOCK_WALL);
    try_clock(&rig, AOB_CLOCK_DEVICE);
    aob_rig_finish(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(exact_clocks_give_exact_times)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
