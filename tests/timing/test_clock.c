#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "script.h"

/* Every rule of timing.h is held to figures written out here, on a scripted clock. */

static struct aob_block_timing measure(struct script *s, struct aob_timing_desc desc)
{
    const struct aob_timing_clock clock = script_clock(s);
    struct aob_block_timing timing;
    desc.fixed = s->fixed;
    desc.frames = s->frames;
    desc.frame_count = desc.frame_count ? desc.frame_count : SCRIPT_CASES;
    desc.clock = &clock;
    assert_true(aob_timing_run(&desc, &timing, NULL));
    return timing;
}

/* Alternates by 10 % about 4 ms: no interval is narrow. */
static double noisy(int index, int round)
{
    (void)index;
    return round % 2 ? 3.6 : 4.4;
}

/* The first frame behind the warm-up: two whole rounds, then the fixed pass alone. */
static int first_of(const struct script *s)
{
    int at = SCRIPT_WARM_UP * SCRIPT_SLOTS;
    while (s->order[at] < 0 && s->order[at + 1] < 0 && s->order[at + 2] < 0)
        at++;
    return at;
}

/* Where the rounds begin: the last slots x rounds frames of all. */
static const int *rounds_of(const struct script *s, size_t rounds)
{
    return s->order + s->count - (int)rounds * SCRIPT_SLOTS;
}

static void test_order_is_cyclic(void **state)
{
    (void)state;
    int first[2][SCRIPT_SLOTS], squares = 0, shuffled = 0;
    for (uint32_t seed = 0; seed < 2; seed++) {
        struct script *s = script_create();
        s->cpu_ms = noisy;
        size_t rounds = measure(s, (struct aob_timing_desc){.seconds = 1e9, .seed = seed}).cases[0].rounds;
        assert_int_equal(rounds, AOB_ROUNDS_MAX);
        const int *order = rounds_of(s, rounds);
        memcpy(first[seed], order, sizeof first[seed]);
        for (size_t r = 0; r < rounds; r++) {
            const int *row = order + r * SCRIPT_SLOTS, *before = row - SCRIPT_SLOTS;
            int seen[SCRIPT_CASES] = {0}, fixed = 0;
            for (int i = 0; i < SCRIPT_SLOTS; i++)
                row[i] < 0 ? fixed++ : seen[row[i]]++;
            assert_int_equal(fixed, 2);
            for (int i = 0; i < SCRIPT_CASES; i++)
                assert_int_equal(seen[i], 1);
            if (r % SCRIPT_SLOTS == 0) {
                squares++;
                shuffled += r > 0 && memcmp(row, order, sizeof first[0]) != 0;
                continue;
            }
            for (int i = 0; i < SCRIPT_SLOTS;
                 i++) /* turned by one: so each slot takes each place once a square */
                assert_int_equal(row[i], before[(i + 1) % SCRIPT_SLOTS]);
        }
        script_destroy(s);
    }
    assert_true(memcmp(first[0], first[1], sizeof first[0]) != 0);
    /* The fixed pass stands for two slots, so 60 orders are told apart: chance repeats hardly any of the 46 squares. */
    assert_true(squares == 2 * AOB_ROUNDS_MAX / SCRIPT_SLOTS && shuffled > squares - 12);
}

static void test_same_seed_same_order(void **state)
{
    (void)state;
    struct script *a = script_create(), *b = script_create();
    measure(a, (struct aob_timing_desc){.seconds = 1e9, .seed = 11});
    measure(b, (struct aob_timing_desc){.seconds = 1e9, .seed = 11});
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->order, b->order, sizeof a->order);
    script_destroy(a);
    script_destroy(b);
}

static int outliers; /* how many of the even rounds, from the first on, are too long */
static double excess;
static double outlying(int index, int round)
{
    return index == 1 && round >= 0 && round % 2 == 0 && round < 2 * outliers ? 4 * excess : 4;
}

static size_t rounds_for(int count, double factor, double narrow)
{
    struct script *s = script_create();
    s->cpu_ms = outlying;
    outliers = count;
    excess = factor;
    size_t rounds = measure(s, (struct aob_timing_desc){.seconds = 1e9, .narrow = narrow}).cases[0].rounds;
    script_destroy(s);
    return rounds;
}

static size_t rounds_with(int count, double factor)
{
    return rounds_for(count, factor, 0);
}

/* The interval of n = 20 goes from the 6th to the 15th value, of 30 from the 10th to the 21st, of 45 from the 16th to
 * the 30th (P(Bin(20) < 6) = .0207, P(Bin(30) < 10) = .0214, P(Bin(45) < 16) = .0178; one more is above .025). So five
 * long rounds of 20 do not widen it and six do, and every case of the block must be narrow. */
