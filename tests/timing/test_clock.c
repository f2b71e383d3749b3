#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "script.h"
#include "timing/summary.h"

/* Every rule of timing.h is held to figures written out here, on a scripted clock. A frame of a case takes 4 ms of processor
 * time, one of the fixed pass 2 ms, and twice as much of wall time, unless a test says otherwise. */

/* Alternates by 10 % about 4 ms: no interval is narrow. */
static double noisy(const struct script *s, int index, int round)
{
    (void)s;
    (void)index;
    return round % 2 ? 3.6 : 4.4;
}

/* The slots of a round in the order in which they ran. */
static void order_of(const struct aob_round *round, int order[SCRIPT_SLOTS])
{
    for (int i = 0; i < SCRIPT_SLOTS; i++)
        order[i] = -1;
    for (int slot = 0; slot < SCRIPT_SLOTS; slot++)
        order[round->slots[slot].place] = slot;
}

/* Made by hand from the generator x -> 6364136223846793005 x + 1442695040888963407 and Fisher and Yates. */
static const struct {
    uint32_t seed;
    int first[2][SCRIPT_SLOTS]; /* rows of the first two squares */
} squares[] = {{7, {{2, 1, 0, 4, 3}, {2, 4, 1, 3, 0}}}, {11, {{4, 0, 2, 3, 1}, {2, 0, 1, 3, 4}}}};

static void test_order_is_cyclic(void **state)
{
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(squares); i++) {
        struct script *s = script_create();
        s->cpu_ms = noisy;
        struct aob_round_list rounds = script_measure(
            s, (struct aob_timing_desc){.seconds = 0.5, .seed = squares[i].seed, .process = 4});
        assert_true(rounds.count > 2 * SCRIPT_SLOTS);
        int before[SCRIPT_SLOTS] = {0}, now[SCRIPT_SLOTS];
        for (size_t r = 0; r < rounds.count; r++) {
            order_of(&rounds.items[r], now);
            assert_int_equal(rounds.items[r].number, r);
            assert_int_equal(rounds.items[r].process, 4);
            assert_int_equal(rounds.items[r].seed, squares[i].seed);
            if (r % SCRIPT_SLOTS == 0 && r / SCRIPT_SLOTS < 2)
                assert_memory_equal(now, squares[i].first[r / SCRIPT_SLOTS], sizeof now);
            for (int k = 0; k < SCRIPT_SLOTS && r % SCRIPT_SLOTS; k++) /* turned by one */
                assert_int_equal(now[k], before[(k + 1) % SCRIPT_SLOTS]);
            memcpy(before, now, sizeof now);
        }
        aob_rounds_finish(&rounds);
        script_destroy(s);
    }
}

/* That the places are those at which the frames really ran. */
static void test_places_are_what_ran(void **state)
{
    (void)state;
    struct script *s = script_create();
    struct aob_round_list rounds =
        script_measure(s, (struct aob_timing_desc){.seconds = SCRIPT_ENDLESS, .seed = 3});
    const int *ran = s->order + s->count - (int)rounds.count * SCRIPT_SLOTS;
    for (size_t r = 0; r < rounds.count; r++)
        for (int slot = 0; slot < SCRIPT_SLOTS; slot++) {
            int expected = slot < AOB_SLOT_CASES ? -1 : slot - AOB_SLOT_CASES;
            assert_int_equal(ran[(int)r * SCRIPT_SLOTS + rounds.items[r].slots[slot].place], expected);
        }
    aob_rounds_finish(&rounds);
    script_destroy(s);
}

static int outliers; /* how many of the even rounds, from the first on, are too long */
static double excess;
static double outlying(const struct script *s, int index, int round)
{
    (void)s;
    return index == 1 && round >= 0 && round % 2 == 0 && round < 2 * outliers ? 4 * excess : 4;
}

static size_t rounds_for(int count, double factor, double precision)
{
    struct script *s = script_create();
    s->cpu_ms = outlying;
    outliers = count;
    excess = factor;
    size_t rounds =
        script_count_rounds(s, (struct aob_timing_desc){.seconds = SCRIPT_ENDLESS, .precision = precision});
    script_destroy(s);
    return rounds;
}

/* The interval of n = 20 goes from the 6th to the 15th value, of 30 from the 10th to the 21st, of 45 from the 16th to
 * the 30th (P(Bin(20) < 6) = .0207, P(Bin(30) < 10) = .0214, P(Bin(45) < 16) = .0178; one more is above .025). So five
 * long rounds of 20 do not widen it and six do, and every case of the block must be narrow. */
