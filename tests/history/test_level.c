#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "history/level.h"
#include "random.h"

/* The median by its definition: of all values the one from which the weighted distances are least; of two such the middle. */
static double direct_cost(const double *y, const double *w, size_t n, double *median)
{
    double best = INFINITY, first = 0, last = 0;
    for (size_t k = 0; k < n; k++) {
        double cost = 0;
        for (size_t i = 0; i < n; i++)
            cost += w[i] * fabs(y[i] - y[k]);
        if (cost < best - 1e-12) {
            best = cost;
            first = last = y[k];
        } else if (cost < best + 1e-12) {
            first = fmin(first, y[k]);
            last = fmax(last, y[k]);
        }
    }
    *median = 0.5 * (first + last);
    return best;
}

/* The criterion of the levels that the bits of `cuts` begin, bit i before value i + 1. */
static double criterion(const double *y, const double *w, size_t n, unsigned cuts)
{
    double sum = 0, count = 0, beta = 4 * log((double)n) / (double)n, median;
    for (size_t start = 0, end; start < n; start = end) {
        for (end = start + 1; end < n && !(cuts >> (end - 1) & 1); end++)
            ;
        sum += direct_cost(y + start, w + start, end - start, &median);
        count++;
    }
    return beta * count + log(AOB_LEVEL_FLOOR * (double)n + sum);
}

static unsigned cuts_of(const struct aob_levels *levels)
{
    unsigned cuts = 0;
    for (size_t i = 1; i < levels->count; i++)
        cuts |= 1u << (levels->starts[i] - 1);
    return cuts;
}

/* Up to three shifts in noise of several sizes. */
static void random_line(uint32_t *seed, size_t n, double *y, double *w)
{
    double level = 0, noise = 0.1 * pow(4, (double)random_below(seed, 4));
    for (size_t i = 0; i < n; i++) {
        if (random_below(seed, 4) == 0)
            level += 16 * (random_unit(seed) - 0.5);
        y[i] = level + noise * random_normal(seed);
        w[i] = 0.25 + 2 * random_unit(seed);
    }
}

static void test_all_segmentations(void **state)
{
    (void)state;
    uint32_t seed = 7;
    size_t shifted = 0;
    for (int trial = 0; trial < 400; trial++) {
        double y[10], w[10], least = INFINITY, median;
        size_t n = 1 + random_below(&seed, 10);
        struct aob_levels levels;
        random_line(&seed, n, y, w);
        aob_levels_fit(y, w, n, &levels);
        for (unsigned cuts = 0; cuts < 1u << (n - 1); cuts++)
            least = fmin(least, criterion(y, w, n, cuts));
        assert_near(criterion(y, w, n, cuts_of(&levels)), least, 1e-9);
        assert_int_equal(levels.starts[0], 0);
        for (size_t i = 0; i < levels.count; i++) {
            size_t start = levels.starts[i], end = i + 1 < levels.count ? levels.starts[i + 1] : n;
            assert_true(start < end && end <= n);
            direct_cost(y + start, w + start, end - start, &median);
            assert_near(levels.values[i], median, 1e-9);
        }
        shifted += levels.count > 1;
        aob_levels_finish(&levels);
    }
    assert_in_range(shifted, 100, 390); /* the lines are neither all flat nor all cut */
}

/* With gamma = beta (S + D) of itself, no other cut has a smaller L1 Potts functional: what the header says. */
static void test_least_of_its_functional(void **state)
{
    (void)state;
    uint32_t seed = 9;
    for (int trial = 0; trial < 100; trial++) {
        double y[9], w[9], beta = 4 * log(9) / 9;
        struct aob_levels levels;
        random_line(&seed, 9, y, w);
        aob_levels_fit(y, w, 9, &levels);
        double told = criterion(y, w, 9, cuts_of(&levels)) - beta * (double)levels.count;
        double gamma = beta * exp(told), best = gamma * (double)levels.count + exp(told);
        for (unsigned cuts = 0; cuts < 1u << 8; cuts++) {
            double count = 1 + __builtin_popcount(cuts);
            assert_true(gamma * count + exp(criterion(y, w, 9, cuts) - beta * count) > best - 1e-9);
        }
        aob_levels_finish(&levels);
    }
}

static void expect(const double *y, double weight, size_t n, size_t count, size_t second)
{
    double w[200] = {0};
    struct aob_levels levels;
    for (size_t i = 0; i < n; i++)
        w[i] = weight;
    aob_levels_fit(y, w, n, &levels);
    assert_int_equal(levels.count, count);
    if (count > 1)
        assert_int_equal(levels.starts[1], second);
    aob_levels_finish(&levels);
    assert_null(levels.starts);
    assert_null(levels.values);
    assert_int_equal(levels.count, 0);
}

