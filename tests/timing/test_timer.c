/* Clocks that lie, on a device that draws nothing and whose host's clock is scripted. */
#include "check.h"
#include <stdlib.h>
#include <string.h>
#include "gpu/backends.h"
#include "random.h"
#include "timing/timer.h"

/* What a pass's true time becomes. A pass and the whole list go through the same hands. */
static int64_t (*tell)(int64_t ns);
static uint32_t seed; /* of the load; 0: none */
static bool unfair;
static int64_t way_ns; /* to the device and back */
static bool late;      /* each pass is told the time of the one before it */
static int64_t
    ends_ns; /* the host's clock stands still once the device has worked for so long; 0: it does not */
static int runs;
static int64_t late_ns;

/* A device that takes eight times as long until it has worked for 250 ms, and whose passes are as long as their loops; 0: it
 * does not. */
static int64_t rises_ns, worked_ns;
static int trips;
static bool (*make_program)(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                            struct aob_gpu_program **program, struct aob_error *error);

static bool count_trips(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                        struct aob_gpu_program **program, struct aob_error *error)
{
    const char *loop = strstr(desc->fragment, "i < ");
    assert_non_null(loop);
    trips = atoi(loop + 4);
    return make_program(gpu, desc, program, error);
}

/* 26 ms of the smallest pass are 32768 trips. */
static double speed_of(void)
{
    return rises_ns ? trips / 32768.0 * (worked_ns < rises_ns ? 8 : 1) : 1;
}

static int64_t truth(int64_t ns)
{
    return ns;
}

static int64_t half(int64_t ns)
{
    return ns / 2;
}

static int64_t constant(int64_t ns)
{
    (void)ns;
    return 26214400; /* the smallest pass: right for one of them */
}

static int64_t microseconds(int64_t ns)
{
    return ns / 1000;
}

static int64_t ticks(int64_t ns)
{
    return ns * 3 / 125; /* 24 MHz, of which the driver says that a tick is 1 ns */
}

static int64_t nothing(int64_t ns)
{
    (void)ns;
    return 0;
}

static int64_t rounded(int64_t ns)
{
    return (ns + 50000000) / 100000000 * 100000000; /* it ticks ten times a second */
}

/* As llvmpipe's: of 64 x 64 texels, whatever the pass draws. */
static int64_t last_tile(int64_t ns)
{
    (void)ns;
    return 64 * 64 * 100;
}

static bool run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                struct aob_gpu_time *whole, struct aob_error *error)
{
    if (!aob_gpu_null.run(gpu, desc, times, whole, error))
        return false;
    /* A neighbour that takes a processor makes three submits of ten up to three times as long, on both clocks. */
    double load = seed && random_unit(&seed) < 0.3 ? 1 + 2 * random_unit(&seed) : 1;
    if (unfair && whole->wall_ns > 40000000) /* what is short gets through between the neighbour's turns */
        load *= 2;
    load *= speed_of();
    worked_ns += (int64_t)((double)whole->wall_ns * load);
    whole->wall_ns = (int64_t)((double)whole->wall_ns * load) + way_ns;
    if (ends_ns && worked_ns > ends_ns)
        whole->wall_ns = 0;
    if (++runs > 10000)
        fail_msg("%s", "the test of a clock has no end");
    whole->device_ns = 0;
    for (size_t i = 0; i < desc->count; i++) {
        int64_t ns = tell((int64_t)((double)times[i].device_ns * load));
        times[i].device_ns = late ? late_ns : ns;
        late_ns = ns;
        whole->device_ns += ns;
    }
    return true;
}

static struct aob_gpu *open_scripted(struct aob_gpu_fns *fns)
{
    struct aob_gpu *gpu = aob_gpu_open("null", &(struct aob_gpu_desc){.as_gpu = true}, NULL);
    *fns = aob_gpu_null;
    make_program = fns->program_create;
    fns->run = run;
    fns->program_create = count_trips;
    gpu->fns = fns;
    return gpu;
}

static void close_scripted(struct aob_gpu *gpu)
{
    gpu->fns = &aob_gpu_null;
    aob_gpu_close(gpu);
}

static struct aob_timer test_clock(int64_t (*teller)(int64_t ns))
{
    struct aob_gpu_fns fns;
    struct aob_gpu *gpu = open_scripted(&fns);
    struct aob_timer timer;
    struct aob_error error = {""};
    tell = teller;
    if (!aob_timer_test(gpu, &timer, &error))
        fail_msg("%s", error.text);
    close_scripted(gpu);
    return timer;
}

static void expect_liar(int64_t (*teller)(int64_t ns), const char *why)
{
    struct aob_timer timer = test_clock(teller);
    assert_false(timer.trusted);
    assert_contains(timer.why_not, why);
}

static void test_a_true_clock_is_trusted(void **state)
{
    (void)state;
    struct aob_timer timer = test_clock(truth);
    const double expected[AOB_TIMER_CHECKS] = {2, 4, 2, 4, 1, 1, 1};
    assert_true(timer.trusted);
    assert_string_equal(timer.why_not, "");
    for (size_t i = 0; i < AOB_TIMER_CHECKS; i++) {
        assert_near(timer.checks[i].expected, expected[i], 0);
        assert_near(timer.checks[i].measured, expected[i], 1e-6);
        assert_true(timer.checks[i].low < expected[i] && timer.checks[i].high > expected[i]);
    }
    assert_near(timer.pass_ms, 1024 * 256 * 100e-6, 1e-9);
}

