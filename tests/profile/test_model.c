/* The device model: each resource by hand, how they combine, and how times move with what a pass does and what a device
 * can. */
#include <math.h>
#include "check.h"
#include "profile/model.h"
#include "streams.h"

/* Two levels in front of memory. In a millisecond: 1e9 operations of lanes, .25e9 special ones, 2e8 texels, 6.4e9 bytes
 * into the first level, 1e8 bytes from memory, 1e7 pixels. */
static struct aob_profile device(void)
{
    return (struct aob_profile){.level_count = 2,
                                .levels = {{.name = "L1", .fill = 64, .ports = 100}, {.name = "L2"}},
                                .rates = {.clock = 1,
                                          .alu_clock = 2,
                                          .lanes = 500,
                                          .special = 0.25,
                                          .texture_units = 200,
                                          .tags = 4,
                                          .point_64 = 2,
                                          .rops = 10,
                                          .memory = 100}};
}

/* 1, .5, .25, .125 ms and the like, each resource another. */
static struct aob_model_input work(void)
{
    return (struct aob_model_input){.operations = {.alu = 1e9, .special = 0.1e9, .image = 12345},
                                    .issue = {.least = 100000000, .banked = 120000000, .most = 200000000},
                                    .filled = {{1.6e9, 3.2e9}, {1e7, 3e7}},
                                    .written = 1e7,
                                    .pixels = 1e6};
}

static struct aob_model_time run(const struct aob_profile *profile, const struct aob_model_input *input)
{
    return aob_model_pass(profile, input);
}

static void test_resources(void **state)
{
    (void)state;
    struct aob_profile profile = device();
    struct aob_model_input input = work();
    struct aob_model_time m = run(&profile, &input);
    assert_near(m.resources[AOB_RESOURCE_ALU], 1, 1e-12);
    assert_near(m.resources[AOB_RESOURCE_TEXTURE], 0.6, 1e-12);
    assert_near(m.resources[AOB_RESOURCE_FILL], 0.375, 1e-12);
    assert_near(m.resources[AOB_RESOURCE_FILL + 1], 0, 0);
    assert_near(m.resources[AOB_RESOURCE_MEMORY], 0.3, 1e-12);
    assert_near(m.resources[AOB_RESOURCE_TARGETS], 0.1, 1e-12);
    assert_near(m.launch_ms, 0, 0);
    assert_near(m.ms, sqrt(1 + 0.36 + 0.140625 + 0.09 + 0.01), 1e-12);
    assert_near(m.low_ms, 1, 1e-12);                        /* the largest of 1, .5, .25, .2 and .1 */
    assert_near(m.high_ms, 1 + 1 + 0.5 + 0.4 + 0.1, 1e-12); /* the sum of the upper ends */
    profile.rates.launch = 250;
    struct aob_model_time later = run(&profile, &input);
    assert_near(later.launch_ms, 0.25, 1e-12);
    assert_near(later.ms, m.ms + 0.25, 1e-12);
    assert_near(later.low_ms, m.low_ms + 0.25, 1e-12);
    assert_near(later.high_ms, m.high_ms + 0.25, 1e-12);
}

/* Beside the lanes the slower of the two counts; where it holds them up, the sum. */
static void test_special(void **state)
{
    (void)state;
    struct aob_profile profile = device();
    struct aob_model_input input = {.operations = {.alu = 1e9, .special = 0.1e9}};
    assert_near(run(&profile, &input).resources[AOB_RESOURCE_ALU], 1, 1e-12);
    profile.rates.special_blocks = true;
    assert_near(run(&profile, &input).resources[AOB_RESOURCE_ALU], 1.4, 1e-12);
    input.operations.special = 0.5e9;
    assert_near(run(&profile, &input).resources[AOB_RESOURCE_ALU], 3, 1e-12);
    profile.rates.special_blocks = false;
    assert_near(run(&profile, &input).resources[AOB_RESOURCE_ALU], 2, 1e-12);
}

/* Fills that are fewer with many warps in flight, as they may be, still have the lower end below. */
static void test_turned_band(void **state)
{
    (void)state;
    struct aob_profile profile = device();
    struct aob_model_input input = {.filled = {{3.2e9, 1.6e9}, {1e7, 3e7}}};
    struct aob_model_time m = run(&profile, &input);
    assert_near(m.low_ms, 0.25, 1e-12);
    assert_near(m.high_ms, 0.8, 1e-12);
    assert_near(m.ms, hypot(0.375, 0.2), 1e-12);
}

/* The rates that a resource hangs on, and what a pass asks of it: alone it makes the whole time, which is halved and
 * doubled with them. */
struct single {
    const char *name;
    size_t rate, other; /* offsets into aob_rates; the second one may be the first */
    struct aob_model_input input;
};
#define RATE(name) offsetof(struct aob_rates, name)
static const struct single singles[] = {
    {"alu", RATE(alu_clock), RATE(lanes), {.operations = {.alu = 3e9}}},
    {"alu", RATE(special), RATE(lanes), {.operations = {.special = 3e9}}},
    {"texture", RATE(clock), RATE(texture_units), {.issue = {3000000, 3000000, 3000000}}},
    {"L1", RATE(clock), RATE(clock), {.filled = {{5e9, 5e9}}}},
    {"memory", RATE(memory), RATE(memory), {.filled = {{0, 0}, {2e8, 2e8}}}},
    {"memory", RATE(memory), RATE(memory), {.written = 3e8}},
    {"targets", RATE(clock), RATE(rops), {.pixels = 3e7}},
};

