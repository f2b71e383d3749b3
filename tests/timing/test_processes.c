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
    static const double rows[][2] = {{0.3, 0.1}, {0.75, 0.25}, {1.5, 0.25}, {9, 0.25}, {25, 0.25}, {200, 2}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        const struct aob_processes_desc desc = {.seconds = rows[i][0], .seed = 7};
        struct aob_process_desc process = aob_process_describe(&desc, 2);
        assert_near(process.seconds, rows[i][1], 1e-12);
        assert_int_equal(process.index, 2);
        assert_int_equal(process.seed, aob_process_seed(7, 2));
    }
}

/* No round of a process differs from another, but processes do by 20 %. */
static double of_process(const struct script *s, int index, int round)
{
    (void)index;
    (void)round;
    return s->process % 2 ? 4.4 : 3.6;
}

/* The three quarters of a second that a process gets are over after 20 rounds of 37.6 ms or 18 of 42.4 ms in turn, which
 * is .752 or .7632 s. 2.7 s for the block are over in the fourth, 4.5 s in the sixth, 9 s in the twelfth. */
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
        assert_near(result.measured_s, (0.752 + 0.7632) / 2 * rows[i].processes, 1e-6);
        aob_processes_finish(&result);
    }
}

/* A round of one case of 80 ms takes .48 s, of which a process has two. Nothing scatters, and still an interval of fewer
 * than twenty rounds is no reason to end before the seconds do. */
static double dear(const struct script *s, int index, int round)
{
    (void)s;
    (void)index;
    (void)round;
    return 80;
}

static void test_too_few_rounds(void **state)
{
    (void)state;
    static const struct {
        double seconds;
        int processes;
    } rows[] = {{60, 10}, {2.5, 3}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script_processes processes = {.cpu_ms = dear, .case_count = 1};
        struct aob_processes result;
        const struct aob_processes_desc desc = {.seconds = rows[i].seconds, .precision = 0.03};
        assert_true(measure(&processes, desc, &result, NULL));
        assert_int_equal(result.good, rows[i].processes);
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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_seeds),
                                       cmocka_unit_test(test_three_are_enough),
                                       cmocka_unit_test(test_at_least),
                                       cmocka_unit_test(test_slices),
                                       cmocka_unit_test(test_seconds_buy_processes),
                                       cmocka_unit_test(test_too_few_rounds),
                                       cmocka_unit_test(test_seconds_bound),
                                       cmocka_unit_test(test_one_is_lost),
                                       cmocka_unit_test(test_two_are_lost),
                                       cmocka_unit_test(test_most),
                                       cmocka_unit_test(test_every_case_counts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
