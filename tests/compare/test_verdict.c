#include "check.h"
#include <math.h>
#include "compare/verdict.h"

/* A comparison whose every condition holds: [low, high] about `ratio`, and a quiet control. */
static struct aob_comparison comparison(double low, double ratio, double high)
{
    return (struct aob_comparison){.cost = {ratio, low, high, true},
                                   .control = {1, 0.995, 1.005, true},
                                   .resolution = 0.02,
                                   .rounds = 60,
                                   .processes = 5,
                                   .errors = {{NAN, NAN, NAN}, {NAN, NAN, NAN}, NAN}};
}

static enum aob_verdict judge(double low, double ratio, double high)
{
    struct aob_comparison c = comparison(low, ratio, high);
    return aob_judge(&c).verdict;
}

/* Each edge of the rule from both sides; the lower ones are the upper ones' inverses. */
static void test_edges(void **state)
{
    (void)state;
    assert_int_equal(judge(1.001, 1.0201, 1.04), AOB_VERDICT_SLOWER);
    assert_int_equal(judge(1.001, 1.0199, 1.04), AOB_VERDICT_AMBIGUOUS); /* the ratio is not beyond 2 % */
    assert_int_equal(judge(0.999, 1.0201, 1.04), AOB_VERDICT_AMBIGUOUS); /* the interval holds 1 */
    assert_int_equal(judge(1 / 1.04, 1 / 1.0201, 1 / 1.001), AOB_VERDICT_FASTER);
    assert_int_equal(judge(1 / 1.04, 1 / 1.0199, 1 / 1.001), AOB_VERDICT_AMBIGUOUS);
    assert_int_equal(judge(1 / 1.04, 1 / 1.0201, 1 / 0.999), AOB_VERDICT_AMBIGUOUS);
    assert_int_equal(judge(1 / 1.0199, 1, 1.0199), AOB_VERDICT_SAME);
    assert_int_equal(judge(1 / 1.0201, 1, 1.0199), AOB_VERDICT_AMBIGUOUS);
    assert_int_equal(judge(1 / 1.0199, 1, 1.0201), AOB_VERDICT_AMBIGUOUS);
    assert_int_equal(judge(1.002, 1.01, 1.018), AOB_VERDICT_SAME); /* apart from 1, and by too little */
}

/* A control that spreads farther than what is asked for is what decides instead. */
static void test_noise_floor(void **state)
{
    (void)state;
    struct aob_comparison c = comparison(1.01, 1.04, 1.07);
    assert_int_equal(aob_judge(&c).verdict, AOB_VERDICT_SLOWER);
    assert_near(aob_judge(&c).delta, 0.02, 1e-12);
    c.control = (struct aob_ratio){1, 0.99, 1.05, true};
    assert_int_equal(aob_judge(&c).verdict, AOB_VERDICT_AMBIGUOUS);
    assert_near(aob_judge(&c).delta, 0.05, 1e-12);
    /* Within the floor, but beyond what is asked: it is not called the same. */
    c.cost = (struct aob_ratio){1.015, 1.011, 1.019, true};
    assert_int_equal(aob_judge(&c).verdict, AOB_VERDICT_SAME);
    c.cost.high = 1.021;
    assert_int_equal(aob_judge(&c).verdict, AOB_VERDICT_AMBIGUOUS);
    c.control = (struct aob_ratio){1, 1 / 1.05, 1.01, true};
    assert_near(aob_judge(&c).delta, 0.05, 1e-12);
    assert_contains(aob_judge(&c).reason, "noise floor");
    const struct aob_ratio wide = {1, 0.9, 1.02, true}, none = {1, 0, INFINITY, false};
    assert_ptr_equal(aob_wider_control(&c.control, &wide), &wide);
    assert_ptr_equal(aob_wider_control(&wide, &c.control), &wide);
    assert_ptr_equal(aob_wider_control(&wide, &none), &none);
}

static void check_invalid(struct aob_comparison c, const char *says)
{
    struct aob_judgement j = aob_judge(&c);
    assert_int_equal(j.verdict, AOB_VERDICT_INVALID);
    assert_contains(j.reason, says);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_OPEN);
}

static void test_invalid(void **state)
{
    (void)state;
    struct aob_comparison good = comparison(1.05, 1.1, 1.15), c = good;
    c.invalid = "they were timed by different clocks";
    check_invalid(c, "different clocks");
    c = good;
    c.rounds = AOB_COMPARE_ROUNDS;
    assert_int_equal(aob_judge(&c).verdict, AOB_VERDICT_SLOWER);
    c.rounds--;
    check_invalid(c, "19 rounds");
    c = good;
    c.processes = AOB_COMPARE_PROCESSES;
    assert_int_equal(aob_judge(&c).verdict, AOB_VERDICT_SLOWER);
    c.processes--;
    check_invalid(c, "2 processes");
    c = good;
    c.cost.bounded = false;
    check_invalid(c, "no interval");
    c = good;
    c.control = (struct aob_ratio){1.03, 1.01, 1.05, true};
    check_invalid(c, "[1.0100, 1.0500]");
    c.control = (struct aob_ratio){0.97, 1 / 1.05, 1 / 1.01, true};
    check_invalid(c, "differs from itself");
    /* Apart from 1, but by less than what is asked for: only the floor. */
    c.control = (struct aob_ratio){1.01, 1.001, 1.02, true};
    assert_int_equal(aob_judge(&c).verdict, AOB_VERDICT_SLOWER);
}

