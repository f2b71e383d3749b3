#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "script.h"
#include "timing/summary.h"

/* The rules of processes.h on scripted processes. A round of the three cases takes 40 ms of wall time where a frame of each
 * takes 4 ms of processor time (script.h): 3 x 8 ms, and 2 x 2 frames of the fixed pass at 4 ms. */

static bool measure(struct script_processes *processes, struct aob_processes_desc desc,
                    struct aob_processes *result, struct aob_error *error)
{
    processes->precision = desc.precision;
    desc.case_count = processes->case_count ? processes->case_count : SCRIPT_CASES;
    desc.run = script_process;
    desc.on_lost = script_lost;
    desc.user = processes;
    return aob_processes_run(&desc, result, error);
}

/* The figures of SplitMix64's authors begin with e220a8397b1dcdaf for the state 0. */
static void test_seeds(void **state)
{
    (void)state;
    assert_int_equal(aob_process_seed(0, 0), 0xe220a839);
    assert_int_equal(aob_process_seed(7, 0), 0xbcda4680);
    assert_int_equal(aob_process_seed(7, 1), 0x1a3eaa3c);
    assert_int_equal(aob_process_seed(7, 2), 0xa70ed1d4);
}

/* Nothing scatters: three processes of twenty rounds are enough, whatever the time. */
static void test_three_are_enough(void **state)
{
    (void)state;
    struct script_processes processes = {0};
    struct aob_processes result;
    assert_true(measure(&processes, (struct aob_processes_desc){.seconds = 60, .precision = 0.03, .seed = 7},
                        &result, NULL));
    assert_int_equal(processes.count, 3);
    assert_int_equal(result.good, 3);
    assert_int_equal(result.lost, 0);
    assert_int_equal(result.rounds.count, 60);
    assert_near(result.measured_s, 60 * 0.040, 1e-6);
    for (int p = 0; p < 3; p++) {
        assert_int_equal(processes.asked[p].index, p);
        assert_int_equal(processes.asked[p].seed, aob_process_seed(7, p));
        assert_int_equal(result.rounds.items[20 * p].process, p);
        assert_int_equal(result.rounds.items[20 * p].seed, aob_process_seed(7, p));
    }
    aob_processes_finish(&result);
}

/* A caller that wants more of them gets them, however early the precision is reached; never fewer than three. */
static void test_at_least(void **state)
{
    (void)state;
    static const int wanted[][2] = {{5, 5}, {2, 3}};
    for (size_t i = 0; i < AOB_COUNT(wanted); i++) {
        struct script_processes processes = {0};
        struct aob_processes result;
        const struct aob_processes_desc desc = {
            .least = wanted[i][0], .seconds = 60, .precision = 0.03, .seed = 7};
        assert_true(measure(&processes, desc, &result, NULL));
        assert_int_equal(result.good, wanted[i][1]);
        aob_processes_finish(&result);
    }
}

static void test_slices(void **state)
{
    (void)state;
    static const double rows[][2] = {{0.5, 0.5 / 3}, {1.5, 0.5}, {3, 1}, {9, 1}, {100, 1}, {200, 2}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct aob_processes_desc desc = {.seconds = rows[i][0], .seed = 7};
        struct aob_process_desc process = aob_process_describe(&desc, 2);
        assert_near(process.seconds, rows[i][1], 1e-12);
        assert_int_equal(process.index, 2);
        assert_int_equal(process.seed, aob_process_seed(7, 2));
    }
}

/* No round of a process differs from another, but processes do by 20 %: every process believes that it is precise after 20
 * rounds, and is not. */
static double of_process(const struct script *s, int index, int round)
{
    (void)index;
    (void)round;
    return s->process % 2 ? 4.4 : 3.6;
}

/* Twenty rounds take .752 or .848 s in turn. 4.5 s for the block are over in the sixth (4.8), 9 s in the twelfth (9.6). */
static void test_seconds_buy_processes(void **state)
{
    (void)state;
    static const struct {
        double seconds; /* a case */
        int processes;
    } rows[] = {{0.9, 4}, {1.5, 6}, {3, 12}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script_processes processes = {.cpu_ms = of_process};
        struct aob_processes result;
        assert_true(measure(&processes,
                            (struct aob_processes_desc){.seconds = rows[i].seconds, .precision = 0.03},
                            &result, NULL));
        assert_int_equal(result.good, rows[i].processes);
        assert_near(result.measured_s, 0.8 * rows[i].processes, 1e-6);
        aob_processes_finish(&result);
    }
}

static double of_round(const struct script *s, int index, int round)
{
    (void)s;
    return index == 2 ? (round % 2 ? 3 : 5) : 4;
}

