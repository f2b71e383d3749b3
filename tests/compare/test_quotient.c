#include "check.h"
#include <math.h>
#include "compare/quotient.h"
#include "random.h"

/* Means of `n` normal values with their interval of 95 %. */
static struct aob_ratio measure(uint32_t *seed, double truth, double spread, size_t n)
{
    double x[16], sum = 0, squares = 0;
    for (size_t i = 0; i < n; i++) {
        x[i] = truth + spread * random_normal(seed);
        sum += x[i];
    }
    for (size_t i = 0; i < n; i++)
        squares += (x[i] - sum / (double)n) * (x[i] - sum / (double)n);
    double half = aob_student(0.05, n - 1) * sqrt(squares / (double)(n - 1) / (double)n);
    return (struct aob_ratio){exp(sum / (double)n), exp(sum / (double)n - half), exp(sum / (double)n + half),
                              true};
}

/* What the table promises: of ten comparisons of equal costs, one or more stands beside 1 in at most one table of a
 * hundred. With 4,000 tables, 3 standard deviations above that are 1.5 %. */
static void test_tables_of_equal_costs(void **state)
{
    (void)state;
    enum { TABLES = 4000, CASES = 10, PROCESSES = 5 };
    uint32_t seed = 4711;
    int apart = 0, own = 0;
    for (int t = 0; t < TABLES; t++) {
        bool table = false;
        for (int c = 0; c < CASES; c++) {
            struct aob_ratio r = measure(&seed, 0, 0.02, PROCESSES);
            struct aob_ratio wide = aob_widen(&r, PROCESSES, aob_compare_alpha(CASES));
            own += r.low > 1 || r.high < 1;
            table = table || wide.low > 1 || wide.high < 1;
            assert_near(wide.ratio, r.ratio, 1e-15);
        }
        apart += table;
    }
    assert_in_range(apart, TABLES / 500, TABLES * 15 / 1000);
    assert_in_range(own, TABLES * CASES * 46 / 1000, TABLES * CASES * 54 / 1000); /* the 95 % before */
}

/* Normal quantiles of any printed table: 1.960 at 95 %, 2.576 at 99 %, 3.291 at 99.9 %. */
static void test_lasting(void **state)
{
    (void)state;
    struct aob_ratio r = {2, 2 * exp(-0.05), 2 * exp(0.04), true};
    assert_near(aob_lasting_half_width(&r, 0.05), 0.05, 1e-12);
    assert_near(aob_lasting_half_width(&r, 0.01), 0.05 * 2.576 / 1.960, 0.05 * 3e-3);
    assert_near(aob_lasting_half_width(&r, 0.001), 0.05 * 3.291 / 1.960, 0.05 * 5e-3);
    r.bounded = false;
    assert_true(isinf(aob_lasting_half_width(&r, 0.01)));
}

static void test_no_interval(void **state)
{
    (void)state;
    struct aob_ratio r = {1, 0.9, 1.1, true};
    assert_false(aob_widen(&r, 1, 0.01).bounded);
    r.bounded = false;
    assert_false(aob_widen(&r, 5, 0.01).bounded);
    r.bounded = true;
    struct aob_ratio same = aob_widen(&r, 5, 0.05);
    assert_near(same.low, 0.9, 1e-9);
    assert_near(same.high, 1.1, 1e-9);
}

/* Any printed table of Student's t: with 4 degrees of freedom 2.776 is exceeded in 5 %, 4.604 in 1 %, 8.610 in .1 %. The
 * interval of 95 % ends at 2.776 standard errors, so a ratio that lies 4.604 of them beside 1 has a p-value of 1 %. */
static void test_p_value(void **state)
{
    (void)state;
    const struct {
        double t, p;
    } rows[] = {{2.776, 0.05}, {4.604, 0.01}, {8.610, 0.001}};
    for (size_t i = 0; i < 3; i++) {
        double se = 0.01, off = rows[i].t * se, half = 2.776 * se;
        struct aob_ratio dearer = {exp(off), exp(off - half), exp(off + 3 * half), true};
        struct aob_ratio cheaper = {exp(-off), exp(-off - 3 * half), exp(-off + half), true};
        assert_near(aob_ratio_p(&dearer, 5), rows[i].p, rows[i].p * 2e-3);
        assert_near(aob_ratio_p(&cheaper, 5), rows[i].p, rows[i].p * 2e-3);
    }
    struct aob_ratio exact = {1.1, 1.1, 1.1, true}, equal = {1, 0.9, 1.1, true};
    assert_near(aob_ratio_p(&exact, 5), 0, 1e-15);
    assert_near(aob_ratio_p(&equal, 5), 1, 1e-15);
    equal.low = equal.high = 1; /* an exact clock */
    assert_near(aob_ratio_p(&equal, 5), 1, 1e-15);
    assert_true(isnan(aob_ratio_p(&exact, 1)));
    exact.bounded = false;
    assert_true(isnan(aob_ratio_p(&exact, 5)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_tables_of_equal_costs),
                                       cmocka_unit_test(test_lasting), cmocka_unit_test(test_p_value),
                                       cmocka_unit_test(test_no_interval)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
