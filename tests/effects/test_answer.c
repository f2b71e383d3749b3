/* Which set is taken: the cheapest within the tolerance, or the best that a budget leaves. */
#include "check.h"
#include <math.h>
#include <string.h>
#include "effects/answer.h"

enum {
    NOTHING = 0,
    V = 1 << AOB_EFFECT_VISIBILITY,
    BOUNCES = 1 << AOB_EFFECT_MULTI_BOUNCE,
    BENT = 1 << AOB_EFFECT_BENT_NORMAL,
    LIGHT = 1 << AOB_EFFECT_DIRECTIONAL,
    MEAN = 1 << AOB_EFFECT_TEMPORAL,
    HALF = 1 << AOB_EFFECT_HALF_SIZE
};

static void put(struct aob_effect_answer *a, unsigned set, double rmse, double ms)
{
    a->candidates[a->count++] = (struct aob_effect_candidate){.set = set, .error = {.rmse = rmse}, .ms = ms};
}

static struct aob_effect_answer answer_with(double tolerance, double budget)
{
    struct aob_effect_answer a = {.ask = {tolerance, budget, NULL}, .open = AOB_EFFECT_ALL};
    put(&a, NOTHING, 0.20, 1);
    put(&a, V, 0.10, 8);
    put(&a, V | BOUNCES, 0.06, 9);
    put(&a, V | LIGHT, 0.08, 10);
    put(&a, V | BOUNCES | LIGHT, 0.05, 12);
    put(&a, V | BOUNCES | HALF, 0.075, 4);
    put(&a, V | BENT | HALF, 0.074, 4.05);
    aob_effect_answer_choose(&a);
    return a;
}

static unsigned taken(double tolerance, double budget)
{
    struct aob_effect_answer a = answer_with(tolerance, budget);
    return a.chosen < 0 ? ~0u : a.candidates[a.chosen].set;
}

static void test_tolerance(void **state)
{
    (void)state;
    assert_int_equal(taken(0, INFINITY), V | BOUNCES | LIGHT); /* the least error itself */
    assert_int_equal(taken(0.011, INFINITY), V | BOUNCES);
    assert_int_equal(taken(NAN, INFINITY), V | BOUNCES); /* .05 and the default of .02 */
    assert_int_equal(taken(0.026, INFINITY),
                     V | BENT | HALF); /* as dear as with bounces to 2 %, and nearer */
    assert_int_equal(taken(0.151, INFINITY), NOTHING);
}

/* A budget alone takes the least error that fits; with a tolerance the cheapest within it comes first. */
static void test_budget(void **state)
{
    (void)state;
    assert_int_equal(taken(NAN, 100), V | BOUNCES | LIGHT);
    assert_int_equal(taken(NAN, 9.5), V | BOUNCES);
    assert_int_equal(taken(NAN, 4.02), V | BOUNCES | HALF);
    assert_int_equal(taken(NAN, 4.06), V | BENT | HALF);
    assert_int_equal(taken(0.011, 8.5),
                     V | BENT | HALF); /* none within the tolerance fits: the least error that does */
    assert_int_equal(taken(0.026, 100), V | BENT | HALF);
    assert_int_equal(taken(0.026, 4.02), V | BOUNCES | HALF);
    assert_int_equal(taken(NAN, 2), NOTHING);
    assert_int_equal(taken(NAN, 0.5), ~0u);
}

static void test_ties(void **state)
{
    struct aob_effect_answer a = answer_with(0.026, INFINITY);
    (void)state;
    assert_true(aob_effect_answer_ties(&a, aob_effect_answer_find(&a, V | BOUNCES | HALF))); /* 4 and 4.05 */
    assert_false(aob_effect_answer_ties(&a, aob_effect_answer_find(&a, V | BENT | HALF))); /* the one taken */
    assert_false(aob_effect_answer_ties(&a, aob_effect_answer_find(&a, V | BOUNCES)));
}

/* Where nothing within the tolerance fits, only what is as near is as good: not the lit image without occlusion, which is cheaper. */
static void test_ties_outside(void **state)
{
    struct aob_effect_answer a = answer_with(0.011, 8.5);
    (void)state;
    assert_false(a.candidates[a.chosen].within);
    assert_false(aob_effect_answer_ties(&a, aob_effect_answer_find(&a, NOTHING)));
    assert_false(aob_effect_answer_ties(&a, aob_effect_answer_find(&a, V)));
    assert_true(
        aob_effect_answer_ties(&a, aob_effect_answer_find(&a, V | BOUNCES | HALF))); /* .075 of .074 */
}

/* Of what fits outside of the tolerance the cheapest is taken that is as near as the nearest, not the nearest by a hair. */
static void test_fallback(void **state)
{
    struct aob_effect_answer a = {.ask = {0.0001, 1.848, NULL}, .open = AOB_EFFECT_ALL};
    (void)state;
    put(&a, NOTHING, 0.2, 0.5);
    put(&a, V | LIGHT, 0.05, 9);
    put(&a, V | HALF, 0.1402, 1.27);
    put(&a, V | BENT | HALF, 0.1400, 1.70);
    put(&a, V | BOUNCES | HALF, 0.1415, 1.20);
    aob_effect_answer_choose(&a);
    assert_int_equal(a.candidates[a.chosen].set, V | HALF);
    assert_false(aob_effect_answer_ties(&a, aob_effect_answer_find(&a, V | BOUNCES | HALF)));
    a.ask.budget_ms = 0.1;
    aob_effect_answer_choose(&a);
    assert_int_equal(a.chosen, -1);
}