/* One case that stays wide, in every process: the three slices are all of the seconds, each but for a round. */
static void test_seconds_bound(void **state)
{
    (void)state;
    struct script_processes processes = {.cpu_ms = of_round};
    struct aob_processes result;
    assert_true(
        measure(&processes, (struct aob_processes_desc){.seconds = 0.3, .precision = 0.03}, &result, NULL));
    assert_int_equal(result.good, 3);
    assert_true(result.measured_s >= 0.9 && result.measured_s < 0.9 + 3 * 0.05);
    aob_processes_finish(&result);
}

/* What a lost process added is dropped, and another takes its place. */
static void test_one_is_lost(void **state)
{
    (void)state;
    static const char *const fates[] = {".x", ".0", ".?"};
    static const char *const told[] = {"1: it crashed; ", "1: it gave no rounds; ",
                                       "1: it gave rounds of another block; "};
    for (size_t i = 0; i < AOB_COUNT(fates); i++) {
        struct script_processes processes = {.fate = fates[i]};
        struct aob_processes result;
        struct aob_error error = {{0}};
        assert_true(measure(&processes, (struct aob_processes_desc){.seconds = 60, .precision = 0.03},
                            &result, &error));
        assert_int_equal(processes.count, 4);
        assert_int_equal(result.good, 3);
        assert_int_equal(result.lost, 1);
        assert_int_equal(result.rounds.count, 60);
        assert_int_equal(result.rounds.items[0].process, 0);
        assert_int_equal(result.rounds.items[20].process, 2);
        assert_int_equal(result.rounds.items[40].process, 3);
        assert_near(result.measured_s, 60 * 0.040, 1e-6);
        assert_string_equal(processes.told, told[i]);
        assert_string_equal(error.text, "");
        aob_processes_finish(&result);
    }
}

/* The second loss ends it; what three good ones have measured stands. */
static void test_two_are_lost(void **state)
{
    (void)state;
    static const struct {
        const char *fate;
        bool ok;
        int asked, good;
    } rows[] = {{"xx", false, 2, 0}, {".x.x", false, 4, 2}, {"...x.x", true, 6, 4}, {"x...x", true, 5, 3}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script_processes processes = {.fate = rows[i].fate, .cpu_ms = of_process};
        struct aob_processes result;
        struct aob_error error = {{0}};
        bool ok = measure(&processes, (struct aob_processes_desc){.seconds = 60, .precision = 0.03}, &result,
                          &error);
        assert_int_equal(ok, rows[i].ok);
        assert_int_equal(processes.count, rows[i].asked);
        assert_int_equal(result.good, rows[i].good);
        assert_int_equal(result.lost, 2);
        assert_string_equal(error.text, ok ? "" : "it crashed");
        aob_processes_finish(&result);
    }
}

/* Processes that differ for ever end at the hundredth. */
static void test_most(void **state)
{
    (void)state;
    struct script_processes processes = {.cpu_ms = of_process};
    struct aob_processes result;
    assert_true(
        measure(&processes, (struct aob_processes_desc){.seconds = 3600, .precision = 0.005}, &result, NULL));
    assert_int_equal(result.good, AOB_PROCESSES_MOST);
    aob_processes_finish(&result);
}

/* Every case must be precise, and the control is none of them. */
static double last_differs(const struct script *s, int index, int round)
{
    (void)round;
    return index == 2 && s->process % 2 ? 4.4 : 4;
}

static void test_every_case_counts(void **state)
{
    (void)state;
    for (size_t count = 2; count <= 3; count++) {
        struct script_processes processes = {.cpu_ms = last_differs, .case_count = count};
        struct aob_processes result;
        assert_true(
            measure(&processes, (struct aob_processes_desc){.seconds = 3, .precision = 0.03}, &result, NULL));
        if (count == 2)
            assert_int_equal(result.good, 3);
        else
            assert_true(result.good > 3);
        aob_processes_finish(&result);
    }
}

static void test_seconds_needed(void **state)
{
    (void)state;
    assert_near(aob_seconds_needed(1.5, 0.06, 0.03), 6, 1e-12);
    assert_near(aob_seconds_needed(2, 0.045, 0.03), 4.5, 1e-12);
    assert_true(isnan(aob_seconds_needed(1.5, 0.03, 0.03)));
    assert_true(isnan(aob_seconds_needed(1.5, 0.01, 0.03)));
    assert_true(isnan(aob_seconds_needed(1.5, INFINITY, 0.03)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_seeds),
                                       cmocka_unit_test(test_three_are_enough),
                                       cmocka_unit_test(test_at_least),
                                       cmocka_unit_test(test_slices),
                                       cmocka_unit_test(test_seconds_buy_processes),
                                       cmocka_unit_test(test_seconds_bound),
                                       cmocka_unit_test(test_one_is_lost),
                                       cmocka_unit_test(test_two_are_lost),
                                       cmocka_unit_test(test_most),
                                       cmocka_unit_test(test_every_case_counts),
                                       cmocka_unit_test(test_seconds_needed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
