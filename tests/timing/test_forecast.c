#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "base/statistics.h"
#include "random.h"
#include "script.h"
#include "timing/forecast.h"
#include "timing/summary.h"

/* The seconds that are foretold, by hand and against what the scheduler itself takes on a scripted clock whose scatter is
 * known. */

/* 1.96 x 1.2533 x sigma / sqrt(rounds) where processes are alike, and Student's factor where only they differ. */
static void test_by_hand(void **state)
{
    (void)state;
    struct aob_forecast f = {.within = 0.047, .noisiest = 0.047, .round_s = 0.01};
    /* 1 %: 135 rounds, of which a quarter of a second has 25; 4 %: 9, but never fewer than 20 in all, nor 3 processes */
    assert_near(aob_forecast_seconds(&f, 0.01), 6 * 25 * 0.01, 1e-9);
    assert_near(aob_forecast_seconds(&f, 0.04), 3 * 7 * 0.01, 1e-9);
    f.least = 5;
    assert_near(aob_forecast_seconds(&f, 0.04), 5 * 4 * 0.01, 1e-9);
    /* .1 %: 13400 rounds; a hundred processes get as many as that takes */
    assert_near(aob_forecast_seconds(&f, 0.001), 100 * 134 * 0.01, 1.0);
    /* 2.201 x .03 / sqrt(12) = .0191, with 11 processes it is .0202. Each ends at its first check point. */
    f = (struct aob_forecast){.between = 0.03, .round_s = 0.01};
    assert_near(aob_forecast_seconds(&f, expm1(0.02)), 12 * 20 * 0.01, 1e-9);
    f.noisiest = 0.5; /* a neighbour that is never narrow: the quarter of a second is used up */
    assert_near(aob_forecast_seconds(&f, expm1(0.02)), 12 * 25 * 0.01, 1e-9);
    f.between = 0.06; /* 1.984 x .06 / 10 */
    assert_true(isinf(aob_forecast_seconds(&f, 0.01)));
}

/* A block whose rounds and processes scatter as is said. */
struct made {
    double within, between, frame_ms;
    uint32_t seed;
} made;

static double normal_of(uint32_t seed, int process, int round)
{
    uint32_t state = aob_process_seed(aob_process_seed(seed, process), round);
    return random_normal(&state);
}

static double cost(const struct script *s, int index, int round)
{
    (void)index;
    double level = made.between * normal_of(made.seed, s->process, -1000);
    return made.frame_ms * exp(level + made.within * normal_of(made.seed, s->process, round));
}

struct measured {
    double half_width, seconds_needed;
};

static struct measured measure(uint32_t seed, double seconds, double precision)
{
    struct script_processes processes = {.cpu_ms = cost, .case_count = 1, .precision = precision};
    const struct aob_processes_desc desc = {.case_count = 1,
                                            .seconds = seconds,
                                            .precision = precision,
                                            .seed = seed,
                                            .run = script_process,
                                            .on_lost = script_lost,
                                            .user = &processes};
    struct aob_processes result;
    made.seed = seed;
    assert_true(aob_processes_run(&desc, &result, NULL));
    struct aob_ratio ratio = aob_rounds_ratio(&result.rounds, AOB_SLOT_CASES);
    struct measured measured = {aob_estimate_half_width(&ratio),
                                aob_seconds_needed(&result.rounds, AOB_SLOT_CASES, &desc)};
    aob_processes_finish(&result);
    return measured;
}

/* The median of what runs of so many seconds foretell, of those that are not precise. */
static double foretold(double seconds, double precision, size_t runs)
{
    double *needed = AOB_NEW_ARRAY(double, runs);
    size_t used = 0;
    for (uint32_t seed = 0; used < runs && seed < 100 * runs; seed++) {
        struct measured m = measure(seed, seconds, precision);
        assert_int_equal(isnan(m.seconds_needed), m.half_width <= precision);
        if (m.half_width > precision)
            needed[used++] = m.seconds_needed;
    }
    assert_true(used == runs);
    double median = aob_median(needed, runs);
    free(needed);
    return median;
}

