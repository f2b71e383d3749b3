/* The test of a device's clock on each backend: test_clock vulkan|gl-egl|gl-osmesa|null. How good a clock is depends on the
 * machine's load, so of one that may be good only what always holds is asked for. */
#include "made.h"
#include "rig.h"
#include "timing/timer.h"

static const struct aob_timer_check *check_of(const struct aob_timer *timer, const char *what)
{
    for (size_t i = 0; i < AOB_TIMER_CHECKS; i++)
        if (!strcmp(timer->checks[i].what, what))
            return &timer->checks[i];
    fail_msg("no check '%s'", what);
    return NULL;
}

static void a_clock_is_known_by_its_test(void **state)
{
    struct aob_gpu *plain = *state;
    const struct aob_gpu_desc desc = {.validate = !strcmp(plain->info.backend, "vulkan"), .as_gpu = true};
    struct aob_gpu *gpu = aob_gpu_open(plain->info.backend, &desc, NULL);
    struct aob_error error = {""};
    struct aob_timer timer;
    assert_non_null(gpu);
    assert_true(gpu->info.timer);
    if (!aob_timer_test(gpu, &timer, &error))
        fail_msg("%s", error.text);
    for (size_t i = 0; i < AOB_TIMER_CHECKS; i++)
        printf("%s: %g (%g .. %g)\n", timer.checks[i].what, timer.checks[i].measured, timer.checks[i].low,
               timer.checks[i].high);
    printf("pass of %.3f ms: %s\n", timer.pass_ms, timer.trusted ? "trusted" : timer.why_not);
    if (strstr(gpu->info.device, "llvmpipe") && strstr(gpu->info.backend, "gl-")) {
        assert_false(timer.trusted);
        assert_contains(timer.why_not, "its clock says ");
        /* Single passes are right by luck: nothing is under way when their begin is stamped. */
        assert_true(check_of(&timer, "repeats of a pass, as a share of the host's time")->measured < 0.5);
    } else {
        double share = check_of(&timer, "a pass, as a share of the host's time")->measured;
        double sum = check_of(&timer, "the passes of a list, as a share of the list")->measured;
        assert_true(share > 0 && share <= 1.02);
        assert_true(sum > 0 && sum <= 1.02);
    }
    if (gpu->info.draws_nothing)
        assert_true(timer.trusted);
    aob_gpu_close(gpu);
}

static void a_device_without_lists_is_refused(void **state)
{
    struct aob_error error = {""};
    struct aob_timer timer;
    struct aob_gpu *gpu = *state;
    if (gpu->lists)
        return;
    assert_false(aob_timer_test(gpu, &timer, &error));
    assert_contains(error.text, "needs a device that runs lists");
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_clock_is_known_by_its_test),
        cmocka_unit_test(a_device_without_lists_is_refused),
    };
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