static void scale(struct aob_model_input *input, double by)
{
    struct aob_operations *operations = &input->operations;
    operations->alu *= by;
    operations->special *= by;
    input->issue.least = (uint64_t)((double)input->issue.least * by);
    input->issue.banked = (uint64_t)((double)input->issue.banked * by);
    input->issue.most = (uint64_t)((double)input->issue.most * by);
    for (int l = 0; l < AOB_PROFILE_MAX_LEVEL; l++)
        for (int f = 0; f < AOB_FLIGHT_COUNT; f++)
            input->filled[l][f] *= by;
    input->written *= by;
    input->pixels *= by;
}

static void test_single(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(singles); i++) {
        const struct single *single = &singles[i];
        struct aob_profile profile = device();
        struct aob_model_input input = single->input;
        struct aob_model_time m = run(&profile, &input);
        assert_string_equal(aob_model_resource_name(&profile, aob_model_limit(&m)), single->name);
        assert_true(m.ms > 0);
        assert_near(m.low_ms, m.ms, 1e-12);
        assert_near(m.high_ms, m.ms, 1e-12);
        scale(&input, 2);
        assert_near(run(&profile, &input).ms, 2 * m.ms, 1e-9 * m.ms);
        *(double *)(void *)((char *)&profile.rates + single->rate) *= 2;
        assert_near(run(&profile, &input).ms, m.ms, 1e-9 * m.ms);
        *(double *)(void *)((char *)&profile.rates + single->other) *= 2;
        assert_near(run(&profile, &input).ms, m.ms / 2, 1e-9 * m.ms);
    }
}

/* Ports and bytes of a level count alike. */
static void test_ports(void **state)
{
    (void)state;
    struct aob_profile profile = device();
    struct aob_model_input input = {.filled = {{6.4e9, 6.4e9}}};
    assert_near(run(&profile, &input).ms, 1, 1e-12);
    profile.levels[0].ports *= 2;
    assert_near(run(&profile, &input).ms, 0.5, 1e-12);
    profile.levels[0].fill *= 4;
    assert_near(run(&profile, &input).ms, 0.125, 1e-12);
}

/* Each number of the input, one after the other; adding to it never makes a pass cheaper, nor turns the band. */
static void raise(struct aob_model_input *input, int which, double by)
{
    double *const numbers[] = {
        &input->operations.alu, &input->operations.special, &input->filled[0][0], &input->filled[0][1],
        &input->filled[1][0],   &input->filled[1][1],       &input->written,      &input->pixels};
    if (which < (int)AOB_COUNT(numbers))
        *numbers[which] += by;
    else
        input->issue.banked += (uint64_t)by / 100;
    input->issue.most += (uint64_t)by / 100;
}

static void test_monotone(void **state)
{
    (void)state;
    uint32_t seed = 7;
    for (int round = 0; round < 2000; round++) {
        struct aob_profile profile = device();
        struct aob_model_input input = {0};
        profile.rates.special_blocks = round % 2;
        for (int i = 0; i < 9; i++)
            raise(&input, i, (double)random_below(&seed, 1000000) * 1e3);
        struct aob_model_time before = run(&profile, &input);
        assert_true(before.low_ms <= before.ms && before.ms <= before.high_ms);
        raise(&input, round % 9, 1e6);
        struct aob_model_time after = run(&profile, &input);
        assert_true(after.ms >= before.ms && after.low_ms >= before.low_ms &&
                    after.high_ms >= before.high_ms);
        profile.rates.clock *= 2;
        assert_true(run(&profile, &input).ms <= after.ms);
        profile.rates.memory *= 2;
        assert_true(run(&profile, &input).ms <= after.ms);
        assert_true(run(&profile, &input).ms >= after.ms / 2);
    }
}

/* A frame is its passes one after the other, and its limit is that of the sums. */
static void test_frame(void **state)
{
    (void)state;
    struct aob_profile profile = device();
    profile.rates.launch = 125;
    struct aob_model_input alu = {.operations = {.alu = 2e9}}, memory = {.written = 1.5e8};
    struct aob_model_time frame = {0}, a = run(&profile, &alu), m = run(&profile, &memory);
    aob_model_add(&frame, &a);
    aob_model_add(&frame, &m);
    assert_near(frame.ms, 3.75, 1e-12);
    assert_near(frame.low_ms, 3.75, 1e-12);
    assert_near(frame.high_ms, 3.75, 1e-12);
    assert_near(frame.launch_ms, 0.25, 1e-12);
    assert_int_equal(aob_model_limit(&frame), AOB_RESOURCE_ALU);
    aob_model_add(&frame, &m);
    assert_int_equal(aob_model_limit(&frame), AOB_RESOURCE_MEMORY);
    assert_null(aob_model_resource_name(&profile, (enum aob_resource)(AOB_RESOURCE_FILL + 1)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_resources), cmocka_unit_test(test_special), cmocka_unit_test(test_turned_band),
        cmocka_unit_test(test_single),    cmocka_unit_test(test_ports),   cmocka_unit_test(test_monotone),
        cmocka_unit_test(test_frame),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
