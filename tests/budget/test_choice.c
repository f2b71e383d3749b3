#include "check.h"
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include "budget/choice.h"
#include "random.h"

enum { LISTS = 10000, MOST = 24, VIEWS = 4 };
static const double budget = 2;

/* Few values, so that costs, ends, errors and the budget itself are often equal. */
static double step(uint32_t *random)
{
    return 0.5 * (double)(1 + random_below(random, 8));
}

static struct aob_candidate draw(uint32_t *random)
{
    struct aob_candidate c = {.view = random_below(random, VIEWS),
                              .setting = random_below(random, 6),
                              .ms = step(random),
                              .error = 0.1 * step(random)};
    c.low = c.ms - 0.25 * (double)random_below(random, 3);
    c.high = c.ms + 0.25 * (double)random_below(random, 3);
    if (random_below(random, 6) == 0) {
        c.low = 0;
        c.high = INFINITY;
    }
    return c;
}

static size_t draw_list(uint32_t *random, struct aob_candidate list[MOST])
{
    size_t count = random_below(random, MOST + 1);
    for (size_t i = 0; i < count; i++)
        list[i] = draw(random);
    for (size_t i = 0; i < count; i++)
        list[i].of = 100 + i;
    return count;
}

/* The texts of the rules, word for word: a candidate is the answer if it may be one and no other that may be beats it. */
typedef bool may(const struct aob_candidate *c, double error);
static bool fits(const struct aob_candidate *c, double error)
{
    (void)error;
    return c->high <= budget;
}
static bool point_fits(const struct aob_candidate *c, double error)
{
    (void)error;
    return c->ms <= budget && c->high > budget;
}
static bool is_good(const struct aob_candidate *c, double error)
{
    return c->error <= error;
}
static bool beats(double a1, double a2, size_t a, double b1, double b2, size_t b)
{
    return a1 < b1 || (a1 == b1 && (a2 < b2 || (a2 == b2 && a < b)));
}

static size_t brute(const struct aob_candidate *list, size_t count, may *may, double error, bool by_error)
{
    for (size_t i = 0; i < count; i++) {
        bool best = may(&list[i], error);
        for (size_t k = 0; k < count && best; k++)
            if (k != i && may(&list[k], error))
                best = by_error ? !beats(list[k].error, list[k].ms, k, list[i].error, list[i].ms, i)
                                : !beats(list[k].ms, list[k].error, k, list[i].ms, list[i].error, i);
        if (best)
            return i;
    }
    return AOB_NO_CANDIDATE;
}

/* By upper end, then by cost, then by error. */
static size_t brute_nearest(const struct aob_candidate *list, size_t count)
{
    size_t best = AOB_NO_CANDIDATE;
    double least = INFINITY;
    for (size_t i = 0; i < count; i++)
        least = fmin(least, list[i].high);
    for (size_t i = 0; i < count; i++)
        if (list[i].high == least &&
            (best == AOB_NO_CANDIDATE ||
             beats(list[i].ms, list[i].error, i, list[best].ms, list[best].error, best)))
            best = i;
    return best;
}

static void test_against_brute_force(void **state)
{
    (void)state;
    uint32_t random = 20261129;
    size_t fitting = 0, hoping = 0;
    for (int n = 0; n < LISTS; n++) {
        struct aob_candidate list[MOST];
        size_t count = draw_list(&random, list);
        double error = random_below(&random, 4) ? 0.1 * step(&random) : INFINITY;
        struct aob_choice choice;
        aob_choice_make(&choice, list, count, budget, error);
        size_t accurate = brute(list, count, fits, error, true);
        size_t hopeful = brute(list, count, point_fits, error, true);
        if (hopeful != AOB_NO_CANDIDATE && accurate != AOB_NO_CANDIDATE &&
            !(list[hopeful].error < list[accurate].error))
            hopeful = AOB_NO_CANDIDATE;
        assert_int_equal(choice.accurate, accurate);
        assert_int_equal(choice.hopeful, hopeful);
        assert_int_equal(choice.cheap, brute(list, count, is_good, error, false));
        assert_int_equal(choice.least, brute_nearest(list, count));
        fitting += accurate != AOB_NO_CANDIDATE;
        hoping += hopeful != AOB_NO_CANDIDATE;
    }
    assert_true(fitting > LISTS / 4 && hoping > LISTS / 10); /* both were put to the test */
}