static void test_stops_when_narrow(void **state)
{
    (void)state;
    assert_int_equal(rounds_with(0, 1), 20);
    assert_int_equal(rounds_with(5, 1.2), 20);
    assert_int_equal(rounds_with(6, 1.2), 30);
    assert_int_equal(rounds_with(9, 1.2), 30);
    assert_int_equal(rounds_with(10, 1.2), 45);
    assert_int_equal(rounds_with(15, 1.2), 45);
    assert_int_equal(rounds_with(16, 1.2), 67);
    /* what is too long by 3 % or less does not widen it, on either side */
    assert_int_equal(rounds_with(6, 1.0299), 20);
    assert_int_equal(rounds_with(6, 1.0301), 30);
    assert_int_equal(rounds_with(6, 1 / 1.0299), 20);
    assert_int_equal(rounds_with(6, 1 / 1.0301), 30);
    assert_int_equal(rounds_for(6, 1.0099, 0.01), 20);
    assert_int_equal(rounds_for(6, 1.0101, 0.01), 30);
    assert_int_equal(rounds_for(6, 1.0599, 0.06), 20);
    assert_int_equal(rounds_for(6, 1 / 1.0601, 0.06), 30);
}

/* Seconds are of wall time and for each case: a round of three cases at 8 ms of wall time and two fixed passes of 4
 * takes 32 ms, one with a single case 16; each odd number of rounds takes .8 ms a case more. */
static void test_stops_in_time(void **state)
{
    (void)state;
    static const struct {
        size_t cases;
        double seconds; /* a case */
        size_t rounds;
    } rows[] = {
        {3, 0, 6},    {3, 0.05, 6},   {3, 0.063, 6},
        {3, 0.07, 7}, {3, 0.0967, 9}, {3, 0.0969, 10},
        {1, 0.1, 7},  {1, 0.2, 13},   {1, 1e9, AOB_ROUNDS_MAX},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script *s = script_create();
        s->cpu_ms = noisy;
        struct aob_block_timing t =
            measure(s, (struct aob_timing_desc){.frame_count = rows[i].cases, .seconds = rows[i].seconds});
        if (t.cases[0].rounds != rows[i].rounds)
            fail_msg("%zu cases, %g s: %zu rounds, not %zu", rows[i].cases, rows[i].seconds,
                     t.cases[0].rounds, rows[i].rounds);
        script_destroy(s);
    }
}

static double rising(int index, int round) /* 4 ms and .001 more a round */
{
    (void)index;
    return 4 + 0.001 * round;
}

static bool every_third(int index, int round)
{
    return index == 1 && round % 3 == 0;
}

static bool always(int index, int round)
{
    (void)round;
    return index == 2;
}

static bool dirty(int index, int round)
{
    return every_third(index, round) || always(index, round);
}

/* Wall time is the median over clean rounds, processor time over all. Of rounds 0..19 case 1 is interrupted in 0, 3 ..
 * 18: what is left has the median 9.5 -> rounds 1, 2, 4, 5, 7, 8, 10, 11, 13, 14, 16, 17, 19: round 10. */
static void test_clean_rounds(void **state)
{
    (void)state;
    struct script *s = script_create();
    s->cpu_ms = rising;
    s->preempted = dirty;
    struct aob_block_timing t = measure(s, (struct aob_timing_desc){.seconds = 1e9});
    static const size_t clean[SCRIPT_CASES] = {20, 13, 0};
    static const double wall[SCRIPT_CASES] = {2 * 4.0095, 2 * 4.010, NAN};
    for (int i = 0; i < SCRIPT_CASES; i++) {
        assert_int_equal(t.cases[i].rounds, 20);
        assert_int_equal(t.cases[i].clean_rounds, clean[i]);
        assert_near(t.cases[i].cpu_ms, 4.0095, 1e-5);
        if (isnan(wall[i]))
            assert_true(isnan(t.cases[i].wall_ms));
        else
            assert_near(t.cases[i].wall_ms, wall[i], 1e-5);
    }
    script_destroy(s);
}

static double dear_wall(int index, int round)
{
    (void)round;
    return 10.0 * (index + 1);
}