static bool half_reach(double seconds, double precision, size_t runs)
{
    size_t reached = 0;
    for (uint32_t seed = 0; seed < runs; seed++)
        reached += measure(0x5eed0000 + seed, seconds, precision).half_width <= precision;
    return 2 * reached >= runs;
}

/* The seconds with which half of the runs get there. */
static double truth(double precision, size_t runs)
{
    double low = 0.1, high = 40;
    assert_true(half_reach(high, precision, runs));
    while (high / low > 1.1) {
        double middle = sqrt(low * high);
        *(half_reach(middle, precision, runs) ? &high : &low) = middle;
    }
    return high;
}

static void test_within_a_factor_of_two(void **state)
{
    (void)state;
    static const struct {
        double within, between, frame_ms, seconds, precision;
    } rows[] = {
        {0.05, 0, 4, 1.5, 0.01},      /* rounds are all */
        {0.05, 0, 4, 0.4, 0.01},      /* from a few of them */
        {0.01, 0.03, 4, 0.5, 0.015},  /* processes are most: three of them tell too wide an interval */
        {0.01, 0.03, 4, 0.12, 0.045}, /* and longer ones would not help */
        {0.03, 0.015, 4, 1, 0.01},    /* both */
        {0.03, 0.01, 1, 1.5, 0.006},  /* of a cheap frame */
        {0.03, 0.01, 40, 1.5, 0.01},  /* of a dear one, a round of which takes as long as a process gets */
        {0.01, 0.02, 1, 0.75, 0.02},  /* processes end by themselves */
    };
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        made = (struct made){rows[i].within, rows[i].between, rows[i].frame_ms, 0};
        double told = foretold(rows[i].seconds, rows[i].precision, 41), took = truth(rows[i].precision, 41);
        print_message("%zu: foretold %.3g s, true %.3g s\n", i, told, took);
        assert_true(told <= 2 * took && took <= 2 * told);
    }
}

/* Rounds of processes of 40, 5 and 5: the one that has most counts most, so they say less than 3 x 17 would. A slot of
 * the fixed pass takes 1 ms. */
static struct aob_round_list make_uneven(uint32_t seed)
{
    static const int counts[] = {40, 5, 5};
    struct aob_round_list list = {0};
    uint32_t state = seed;
    for (int p = 0; p < (int)AOB_COUNT(counts); p++) {
        for (int i = 0; i < counts[p]; i++) {
            struct aob_round *round = AOB_PUSH(list.items, list.count, list.capacity);
            *round = (struct aob_round){
                .process = p, .number = i, .clock = AOB_CLOCK_WALL, .slot_count = AOB_SLOT_CASES + 1};
            for (size_t s = 0; s < round->slot_count; s++) {
                double ns = s < AOB_SLOT_CASES ? 1e6 : 1e6 * exp(0.05 * random_normal(&state));
                for (int clock = 0; clock < AOB_CLOCK_COUNT; clock++)
                    round->slots[s].whole.ns[clock] = (int64_t)ns;
                round->slots[s].frames = 1;
            }
        }
    }
    return list;
}

/* Whatever the forecast says of equal processes: what was spent did not do. */
static void test_more_than_was_spent(void **state)
{
    (void)state;
    const struct aob_processes_desc desc = {.case_count = 1, .seconds = 0.15};
    int judged = 0;
    for (uint32_t seed = 1; seed <= 100; seed++) {
        struct aob_round_list rounds = make_uneven(seed);
        struct aob_ratio ratio = aob_rounds_ratio(&rounds, AOB_SLOT_CASES);
        struct aob_processes_desc asked = desc;
        asked.precision = 0.99 * aob_estimate_half_width(&ratio);
        double needed = aob_seconds_needed(&rounds, AOB_SLOT_CASES, &asked);
        judged += isfinite(needed);
        assert_true(isinf(needed) ||
                    needed > 0.19); /* about 50 rounds of 3 ms, and a process of .05 s more */
        aob_rounds_finish(&rounds);
    }
    assert_true(judged > 90);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_by_hand),
                                       cmocka_unit_test(test_within_a_factor_of_two),
                                       cmocka_unit_test(test_more_than_was_spent)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