static void test_stops_when_narrow(void **state)
{
    (void)state;
    static const struct {
        int count;
        double factor, precision;
        size_t rounds;
    } rows[] = {
        {0, 1, 0.03, 20},
        {5, 1.2, 0.03, 20},
        {6, 1.2, 0.03, 30},
        {9, 1.2, 0.03, 30},
        {10, 1.2, 0.03, 45},
        {15, 1.2, 0.03, 45},
        {16, 1.2, 0.03, 67},
        /* what is too long by 3 % or less does not widen it, on either side */
        {6, 1.0299, 0.03, 20},
        {6, 1.0301, 0.03, 30},
        {6, 1 / 1.0299, 0.03, 20},
        {6, 1 / 1.0301, 0.03, 30},
        {6, 1.0099, 0.01, 20},
        {6, 1.0101, 0.01, 30},
        {6, 1.0599, 0.06, 20},
        {6, 1 / 1.0601, 0.06, 30},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++)
        assert_int_equal(rounds_for(rows[i].count, rows[i].factor, rows[i].precision), rows[i].rounds);
}

/* Seconds are of wall time and for each case. The last frames before the rounds take 3.6 ms, so a slot has 3.6 ms: one
 * frame of a case (8.8 and 7.2 ms of wall time in turn), two of the fixed pass (2 x 4 ms, in each of its two slots). A
 * round of three cases takes 42.4 or 37.6 ms, one with a single case 24.8 or 23.2 ms. */
static void test_stops_in_time(void **state)
{
    (void)state;
    static const struct {
        size_t cases;
        double seconds; /* a case */
        size_t rounds;
    } rows[] = {
        {3, 0, 2},      {3, 0.0266, 2}, {3, 0.0267, 3}, {3, 0.0407, 3}, {3, 0.0409, 4}, {3, 0.0532, 4},
        {3, 0.0534, 5}, {1, 0.0479, 2}, {1, 0.0481, 3}, {1, 0.0727, 3}, {1, 0.0729, 4},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script *s = script_create();
        s->cpu_ms = noisy;
        size_t count = script_count_rounds(
            s, (struct aob_timing_desc){.frame_count = rows[i].cases, .seconds = rows[i].seconds});
        if (count != rows[i].rounds)
            fail_msg("%zu cases, %g s: %zu rounds, not %zu", rows[i].cases, rows[i].seconds, count,
                     rows[i].rounds);
        script_destroy(s);
    }
}

static double rising(const struct script *s, int index, int round) /* 4 ms and .001 more a round */
{
    (void)s;
    (void)index;
    return 4 + 0.001 * round;
}

/* Case 1 is interrupted in every third round, case 2 is robbed in each, case 0 has faults, which are no matter. */
static struct aob_causes disturbed(const struct script *s, int index, int round)
{
    (void)s;
    return (struct aob_causes){.involuntary = index == 1 && round % 3 == 0,
                               .minor_faults = index == 0 ? 7 : 0,
                               .steal_ticks = index == 2 ? 2 : 0};
}

/* Wall time is the median over clean rounds, processor time over all. Of rounds 0..19 case 1 is interrupted in 0, 3 ..
 * 18: what is left has the median 9.5 -> rounds 1, 2, 4, 5, 7, 8, 10, 11, 13, 14, 16, 17, 19: round 10. */
static void test_clean_rounds(void **state)
{
    (void)state;
    struct script *s = script_create();
    s->cpu_ms = rising;
    s->cause = disturbed;
    struct aob_round_list rounds = script_measure(s, (struct aob_timing_desc){.seconds = SCRIPT_ENDLESS});
    static const size_t clean[SCRIPT_CASES] = {20, 13, 0};
    static const double wall[SCRIPT_CASES] = {2 * 4.0095, 2 * 4.010, NAN};
    for (size_t i = 0; i < SCRIPT_CASES; i++) {
        struct aob_summary t;
        aob_summarise(&rounds, AOB_SLOT_CASES + i, &t);
        assert_int_equal(t.rounds, 20);
        assert_int_equal(t.clean_rounds, clean[i]);
        assert_near(t.whole.ms[AOB_CLOCK_CPU], 4.0095, 1e-5);
        if (isnan(wall[i]))
            assert_true(isnan(t.whole.ms[AOB_CLOCK_WALL]));
        else
            assert_near(t.whole.ms[AOB_CLOCK_WALL], wall[i], 1e-5);
    }
    const struct aob_slot *slots = rounds.items[3].slots + AOB_SLOT_CASES;
    assert_int_equal(slots[0].causes.minor_faults, 7);
    assert_int_equal(slots[1].causes.involuntary, 1);
    assert_int_equal(slots[2].causes.steal_ticks, 2);
    assert_int_equal(slots[0].causes.involuntary, 0);
    aob_rounds_finish(&rounds);
    script_destroy(s);
}

/* What is not known excludes nothing. */
static void test_unknown_steal_is_clean(void **state)
{
    (void)state;
    struct aob_slot slot = {.causes = {.steal_ticks = AOB_CAUSE_UNKNOWN}};
    assert_true(aob_slot_is_clean(&slot));
    slot.causes.steal_ticks = 1;
    assert_false(aob_slot_is_clean(&slot));
}

static double dear_wall(const struct script *s, int index, int round)
{
    (void)s;
    (void)round;
    return 10.0 * (index + 1);
}