/* Rounds are independent here and the interval is that of a median: 1.96 x 1.2533 x sigma / sqrt(n) to each side. So half
 * of delta takes (1.96 x 1.2533 x sigma / (delta / 2))^2 of them. */
static void test_rounds_needed(void **state)
{
    (void)state;
    const double sigma = 0.047, n = 36, half = 1.96 * 1.2533 * sigma / sqrt(n);
    struct aob_comparison c = comparison(1.005 * exp(-half), 1.005, 1.005 * exp(half));
    c.rounds = (size_t)n;
    struct aob_judgement j = aob_judge(&c);
    assert_int_equal(j.verdict, AOB_VERDICT_AMBIGUOUS);
    double wanted = 0.5 * log(1.02);
    assert_near(j.rounds_needed, ceil(pow(1.96 * 1.2533 * sigma / wanted, 2)), 1);
    assert_contains(j.reason, "rounds would decide");
    /* The same interval, a tenth of which more processes would take away: .9^2 of the rounds. Twice as many at least where
     * nearly all of it is. */
    c.lasting = half * 0.9;
    assert_near(aob_judge(&c).rounds_needed, ceil(pow(1.96 * 1.2533 * sigma / wanted * 0.9, 2)), 1);
    c.lasting = half / 100;
    assert_near(aob_judge(&c).rounds_needed, 2 * n, 1e-9);
    /* Narrow enough, and still between: a difference of what is asked for is neither. */
    c = comparison(1.012, 1.0195, 1.027);
    j = aob_judge(&c);
    assert_int_equal(j.verdict, AOB_VERDICT_AMBIGUOUS);
    assert_true(isnan(j.rounds_needed));
    assert_contains(j.reason, "--precision");
    c = comparison(1.05, 1.1, 1.15);
    assert_true(isnan(aob_judge(&c).rounds_needed)); /* decided */
}

/* Whatever its cost, another image is no speed-up; and what is worse about it decides. */
static void test_moved(void **state)
{
    (void)state;
    struct aob_comparison c = comparison(0.7, 0.75, 0.8);
    c.moved = true;
    struct aob_judgement j = aob_judge(&c);
    assert_int_equal(j.verdict, AOB_VERDICT_MOVED);
    assert_int_equal(j.cost, AOB_VERDICT_FASTER);
    assert_int_equal(j.error, AOB_ERROR_UNKNOWN);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_OPEN);
    c.errors.a = (struct aob_error_side){0.04, 0, 1000};
    c.errors.b = c.errors.a;
    c.errors.b.rmse = 0.0412;
    j = aob_judge(&c);
    assert_int_equal(j.error, AOB_ERROR_MORE);
    assert_contains(j.reason, "RMSE 0.0400 -> 0.0412 (worse)");
    assert_contains(j.reason, "FASTER");
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_WORSE);
    c.errors.b.rmse = 0.0388;
    j = aob_judge(&c);
    assert_int_equal(j.error, AOB_ERROR_LESS);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_GOOD);
    c.errors.b.rmse = 0.04 + 0.9 * AOB_ERROR_LEAST;
    j = aob_judge(&c);
    assert_int_equal(j.error, AOB_ERROR_EQUAL);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_GOOD);
    c.invalid = "it was not timed";
    j = aob_judge(&c);
    assert_int_equal(j.verdict, AOB_VERDICT_MOVED); /* the image is known all the same */
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_OPEN);
}

static void test_outcomes(void **state)
{
    (void)state;
    struct aob_comparison c = comparison(1.05, 1.1, 1.15);
    struct aob_judgement j = aob_judge(&c);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_WORSE);
    assert_int_equal(aob_judgement_outcome(&j, true), AOB_OUTCOME_OPEN);
    c.elsewhere = "the machine or the harness";
    assert_string_equal(aob_judge(&c).reason, c.elsewhere);
    c = comparison(0.8, 0.85, 0.9);
    j = aob_judge(&c);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_GOOD);
    c = comparison(0.99, 1, 1.01);
    j = aob_judge(&c);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_GOOD);
    c.elsewhere = "the machine or the harness";
    assert_contains(aob_judge(&c).reason, "whole interval"); /* of what did not move nothing is to blame */
    c = comparison(0.9, 1, 1.1);
    j = aob_judge(&c);
    assert_int_equal(aob_judgement_outcome(&j, false), AOB_OUTCOME_OPEN);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_edges),   cmocka_unit_test(test_noise_floor),
                                       cmocka_unit_test(test_invalid), cmocka_unit_test(test_rounds_needed),
                                       cmocka_unit_test(test_moved),   cmocka_unit_test(test_outcomes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
