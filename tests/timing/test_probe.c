/* What frames cost before they are timed, on a scripted clock (script.h). */
#include "check.h"
#include "base/memory.h"
#include "script.h"
#include "timing/probe.h"

/* Three cases of 130, 8 and 0.04 ms of wall time on an idle device, and half of that from the third turn on. */
static double waking(const struct script *s, int index, int round)
{
    static const double idle_ms[SCRIPT_CASES] = {130, 8, 0.04};
    (void)round;
    return idle_ms[index] / (s->runs[index] < 2 ? 1 : 2);
}

static void probe(struct script *s, enum aob_clock clock, double cost_ms[AOB_BLOCK_MAX])
{
    const struct aob_timing_source source = script_source(s);
    const struct aob_timing_desc desc = {
        .frames = s->frames, .frame_count = SCRIPT_CASES, .clock = clock, .source = &source};
    assert_true(aob_probe_costs(&desc, cost_ms, NULL));
}

static void test_a_device_is_loaded_first(void **state)
{
    (void)state;
    struct script *s = script_create();
    double cost_ms[AOB_BLOCK_MAX];
    s->wall_ms = waking;
    probe(s, AOB_CLOCK_WALL, cost_ms);
    /* Turns of 138.04, 140 and 70 ms: the cheapest case fills 2 ms from the second on. */
    static const int repeats[] = {1, 1, 1, 1, 1, 50, 1, 1, 50};
    assert_int_equal(s->count, AOB_COUNT(repeats));
    assert_memory_equal(s->repeats, repeats, sizeof repeats);
    assert_near(cost_ms[0], 65, 1e-9);
    assert_near(cost_ms[1], 4, 1e-9);
    assert_near(cost_ms[2], 0.02, 1e-9);
    script_destroy(s);
}

/* A processor is as fast when it wakes up: one frame each. */
static void test_a_processor_is_not(void **state)
{
    (void)state;
    struct script *s = script_create();
    double cost_ms[AOB_BLOCK_MAX];
    s->wall_ms = waking;
    probe(s, AOB_CLOCK_CPU, cost_ms);
    assert_int_equal(s->count, SCRIPT_CASES);
    for (int i = 0; i < SCRIPT_CASES; i++)
        assert_near(cost_ms[i], 4, 1e-9);
    script_destroy(s);
}

static double nothing(const struct script *s, int index, int round)
{
    (void)s;
    (void)index;
    (void)round;
    return 0;
}

static void expect_refusal(struct script *s, enum aob_clock clock, const char *why)
{
    const struct aob_timing_source source = script_source(s);
    const struct aob_timing_desc desc = {
        .frames = s->frames, .frame_count = SCRIPT_CASES, .clock = clock, .source = &source};
    double cost_ms[AOB_BLOCK_MAX];
    struct aob_error error = {{0}};
    assert_false(aob_probe_costs(&desc, cost_ms, &error));
    assert_contains(error.text, why);
    script_destroy(s);
}

/* Whatever a load lasts by it, it would have no end. */
static void test_a_clock_that_stands_still(void **state)
{
    (void)state;
    static const enum aob_clock clocks[] = {AOB_CLOCK_CPU, AOB_CLOCK_WALL, AOB_CLOCK_DEVICE};
    for (size_t i = 0; i < AOB_COUNT(clocks); i++) {
        struct script *s = script_create();
        s->wall_ms = nothing;
        s->device = true;
        expect_refusal(s, clocks[i], "the host's clock stands still: it saw 0 ns");
    }
}

/* Else each turn would be as many frames as there can be. */
static void test_a_device_that_tells_no_time(void **state)
{
    (void)state;
    expect_refusal(script_create(), AOB_CLOCK_DEVICE, "the device told no time by the device clock");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_device_is_loaded_first), cmocka_unit_test(test_a_processor_is_not),
        cmocka_unit_test(test_a_clock_that_stands_still), cmocka_unit_test(test_a_device_that_tells_no_time)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