static bool dominates(const struct aob_candidate *a, const struct aob_candidate *b)
{
    return a->ms <= b->ms && a->error <= b->error && (a->ms < b->ms || a->error < b->error);
}

static void test_front(void **state)
{
    (void)state;
    uint32_t random = 7;
    for (int n = 0; n < LISTS; n++) {
        struct aob_candidate list[MOST];
        size_t count = draw_list(&random, list), front[MOST];
        size_t used = aob_front_find(list, count, front), expected = 0;
        for (size_t i = 0; i < count; i++) {
            bool beaten = false;
            for (size_t k = 0; k < count && !beaten; k++)
                beaten = dominates(&list[k], &list[i]) ||
                         (k < i && list[k].ms == list[i].ms && list[k].error == list[i].error);
            bool there = false;
            for (size_t k = 0; k < used; k++)
                there = there || front[k] == i;
            assert_int_equal(there, !beaten);
            expected += !beaten;
        }
        assert_int_equal(used, expected);
        for (size_t k = 1; k < used; k++)
            assert_true(list[front[k - 1]].ms < list[front[k]].ms);
    }
}

/* For each setting by itself, view by view. */
static bool brute_worst(const struct aob_candidate *list, size_t count, size_t setting,
                        struct aob_candidate *worst)
{
    *worst = (struct aob_candidate){.setting = setting};
    for (size_t view = 0; view < VIEWS; view++) {
        bool answered = false;
        for (size_t i = 0; i < count; i++) {
            if (list[i].setting != setting || list[i].view != view)
                continue;
            answered = true;
            if (list[i].ms > worst->ms) {
                worst->view = view;
                worst->of = list[i].of;
            }
            worst->ms = fmax(worst->ms, list[i].ms);
            worst->low = fmax(worst->low, list[i].low);
            worst->high = fmax(worst->high, list[i].high);
            worst->error = fmax(worst->error, list[i].error);
        }
        if (!answered)
            return false;
    }
    return true;
}

static void test_worst_view(void **state)
{
    (void)state;
    uint32_t random = 99;
    size_t whole = 0;
    for (int n = 0; n < LISTS; n++) {
        struct aob_candidate list[MOST], worst[MOST], expected;
        size_t count = draw_list(&random, list);
        size_t used = aob_worst_find(list, count, VIEWS, worst), at = 0;
        for (size_t setting = 0; setting < 6; setting++) {
            if (!brute_worst(list, count, setting, &expected))
                continue;
            assert_true(at < used);
            assert_int_equal(worst[at].setting, setting);
            assert_int_equal(worst[at].view, expected.view);
            assert_int_equal(worst[at].of, expected.of);
            assert_true(worst[at].ms == expected.ms && worst[at].low == expected.low &&
                        worst[at].high == expected.high && worst[at].error == expected.error);
            at++;
        }
        assert_int_equal(at, used);
        whole += used;
    }
    assert_true(whole > LISTS / 10);
}

/* On the budget itself a case fits; one bit above it does not. What is not known fits nothing. */
static void test_edges(void **state)
{
    (void)state;
    struct aob_candidate c = {.ms = budget, .low = 1, .high = budget, .error = 0.1};
    assert_int_equal(aob_candidate_fit(&c, budget), AOB_FIT_WHOLE);
    c.high = nextafter(budget, 3);
    assert_int_equal(aob_candidate_fit(&c, budget), AOB_FIT_POINT);
    c.ms = c.high;
    assert_int_equal(aob_candidate_fit(&c, budget), AOB_FIT_OVER);
    c.ms = NAN;
    assert_int_equal(aob_candidate_fit(&c, budget), AOB_FIT_OVER);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_against_brute_force),
        cmocka_unit_test(test_front),
        cmocka_unit_test(test_worst_view),
        cmocka_unit_test(test_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