static void check_choice(const struct aob_round_list *rounds, int i, bool wall)
{
    struct aob_summary t;
    aob_summarise(rounds, AOB_SLOT_CASES + (size_t)i, &t);
    assert_near(t.to_fixed.ratio, wall ? 2.5 * (i + 1) : 2, 1e-9);
    assert_near(t.whole.ms[AOB_CLOCK_CPU], 4, 1e-5);
    assert_near(t.whole.ms[AOB_CLOCK_WALL], 10 * (i + 1), 1e-5);
    assert_true(isnan(t.whole.ms[AOB_CLOCK_DEVICE]));
    assert_int_equal(t.pass_count, i + 1);
    for (int p = 0; p <= i; p++) {
        double share = 2.0 * (p + 1) / ((i + 1) * (i + 2));
        assert_near(t.passes[p].ms[AOB_CLOCK_CPU], 4 * share, 1e-5);
        assert_near(t.passes[p].ms[AOB_CLOCK_WALL], 10 * (i + 1) * share, 1e-5);
        assert_near(t.pass_to_fixed[p].ratio, (wall ? 2.5 * (i + 1) : 2) * share, 1e-6);
    }
}

/* Cases of 4 ms of processor time against 2; 10, 20, 30 ms of wall time against 4. */
static void test_clock_choice(void **state)
{
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        struct script *s = script_create();
        s->wall_ms = dear_wall;
        struct aob_round_list rounds =
            script_measure(s, (struct aob_timing_desc){.seconds = SCRIPT_ENDLESS,
                                                       .clock = wall ? AOB_CLOCK_WALL : AOB_CLOCK_CPU});
        for (int i = 0; i < SCRIPT_CASES; i++)
            check_choice(&rounds, i, wall);
        /* a slot has 4 ms by the one clock, 30 by the other: 1, 1, 1 and 2 frames, or 3, 2 (1.5), 1 and 8 (7.5) */
        assert_near(aob_round_seconds(&rounds.items[0]),
                    wall ? 0.030 + 0.040 + 0.030 + 2 * 0.032 : 0.010 + 0.020 + 0.030 + 2 * 0.008, 1e-6);
        aob_rounds_finish(&rounds);
        script_destroy(s);
    }
}

/* Wall times that are noisy stop a block that is judged by them later, and one that is judged by processor time not. */
static double noisy_wall(const struct script *s, int index, int round)
{
    return 2 * noisy(s, index, round);
}

static void test_width_is_of_the_chosen_clock(void **state)
{
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        struct script *s = script_create();
        s->wall_ms = noisy_wall;
        size_t count = script_count_rounds(
            s, (struct aob_timing_desc){.seconds = 0.5, .clock = wall ? AOB_CLOCK_WALL : AOB_CLOCK_CPU});
        /* 1.5 s of three cases, at 40 ms a round */
        assert_int_equal(count, wall ? 38 : 20);
        script_destroy(s);
    }
}

/* 12 ms against 6, whatever the host's clocks say. */
static void test_clock_of_the_device(void **state)
{
    (void)state;
    struct script *s = script_create();
    struct aob_summary t;
    s->device = true;
    s->wall_ms = noisy_wall;
    struct aob_round_list rounds =
        script_measure(s, (struct aob_timing_desc){.seconds = SCRIPT_ENDLESS, .clock = AOB_CLOCK_DEVICE});
    aob_summarise(&rounds, AOB_SLOT_CASES + 1, &t);
    assert_int_equal(t.rounds, 20);
    assert_near(t.whole.ms[AOB_CLOCK_DEVICE], 12, 1e-5);
    assert_near(t.passes[1].ms[AOB_CLOCK_DEVICE], 8, 1e-5);
    assert_near(t.to_fixed.ratio, 2, 1e-9);
    assert_near(t.pass_to_fixed[1].ratio, 8.0 / 6, 1e-6);
    assert_int_equal(rounds.items[0].slots[AOB_SLOT_FIXED].frames, 2);
    aob_rounds_finish(&rounds);
    script_destroy(s);
}

static void test_no_such_clock(void **state)
{
    (void)state;
    struct script *s = script_create();
    const struct aob_timing_source source = script_source(s);
    struct aob_round_list rounds = {0};
    struct aob_error error = {{0}};
    const struct aob_timing_desc desc = {.fixed = s->fixed,
                                         .frames = s->frames,
                                         .frame_count = 1,
                                         .clock = AOB_CLOCK_DEVICE,
                                         .source = &source};
    assert_false(aob_timing_run(&desc, &rounds, &error));
    assert_string_equal(error.text, "the device told no time by the device clock");
    script_destroy(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_order_is_cyclic),     cmocka_unit_test(test_places_are_what_ran),
        cmocka_unit_test(test_stops_when_narrow),   cmocka_unit_test(test_stops_in_time),
        cmocka_unit_test(test_clean_rounds),        cmocka_unit_test(test_unknown_steal_is_clean),
        cmocka_unit_test(test_clock_choice),        cmocka_unit_test(test_width_is_of_the_chosen_clock),
        cmocka_unit_test(test_clock_of_the_device), cmocka_unit_test(test_no_such_clock)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
