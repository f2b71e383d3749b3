#include "check.h"
#include <math.h>
#include "base/memory.h"
#include "timing/summary.h"

enum { PROCESSES = 3, ROUNDS = 6 };

/* Rounds of one case with two passes: the frame takes 8 ms, the fixed pass 4; of the passes only what the caller says. */
static struct aob_round_list make_rounds(int64_t (*pass_ns)(int process, int round, int pass))
{
    struct aob_round_list list = {0};
    for (int i = 0; i < PROCESSES * ROUNDS; i++) {
        struct aob_round *round = AOB_PUSH(list.items, list.count, list.capacity);
        *round = (struct aob_round){.process = i / ROUNDS,
                                    .number = i % ROUNDS,
                                    .clock = AOB_CLOCK_DEVICE,
                                    .slot_count = AOB_SLOT_CASES + 1};
        for (size_t s = 0; s < round->slot_count; s++) {
            struct aob_slot *slot = &round->slots[s];
            *slot = (struct aob_slot){.frames = 1};
            for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++)
                slot->whole.ns[clock] = s < AOB_SLOT_CASES ? 4000000 : 8000000;
            slot->pass_count = s < AOB_SLOT_CASES ? 1 : 2;
            for (size_t p = 0; p < slot->pass_count; p++)
                slot->passes[p] =
                    (struct aob_spent){{[AOB_CLOCK_CPU] = AOB_NO_TIME,
                                        [AOB_CLOCK_WALL] = AOB_NO_TIME,
                                        [AOB_CLOCK_DEVICE] = pass_ns(i / ROUNDS, i % ROUNDS, (int)p)}};
        }
    }
    return list;
}

/* The first pass is a quarter of the frame; the second is too short for its clock, but for one round of each process. */
static int64_t seldom(int process, int round, int pass)
{
    if (pass == 0)
        return 2000000;
    return round == process ? 1000 : AOB_NO_TIME;
}

static int64_t never(int process, int round, int pass)
{
    (void)process;
    (void)round;
    return pass == 0 ? 2000000 : AOB_NO_TIME;
}

static void test_a_pass_that_is_seldom_timed(void **state)
{
    (void)state;
    struct aob_round_list rounds = make_rounds(seldom);
    struct aob_summary summary;
    aob_summarise(&rounds, AOB_SLOT_CASES, &summary);
    assert_true(fabs(summary.to_fixed.ratio - 2) < 1e-12 && summary.processes == PROCESSES);
    assert_true(fabs(summary.pass_to_fixed[0].ratio - 0.5) < 1e-12 && summary.pass_to_fixed[0].bounded);
    assert_true(fabs(summary.pass_to_fixed[1].ratio - 0.00025) < 1e-12 && !summary.pass_to_fixed[1].bounded);
    assert_true(fabs(summary.passes[1].ms[AOB_CLOCK_DEVICE] - 0.001) < 1e-12);
    aob_rounds_finish(&rounds);
}

/* The host's clocks know no pass of a submit that holds a whole frame. */
static void test_a_pass_without_a_time(void **state)
{
    (void)state;
    struct aob_round_list rounds = make_rounds(never);
    struct aob_summary summary;
    aob_summarise(&rounds, AOB_SLOT_CASES, &summary);
    assert_true(isnan(summary.pass_to_fixed[1].ratio) && !summary.pass_to_fixed[1].bounded);
    assert_true(isnan(summary.passes[1].ms[AOB_CLOCK_DEVICE]) && isnan(summary.passes[0].ms[AOB_CLOCK_CPU]));
    assert_true(fabs(summary.to_fixed.ratio - 2) < 1e-12 &&
                fabs(summary.whole.ms[AOB_CLOCK_CPU] - 8) < 1e-12);
    aob_rounds_finish(&rounds);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_pass_that_is_seldom_timed),
                                       cmocka_unit_test(test_a_pass_without_a_time)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
