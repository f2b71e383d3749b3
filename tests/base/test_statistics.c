#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/statistics.h"
#include "random.h"

static void test_median_and_quantile(void **state)
{
    (void)state;
    assert_true(aob_median((const double[]){3, 1, 2}, 3) == 2);
    assert_true(aob_median((const double[]){4, 1, 2, 3}, 4) == 2.5);
    assert_true(aob_quantile((const double[]){0, 10}, 2, 0.25) == 2.5);
    assert_true(aob_quantile((const double[]){5}, 1, 0.9) == 5);
}

/* k of the published table of the sign test's 95 % interval (two-sided, e.g. Conover, table A3). */
static void test_interval_against_table(void **state)
{
    (void)state;
    const struct {
        size_t n, k;
    } rows[] = {{6, 1},  {8, 1},  {9, 2},   {10, 2},  {12, 3},  {15, 4},
                {20, 6}, {25, 8}, {30, 10}, {50, 18}, {100, 40}};
    double x[100], low, high;
    for (size_t i = 0; i < 100; i++)
        x[i] = (double)i + 1;
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++) {
        assert_true(aob_median_interval(x, rows[r].n, &low, &high));
        assert_true(low == (double)rows[r].k);
        assert_true(high == (double)(rows[r].n + 1 - rows[r].k));
    }
    assert_false(aob_median_interval(x, 5, &low, &high));
    assert_true(low == 1 && high == 5);
}

/* Student's t, two-sided (any printed table, such as Abramowitz and Stegun, table 26.10). */
static void test_student_against_table(void **state)
{
    (void)state;
    const struct {
        double alpha;
        size_t freedom;
        double t;
    } rows[] = {{0.05, 1, 12.706},  {0.05, 2, 4.303},  {0.05, 3, 3.182},   {0.05, 4, 2.776},
                {0.05, 9, 2.262},   {0.05, 30, 2.042}, {0.05, 120, 1.980}, {0.01, 1, 63.657},
                {0.01, 2, 9.925},   {0.01, 4, 4.604},  {0.01, 5, 4.032},   {0.01, 10, 3.169},
                {0.001, 2, 31.599}, {0.001, 4, 8.610}, {0.001, 7, 5.408},  {0.001, 60, 3.460}};
    for (size_t r = 0; r < sizeof rows / sizeof *rows; r++)
        assert_near(aob_student(rows[r].alpha, rows[r].freedom), rows[r].t, 6e-4);
}

/* Skewed times with a drift that both sides share: the interval must cover the true ratio in about 95 % of
 * trials. */
static void test_ratio_covers_the_truth(void **state)
{
    (void)state;
    uint32_t seed = 12345;
    int covered = 0, trials = 2000;
    double a[30], b[30], worst = 0;
    for (int t = 0; t < trials; t++) {
        double level = 1;
        for (int i = 0; i < 30; i++) {
            level *= 0.9 + 0.25 * random_unit(&seed);
            a[i] = 1.25 * level * (1 - 0.1 * log(1 - random_unit(&seed)));
            b[i] = level * (1 - 0.1 * log(1 - random_unit(&seed)));
        }
        struct aob_ratio r = aob_paired_ratio(a, b, 30);
        assert_true(r.bounded && r.low <= r.ratio && r.ratio <= r.high);
        covered += r.low <= 1.25 && 1.25 <= r.high;
        worst = fmax(worst, fabs(log(r.ratio / 1.25)));
    }
    assert_in_range(covered, trials * 93 / 100, trials * 99 / 100);
    assert_true(worst < 0.15);
}

/* Intervals that lie evenly about their estimates add as independent errors do. */
static void test_even_quotient(void **state)
{
    (void)state;
    struct aob_ratio b = {3, 3 * exp(-0.03), 3 * exp(0.03), true};
    struct aob_ratio a = {2, 2 * exp(-0.04), 2 * exp(0.04), true};
    struct aob_ratio q = aob_quotient(&b, &a);
    assert_true(q.bounded);
    assert_near(q.ratio, 1.5, 1e-12);
    assert_near(log(q.low / q.ratio), -0.05, 1e-12);
    assert_near(log(q.high / q.ratio), 0.05, 1e-12);
}

/* Which side of which interval counts: b may be much larger than measured, a not at all smaller. */
static void test_uneven_quotient(void **state)
{
    (void)state;
    struct aob_ratio b = {1, exp(-0.01), exp(0.12), true}, a = {1, exp(-0.05), exp(0.02), true};
    struct aob_ratio q = aob_quotient(&b, &a), back = aob_quotient(&a, &b);
    assert_near(log(q.high), 0.13, 1e-12);
    assert_near(log(q.low), -hypot(0.01, 0.02), 1e-12);
    assert_near(log(back.low), -log(q.high), 1e-12);
    assert_near(log(back.high), -log(q.low), 1e-12);
    a.bounded = false;
    assert_false(aob_quotient(&b, &a).bounded);
    assert_true(isinf(aob_quotient(&b, &a).high));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_median_and_quantile),   cmocka_unit_test(test_interval_against_table),
        cmocka_unit_test(test_student_against_table), cmocka_unit_test(test_ratio_covers_the_truth),
        cmocka_unit_test(test_even_quotient),         cmocka_unit_test(test_uneven_quotient)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