/* Where each submit is late, and neighbours take the processor: on twenty scripts. */
static void test_a_true_clock_is_trusted_under_load(void **state)
{
    (void)state;
    way_ns = 2000000;
    for (uint32_t script = 1; script <= 20; script++) {
        seed = script * 2654435761u;
        unfair = script % 2;
        struct aob_timer timer = test_clock(truth);
        if (!timer.trusted)
            fail_msg("script %u: %s", script, timer.why_not);
    }
    seed = 0;
    unfair = false;
    way_ns = 0;
}

static void test_liars_are_found(void **state)
{
    (void)state;
    expect_liar(half, "its clock says 0.5 of a pass, as a share of the host's time");
    expect_liar(constant, "its clock says 1 of twice the area, which is 2 and may read 1.6 to 2.5");
    expect_liar(last_tile, "its clock says 1 of twice the area");
    expect_liar(microseconds, "its clock says 0.001 of a pass");
    expect_liar(ticks, "its clock says 0.024 of a pass");
    expect_liar(nothing, "its clock says nan of twice the area");
    expect_liar(rounded, "of twice the area");
}

/* The whole is right, the passes are not. */
static void test_a_clock_that_is_one_pass_late_is_found(void **state)
{
    (void)state;
    late = true;
    expect_liar(truth, "");
    late = false;
}

static int64_t seven_eighths(int64_t ns)
{
    return ns / 8 * 7;
}

static int64_t three_quarters(int64_t ns)
{
    return ns / 4 * 3;
}

static int64_t a_twentieth_more(int64_t ns)
{
    return ns / 20 * 21;
}

/* The rest may be the way to a device and back; no device is at work for longer than the host waits. */
static void test_how_much_a_clock_may_miss(void **state)
{
    (void)state;
    assert_true(test_clock(seven_eighths).trusted);
    expect_liar(three_quarters, "its clock says 0.75 of a pass, as a share of the host's time");
    expect_liar(a_twentieth_more, "its clock says 1.05 of a pass, as a share of the host's time");
}

/* The way there and back takes .4 ms: of a pass of 4 ms little, of one that was 4 ms before the device woke up nearly all. */
static void test_a_device_that_wakes_up_is_trusted(void **state)
{
    (void)state;
    rises_ns = 250000000;
    worked_ns = 0;
    way_ns = 400000;
    struct aob_timer timer = test_clock(truth);
    if (!timer.trusted)
        fail_msg("%s", timer.why_not);
    assert_true(timer.pass_ms >= 4 && timer.pass_ms < 17);
    rises_ns = way_ns = 0;
}

/* From the first submit on, and while the device is loaded. */
static void test_a_host_whose_clock_stands_still(void **state)
{
    (void)state;
    static const int64_t ends[] = {1, 200000000};
    for (size_t i = 0; i < sizeof ends / sizeof *ends; i++) {
        struct aob_gpu_fns fns;
        struct aob_gpu *gpu = open_scripted(&fns);
        struct aob_timer timer;
        struct aob_error error = {""};
        tell = truth;
        worked_ns = runs = 0;
        ends_ns = ends[i];
        assert_false(aob_timer_test(gpu, &timer, &error));
        assert_contains(error.text, "test of the device's clock: the host's clock stands still: it saw 0 ns");
        close_scripted(gpu);
    }
    ends_ns = 0;
}

static struct aob_timer_choice choose(bool software, int64_t (*teller)(int64_t ns))
{
    struct aob_gpu_fns fns;
    struct aob_gpu *gpu = open_scripted(&fns);
    struct aob_timer_choice choice;
    tell = teller;
    gpu->info.software = software;
    assert_true(aob_timer_choose(gpu, &choice, NULL));
    close_scripted(gpu);
    return choice;
}

/* A processor's cost is its own time, whatever its timestamps say. */
static void test_whose_time_costs_are(void **state)
{
    (void)state;
    struct aob_timer_choice cpu = choose(true, half), device = choose(false, truth),
                            wall = choose(false, half);
    assert_int_equal(cpu.clock, AOB_CLOCK_CPU);
    assert_string_equal(cpu.reason, "");
    assert_int_equal(device.clock, AOB_CLOCK_DEVICE);
    assert_string_equal(device.reason, "");
    assert_int_equal(wall.clock, AOB_CLOCK_WALL);
    assert_contains(wall.reason, "its clock says 0.5 of a pass, as a share of the host's time");
}

static void test_no_clock(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_gpu_open("null", &(struct aob_gpu_desc){.as_gpu = true}, NULL);
    struct aob_timer timer;
    gpu->info.timer = false;
    assert_true(aob_timer_test(gpu, &timer, NULL));
    assert_false(timer.trusted);
    assert_string_equal(timer.why_not, "it has no clock that programs can read");
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_true_clock_is_trusted),
        cmocka_unit_test(test_a_true_clock_is_trusted_under_load),
        cmocka_unit_test(test_liars_are_found),
        cmocka_unit_test(test_a_clock_that_is_one_pass_late_is_found),
        cmocka_unit_test(test_how_much_a_clock_may_miss),
        cmocka_unit_test(test_a_device_that_wakes_up_is_trusted),
        cmocka_unit_test(test_a_host_whose_clock_stands_still),
        cmocka_unit_test(test_whose_time_costs_are),
        cmocka_unit_test(test_no_clock),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