/* Widths of 1 %, so a weight is 100. */
static void test_short_lines(void **state)
{
    (void)state;
    expect(NULL, 100, 0, 0, 0);
    expect((const double[]){.5}, 100, 1, 1, 0);
    expect((const double[]){.5, .5}, 100, 2, 1, 0);
    expect((const double[]){.5, .51}, 100, 2, 1, 0); /* the intervals touch */
    expect((const double[]){.5, .53}, 100, 2, 2, 1);
    expect((const double[]){.5, .505, .51}, 100, 3, 1, 0);
    expect((const double[]){.5, .5, .55}, 100, 3, 2, 2);
    expect((const double[]){.5, .505, .502, .551, .549}, 100, 5, 2, 3);
    expect((const double[]){.5, .505, .502, .507, .503}, 100, 5, 1, 0);
}

static void test_long_lines(void **state)
{
    (void)state;
    double y[200];
    for (size_t i = 0; i < 200; i++)
        y[i] = .25;
    expect(y, 100, 200, 1, 0); /* no spread at all */
    for (size_t i = 120; i < 200; i++)
        y[i] = .3;
    expect(y, 100, 200, 2, 120);
    for (size_t i = 0; i < 200; i++)
        y[i] = 1e-3 * (double)(i % 2);
    expect(y, 100, 200, 1, 0); /* within the intervals */
    y[77] = 3;
    expect(y, 1, 200, 1, 0); /* a single value is no level where its interval is wide */
}

/* A weight of half of all is a median by itself, and no weight outvotes the rest. */
static void test_weighted_median(void **state)
{
    (void)state;
    assert_true(aob_level_value((const double[]){3}, (const double[]){.1}, 1) == 3);
    assert_true(aob_level_value((const double[]){4, 1, 2, 3}, (const double[]){1, 1, 1, 1}, 4) == 2.5);
    assert_true(aob_level_value((const double[]){3, 1, 2}, (const double[]){2, 1, 1}, 3) == 2.5);
    assert_true(aob_level_value((const double[]){3, 1, 2}, (const double[]){2.5, 1, 1}, 3) == 3);
    assert_true(aob_level_value((const double[]){3, 1, 2}, (const double[]){1, 1, 1.5}, 3) == 2);
    assert_true(aob_level_value((const double[]){.3, .1, .2, .4, .5, .6},
                                (const double[]){.1, .1, .1, .1, .1, .1}, 6) == .35);
}

/* In units of another size (values and widths alike), and another value for all, the levels are the same. */
static void test_scale(void **state)
{
    (void)state;
    uint32_t seed = 11;
    for (int trial = 0; trial < 50; trial++) {
        double y[80], w[80], other_y[80], other_w[80];
        struct aob_levels levels, other;
        random_line(&seed, 80, y, w);
        for (size_t i = 0; i < 80; i++) {
            other_y[i] = 0.125 * y[i] + 3;
            other_w[i] = 8 * w[i];
        }
        aob_levels_fit(y, w, 80, &levels);
        aob_levels_fit(other_y, other_w, 80, &other);
        assert_int_equal(levels.count, other.count);
        for (size_t i = 0; i < levels.count; i++) {
            assert_int_equal(levels.starts[i], other.starts[i]);
            assert_near(0.125 * levels.values[i] + 3, other.values[i], 1e-12);
        }
        aob_levels_finish(&levels);
        aob_levels_finish(&other);
    }
}

/* Five levels, 1 apart in noise of 0.2, and the same answer to the bit when asked again. */
static void test_two_thousand(void **state)
{
    (void)state;
    enum { N = 2000 };
    static const double level[] = {0, 1, 0, -1, 2};
    double *y = AOB_NEW_ARRAY(double, N), *w = AOB_NEW_ARRAY(double, N);
    uint32_t seed = 13;
    struct aob_levels levels, again;
    for (size_t i = 0; i < N; i++) {
        y[i] = level[i / 400] + 0.2 * random_normal(&seed);
        w[i] = 1 + random_unit(&seed);
    }
    aob_levels_fit(y, w, N, &levels);
    aob_levels_fit(y, w, N, &again);
    assert_int_equal(levels.count, 5);
    for (size_t i = 0; i < 5; i++) {
        assert_in_range(levels.starts[i] + 2, 400 * i, 400 * i + 4);
        assert_near(levels.values[i], level[i], 0.05);
    }
    assert_int_equal(again.count, 5);
    assert_memory_equal(levels.starts, again.starts, 5 * sizeof *levels.starts);
    assert_memory_equal(levels.values, again.values, 5 * sizeof *levels.values);
    aob_levels_finish(&levels);
    aob_levels_finish(&again);
    free(y);
    free(w);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_segmentations), cmocka_unit_test(test_least_of_its_functional),
        cmocka_unit_test(test_short_lines),       cmocka_unit_test(test_long_lines),
        cmocka_unit_test(test_weighted_median),   cmocka_unit_test(test_scale),
        cmocka_unit_test(test_two_thousand),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