/* Cases of 4 ms of processor time against 2; 10, 20, 30 ms of wall time against 4. */
static void test_clock_choice(void **state)
{
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        struct script *s = script_create();
        s->wall_ms = dear_wall;
        struct aob_block_timing t = measure(s, (struct aob_timing_desc){.seconds = 1e9, .wall = wall});
        for (int i = 0; i < SCRIPT_CASES; i++) {
            assert_near(t.cases[i].to_fixed.ratio, wall ? 2.5 * (i + 1) : 2, 1e-9);
            assert_near(t.cases[i].cpu_ms, 4, 1e-5);
            assert_near(t.cases[i].wall_ms, 10 * (i + 1), 1e-5);
            assert_near(t.cases[i].measured_s, 20 * 0.01 * (i + 1), 1e-6);
            for (int p = 0; p <= i; p++) {
                double share = 2.0 * (p + 1) / ((i + 1) * (i + 2));
                assert_near(t.cases[i].pass_cpu_ms[p], 4 * share, 1e-5);
                assert_near(t.cases[i].pass_to_fixed[p].ratio, 2 * share, 1e-6);
            }
        }
        assert_near(t.fixed_cpu_ms, 2, 1e-9);
        assert_near(t.fixed_s, 2 * 20 * 0.004, 1e-9);
        script_destroy(s);
    }
}

/* Wall times that are noisy stop a block that is judged by them later, and one that is judged by processor time not. */
static double noisy_wall(int index, int round)
{
    return 2 * noisy(index, round);
}

static void test_width_is_of_the_chosen_clock(void **state)
{
    (void)state;
    for (int wall = 0; wall < 2; wall++) {
        struct script *s = script_create();
        s->wall_ms = noisy_wall;
        struct aob_block_timing t = measure(s, (struct aob_timing_desc){.seconds = 1e9, .wall = wall});
        assert_int_equal(t.cases[0].rounds, wall ? AOB_ROUNDS_MAX : 20);
        script_destroy(s);
    }
}

/* Frames of the fixed pass behind the two rounds: it is steady when three successive ones are within 10 %. */
static void test_warm_up(void **state)
{
    (void)state;
    static const struct {
        double fixed_ms[12]; /* behind the four of the two rounds; 0: 2 */
        int frames;          /* until it is steady */
    } rows[] = {
        {{2, 2, 2}, 3},
        {{9, 5, 2, 2, 2}, 5},
        {{2, 2.19, 2}, 3},
        {{2, 2.3, 2, 2, 2}, 5},
        {{2, 3, 2, 3, 2, 3, 2, 3, 2, 3, 2, 2}, 10},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script *s = script_create();
        memcpy(s->fixed_ms + 2 * SCRIPT_WARM_UP, rows[i].fixed_ms, sizeof rows[i].fixed_ms);
        struct aob_block_timing t = measure(s, (struct aob_timing_desc){.seconds = 1e9});
        int rounds = (int)t.cases[0].rounds;
        assert_int_equal(s->count, (SCRIPT_WARM_UP + rounds) * SCRIPT_SLOTS + rows[i].frames);
        assert_true(first_of(s) <= SCRIPT_WARM_UP * SCRIPT_SLOTS + rows[i].frames);
        script_destroy(s);
    }
}

static double cheap_ms, dear_ms;
static double cheap_and_dear(int index, int round)
{
    (void)round;
    return index == 0 ? cheap_ms : index == 1 ? dear_ms : fmax(cheap_ms, fmin(4, dear_ms));
}

/* As many frames a slot as make the cheapest take 2 ms; the dearest stays within 100 ms; 16 at most. */
static void test_frames_a_slot(void **state)
{
    (void)state;
    static const struct {
        double cheap, dear;
        int frames;
    } rows[] = {
        {4, 4, 1}, {1.9, 4, 2}, {0.3, 4, 7}, {0.3, 30, 3}, {0.3, 60, 1}, {0.3, 400, 1}, {0.01, 1, 16},
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct script *s = script_create();
        cheap_ms = rows[i].cheap;
        dear_ms = rows[i].dear;
        s->cpu_ms = cheap_and_dear;
        struct aob_block_timing t = measure(s, (struct aob_timing_desc){.seconds = 1e9});
        assert_int_equal(s->runs[0], SCRIPT_WARM_UP + (int)t.cases[0].rounds * rows[i].frames);
        assert_near(t.cases[0].cpu_ms, cheap_ms, 1e-5); /* of a frame */
        assert_near(t.cases[1].wall_ms, 2 * dear_ms, 1e-5);
        assert_near(t.cases[1].measured_s, 2e-3 * dear_ms * rows[i].frames * (double)t.cases[1].rounds, 1e-5);
        script_destroy(s);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_order_is_cyclic),
                                       cmocka_unit_test(test_same_seed_same_order),
                                       cmocka_unit_test(test_stops_when_narrow),
                                       cmocka_unit_test(test_stops_in_time),
                                       cmocka_unit_test(test_clean_rounds),
                                       cmocka_unit_test(test_clock_choice),
                                       cmocka_unit_test(test_width_is_of_the_chosen_clock),
                                       cmocka_unit_test(test_warm_up),
                                       cmocka_unit_test(test_frames_a_slot)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
