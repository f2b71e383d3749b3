#include "check.h"
#include <math.h>
#include "base/memory.h"
#include "random.h"
#include "timing/estimate.h"

enum { PROCESSES = 8, ROUNDS = 12 };

/* Paired rounds from ln(cost/fixed) in per cent, about a ratio of 2. Every fixed pass takes 5 ms. */
static struct aob_rounds rounds_of(const double *percent, size_t count, double cost[ROUNDS],
                                   double fixed[ROUNDS])
{
    for (size_t r = 0; r < count; r++) {
        fixed[r] = 5;
        cost[r] = 10 * exp(percent[r] / 100);
    }
    return (struct aob_rounds){cost, fixed, count};
}

static struct aob_ratio estimate(const double percent[][ROUNDS], size_t processes, size_t rounds)
{
    double cost[PROCESSES][ROUNDS], fixed[PROCESSES][ROUNDS];
    struct aob_rounds each[PROCESSES];
    for (size_t p = 0; p < processes; p++)
        each[p] = rounds_of(percent[p], rounds, cost[p], fixed[p]);
    return aob_estimate_ratio(each, processes);
}

/* In per cent of ln; the ratio that belongs to 0 is 2. */
static void assert_estimate(const struct aob_ratio *r, double middle, double half)
{
    assert_true(r->bounded);
    assert_true(fabs(100 * log(r->ratio / 2) - middle) < 1e-9);
    assert_true(fabs(100 * log(r->high / r->ratio) - half) < 1e-3 * half);
    assert_true(fabs(100 * log(r->ratio / r->low) - half) < 1e-3 * half);
    assert_true(fabs(aob_estimate_half_width(r) - (exp(half / 100) - 1)) < 1e-5);
}

/* Rounds without noise: Student's interval of the three medians -1, 0, 2, whose s is sqrt(7/3). */
static void test_processes_differ(void **state)
{
    (void)state;
    struct aob_ratio r = estimate((const double[][ROUNDS]){{-1, -1, -1}, {0, 0, 0}, {2, 2, 2}}, 3, 3);
    assert_estimate(&r, 0, 4.3027 * sqrt(7.0 / 3 / 3));
}

/* Equal medians: sigma is 1.4826 x 2 x sqrt(15/12), and 15 rounds of it have the normal interval. */
static void test_rounds_differ(void **state)
{
    (void)state;
    struct aob_ratio r =
        estimate((const double[][ROUNDS]){{-4, 3, 1, 5, -1}, {1, -1, 3, -4, 5}, {5, 3, 1, -1, -4}}, 3, 5);
    assert_estimate(&r, 1, 1.959964 * 1.2533 * 1.4826 * 2 * sqrt(15.0 / 12) / sqrt(15));
}

/* Distances from the medians: 0, 1, 1 in each, so sigma is 1.4826 sqrt(9/6); the medians -3, 0, 6 have s^2 = 21. */
static void test_both_differ(void **state)
{
    (void)state;
    struct aob_ratio r = estimate((const double[][ROUNDS]){{-4, -3, -2}, {1, -1, 0}, {6, 7, 5}}, 3, 3);
    double w2 = 1.2533 * 1.2533 * 1.4826 * 1.4826 * 1.5 / 3, s2 = 21;
    assert_estimate(&r, 0, sqrt(s2 / 3) * (1.959964 + (4.3027 - 1.959964) * sqrt(1 - w2 / s2)));
}

/* Processes of 8, 2 and 2 rounds, without noise: 144/72 = 2 of them count. The median is the long one's. */
static void test_unequal_rounds(void **state)
{
    (void)state;
    const double row[3][ROUNDS] = {{-1, -1, -1, -1, -1, -1, -1, -1}, {0, 0}, {2, 2}};
    const size_t counts[] = {8, 2, 2};
    double cost[3][ROUNDS], fixed[3][ROUNDS];
    struct aob_rounds each[3];
    for (size_t p = 0; p < 3; p++)
        each[p] = rounds_of(row[p], counts[p], cost[p], fixed[p]);
    struct aob_ratio r = aob_estimate_ratio(each, 3);
    assert_estimate(&r, -1, 4.3027 * sqrt(7.0 / 3 / 2));
}

/* One process tells its rounds' interval, six at least; a round of each process tells nothing of rounds. */
static void test_few(void **state)
{
    (void)state;
    const double row[][ROUNDS] = {{1, 2, 3, 4, 5, 6}, {6, 5, 4, 3, 2, 1}};
    struct aob_ratio one = estimate(row, 1, 6), five = estimate(row, 1, 5), single = estimate(row, 2, 1);
    assert_true(one.bounded && fabs(log(one.low / 2) - 0.01) < 1e-9 && fabs(log(one.high / 2) - 0.06) < 1e-9);
    assert_true(!five.bounded && isinf(aob_estimate_half_width(&five)));
    assert_true(!single.bounded && fabs(log(single.ratio / 2) - 0.035) < 1e-9);
}

/* One of five rounds is disturbed four times as much. */
static double random_round(uint32_t *seed)
{
    return random_normal(seed) * (random_unit(seed) < 0.2 ? 4 : 1);
}

static int covered(size_t processes, double spread, int trials, uint32_t *seed)
{
    double percent[PROCESSES][ROUNDS];
    int count = 0;
    for (int t = 0; t < trials; t++) {
        for (size_t p = 0; p < processes; p++) {
            double place = spread * random_normal(seed);
            for (size_t r = 0; r < ROUNDS; r++)
                percent[p][r] = place + random_round(seed);
        }
        struct aob_ratio ratio = estimate((const double(*)[ROUNDS])percent, processes, ROUNDS);
        count += ratio.low <= 2 && 2 <= ratio.high;
    }
    return count;
}

/* Whatever share of the noise is the processes' own. */
static void test_covers_the_truth(void **state)
{
    (void)state;
    static const size_t processes[] = {3, 5, 8};
    static const double spread[] = {0, 0.2, 0.5, 2};
    enum { TRIALS = 2000 };
    uint32_t seed = 2024;
    bool all = true;
    for (size_t p = 0; p < AOB_COUNT(processes); p++)
        for (size_t s = 0; s < AOB_COUNT(spread); s++) {
            double share = 100.0 * covered(processes[p], spread[s], TRIALS, &seed) / TRIALS;
            printf("%zu processes, spread %.1f: %.1f %% covered\n", processes[p], spread[s], share);
            all = all && share >= 90 && share <= 98;
        }
    assert_true(all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_processes_differ),
                                       cmocka_unit_test(test_rounds_differ),
                                       cmocka_unit_test(test_both_differ),
                                       cmocka_unit_test(test_unequal_rounds),
                                       cmocka_unit_test(test_few),
                                       cmocka_unit_test(test_covers_the_truth)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