/* A sequence: the flicker counts as the error does, above the least of its own. */
static struct aob_effect_answer moving(double tolerance, double budget)
{
    struct aob_effect_answer a = {.ask = {tolerance, budget, NULL}, .open = AOB_EFFECT_ALL, .frames = 16};
    put(&a, NOTHING, 0.06, 1);
    put(&a, V, 0.05, 8);
    put(&a, V | MEAN, 0.052, 11);
    put(&a, V | HALF, 0.053, 4);
    put(&a, V | MEAN | HALF, 0.055, 7);
    const double flickers[] = {0.08, 0.02, 0.01, 0.03, 0.012};
    for (size_t i = 0; i < a.count; i++)
        a.candidates[i].flicker = flickers[i];
    aob_effect_answer_choose(&a);
    return a;
}

static void test_flicker(void **state)
{
    struct aob_effect_answer a = moving(0.02, INFINITY);
    (void)state;
    assert_int_equal(a.candidates[a.chosen].set, V | HALF);
    assert_float_equal(a.candidates[a.chosen].loss, 0.02, 1e-12);
    assert_false(aob_effect_answer_find(&a, NOTHING)->within); /* by its error alone it would be */
    a = moving(0.019, INFINITY);
    assert_int_equal(a.candidates[a.chosen].set, V | MEAN | HALF);
    a = moving(0.001, INFINITY);
    assert_int_equal(a.chosen,
                     2); /* error .052 of .05 is too far: none is within, all fit, V | MEAN loses least */
    assert_false(a.candidates[a.chosen].within);
    a = moving(
        NAN,
        7.5); /* of those that fit: the mean at half size has the least flicker, half size the least error */
    assert_int_equal(a.candidates[a.chosen].set, V | MEAN | HALF);
}

static void test_turned(void **state)
{
    (void)state;
    assert_int_equal(aob_effect_turned(V | BOUNCES, AOB_EFFECT_MULTI_BOUNCE), V);
    assert_int_equal(aob_effect_turned(V, AOB_EFFECT_HALF_SIZE), V | HALF);
    assert_int_equal(aob_effect_turned(V | BENT, AOB_EFFECT_DIRECTIONAL), V | LIGHT);
    assert_int_equal(aob_effect_turned(V | LIGHT | HALF, AOB_EFFECT_BENT_NORMAL), V | BENT | HALF);
    assert_int_equal(aob_effect_turned(V | LIGHT | HALF, AOB_EFFECT_VISIBILITY), NOTHING);
    assert_int_equal(aob_effect_turned(NOTHING, AOB_EFFECT_MULTI_BOUNCE), V | BOUNCES);
}

/* Sentences hold their numbers. */
static void check_says(const struct aob_effect_answer *a, enum aob_effect_id id, const char *words)
{
    struct aob_text text = {0};
    aob_effect_answer_explain(a, id, &text);
    if (!strstr(text.data, words))
        print_message("           '%s' lacks '%s'\n", text.data, words);
    assert_non_null(strstr(text.data, words));
    aob_text_finish(&text);
}

static void test_sentences(void **state)
{
    struct aob_effect_answer a = answer_with(0.011, INFINITY);
    (void)state;
    a.open &= ~AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR);
    a.bounds.most[AOB_EFFECT_SPECULAR] = 0.004;
    check_says(&a, AOB_EFFECT_MULTI_BOUNCE,
               "yes: without it the image is off by 10 % in place of 6 %, and a frame takes 1 ms less");
    check_says(&a, AOB_EFFECT_DIRECTIONAL,
               "no: with it the image is off by 5 % in place of 6 %, and a frame takes 3 ms more");
    check_says(&a, AOB_EFFECT_SPECULAR, "changes the image by 0.4 % at most, of a tolerance of 1.1 %");
    a = answer_with(0.3, INFINITY);
    a.open = 0;
    check_says(&a, AOB_EFFECT_VISIBILITY,
               "no: without any occlusion the image is off by 20 %, of a tolerance of 30 %");
    check_says(&a, AOB_EFFECT_MULTI_BOUNCE,
               "no: it goes with visibility, and without any occlusion the image is within the tolerance");
    check_says(&a, AOB_EFFECT_HALF_SIZE, "no: it goes with visibility");
    a.no_sequence = "a capture is one frame";
    check_says(&a, AOB_EFFECT_TEMPORAL, "not known: a capture is one frame");
}

static void test_sentences_of_time(void **state)
{
    struct aob_effect_answer a = moving(0.02, INFINITY);
    (void)state;
    check_says(
        &a, AOB_EFFECT_TEMPORAL,
        "no: with it the image is off by 5.5 % in place of 5.3 %, flickers by 1.2 % in place of 3 %, and "
        "a frame takes 3 ms more");
    a.open &= ~AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL);
    a.count = 0;
    put(&a, V, 0.05, 8);
    a.chosen = 0;
    a.bounds.most[AOB_EFFECT_TEMPORAL] = 0.0031;
    check_says(&a, AOB_EFFECT_TEMPORAL,
               "no: nothing moves, and a frame has so many samples that a mean of many brings the image "
               "nearer by 0.31 % "
               "at most, of a tolerance of 2 %");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tolerance),
        cmocka_unit_test(test_budget),
        cmocka_unit_test(test_ties),
        cmocka_unit_test(test_ties_outside),
        cmocka_unit_test(test_fallback),
        cmocka_unit_test(test_turned),
        cmocka_unit_test(test_sentences),
        cmocka_unit_test(test_flicker),
        cmocka_unit_test(test_sentences_of_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
