/* The table of properties and its bounds, and what a property's answer is judged to be. */
#include "stress/property.h"
#include "check.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"

static void each_property_is_whole(void **state)
{
    (void)state;
    size_t count = 0;
    for (const struct aob_property *const *table = aob_property_tables; *table; table++)
        for (const struct aob_property *p = *table; p->name; p++, count++) {
            if (aob_property_find(p->name) != p)
                fail_msg("two properties are called %s", p->name);
            if (strspn(p->name, "abcdefghijklmnopqrstuvwxyz0123456789_") != strlen(p->name))
                fail_msg("%s is not lower_snake", p->name);
            if (!p->sentence || p->sentence[strlen(p->sentence) - 1] != '.' || !p->measure || !p->source ||
                !p->ask)
                fail_msg("%s lacks its sentence, measure, source or question", p->name);
            assert_non_null(aob_property_group_name(p->group));
        }
    assert_int_equal(count, aob_property_count());
    assert_true(count >= 60);
    assert_null(aob_property_find("no_such"));
}

static void each_bound_has_a_property_and_a_reason(void **state)
{
    (void)state;
    size_t count = 0;
    for (const struct aob_bound *b = aob_bounds; b->property; b++, count++) {
        if (!aob_property_find(b->property) || aob_bound_find(b->property) != b)
            fail_msg("the bound of %s is of no property, or there are two", b->property);
        if (!(b->software >= 0 && b->gpu >= b->software && isfinite(b->gpu)))
            fail_msg("the bounds of %s are %g and %g", b->property, b->software, b->gpu);
        if (!b->reason || strlen(b->reason) < 20 || b->reason[strlen(b->reason) - 1] != '.')
            fail_msg("the bound of %s has no reason", b->property);
    }
    assert_int_equal(count, aob_property_count());
}

/* What the property of these tests answers. */
static double answers[3];
static size_t answer_count;
static const char *trouble, *excuse, *late; /* late: an excuse behind the answers */

static void ask(struct aob_trial *trial)
{
    if (trouble)
        aob_fail(&trial->error, "%s", trouble);
    if (excuse)
        aob_trial_excuse(trial, "%s", excuse);
    for (size_t i = 0; i < answer_count; i++)
        aob_trial_take(trial, answers[i], NULL, "answer %zu", i);
    if (late)
        aob_trial_excuse(trial, "%s", late);
}

/* Its bound is that of scaled_by_two: 0 in software, 1/255 on a GPU. */
static const struct aob_property property = {.name = "scaled_by_two", .ask = ask};

/* A device that is asked nothing but what it is. */
static struct aob_answer answer_of(bool software, const struct aob_by_definition *declared)
{
    struct aob_gpu gpu = {.info = {.software = software}};
    const struct aob_technique technique = {.name = "made", .by_definition = declared};
    struct aob_subject subject = {.technique = &technique, .gpu = &gpu};
    struct aob_trial trial;
    struct aob_answer answer;
    aob_trial_init(&trial, &subject, false);
    aob_property_ask(&property, &trial, &answer);
    aob_trial_finish(&trial);
    return answer;
}

static void set_answers(size_t count, double a, double b, double c)
{
    answer_count = count;
    answers[0] = a;
    answers[1] = b;
    answers[2] = c;
    trouble = excuse = late = NULL;
}

static const struct aob_by_definition other[] = {{"plane_is_open", "It says so."}, {0}},
                                      same[] = {{"scaled_by_two", "It says so."}, {0}};

static void the_worst_answer_is_held_to_the_bound(void **state)
{
    (void)state;
    set_answers(3, 0.001, 0.003, 0.002);
    struct aob_answer answer = answer_of(false, NULL);
    assert_int_equal(answer.outcome, AOB_PASSES);
    assert_near(answer.worst, 0.003, 0);
    assert_near(answer.bound, 1.0 / 255, 0);
    assert_string_equal(answer.reason, "answer 1");
    assert_int_equal(answer_of(true, NULL).outcome, AOB_FAILS);
    set_answers(2, 0.0039, 0.004, 0);
    assert_int_equal(answer_of(false, NULL).outcome, AOB_FAILS);
    set_answers(1, 0, 0, 0);
    assert_int_equal(answer_of(true, NULL).outcome, AOB_PASSES);
}

static void what_is_no_number_or_no_answer_fails(void **state)
{
    (void)state;
    set_answers(3, 0, NAN, 0.5);
    struct aob_answer answer = answer_of(false, NULL);
    assert_int_equal(answer.outcome, AOB_FAILS);
    assert_true(isnan(answer.worst));
    assert_string_equal(answer.reason, "answer 1");
    set_answers(0, 0, 0, 0);
    answer = answer_of(false, NULL);
    assert_int_equal(answer.outcome, AOB_FAILS);
    assert_string_equal(answer.reason, "the property took no answer");
    set_answers(1, 0, 0, 0);
    trouble = "the device is gone";
    answer = answer_of(false, NULL);
    assert_int_equal(answer.outcome, AOB_FAILS);
    assert_string_equal(answer.reason, "the device is gone");
}

static void an_excuse_is_not_applicable(void **state)
{
    (void)state;
    set_answers(1, 9, 0, 0);
    excuse = "it has one size only";
    struct aob_answer answer = answer_of(false, NULL);
    assert_int_equal(answer.outcome, AOB_NOT_APPLICABLE);
    assert_string_equal(answer.reason, "it has one size only");
}

static void a_late_excuse_takes_back_no_failure(void **state)
{
    (void)state;
    set_answers(1, 9, 0, 0);
    late = "the next device lacks it";
    assert_int_equal(answer_of(false, NULL).outcome, AOB_FAILS);
    set_answers(1, NAN, 0, 0);
    late = "the next device lacks it";
    assert_int_equal(answer_of(false, NULL).outcome, AOB_FAILS);
    set_answers(1, 0, 0, 0);
    late = "the next device lacks it";
    assert_int_equal(answer_of(false, NULL).outcome, AOB_NOT_APPLICABLE);
}

static void a_declaration_excuses_its_own_property_where_it_fails(void **state)
{
    (void)state;
    set_answers(1, 9, 0, 0);
    assert_int_equal(answer_of(true, other).outcome, AOB_FAILS);
    struct aob_answer answer = answer_of(true, same);
    assert_int_equal(answer.outcome, AOB_BY_DEFINITION);
    assert_string_equal(answer.reason, "It says so.");
    assert_near(answer.worst, 9, 0);
    set_answers(1, 0, 0, 0);
    answer = answer_of(true, same);
    assert_int_equal(answer.outcome, AOB_PASSES);
    assert_true(answer.declared);
    set_answers(1, 9, 0, 0);
    trouble = "the device is gone"; /* no definition wants that */
    assert_int_equal(answer_of(true, same).outcome, AOB_FAILS);
}

/* Two pixels of surface and one of sky, which does not count. */
static void differences_are_over_surfaces(void **state)
{
    (void)state;
    float depth[3] = {2, 1e9f, 3};
    const float image[3] = {0.5f, 0, 1}, wanted[3] = {0.75f, 1, 1};
    bool mask[3] = {false, true, true};
    struct aob_exhibit exhibit = {.width = 3, .height = 1, .gbuffer = {.depth = depth}};
    struct aob_difference d = aob_difference_of(&exhibit, image, wanted, NULL);
    assert_int_equal(d.count, 2);
    assert_int_equal(d.at, 0);
    assert_near(d.most, 0.25, 0);
    assert_near(d.mean, -0.125, 0);
    assert_near(d.rmse, sqrt(0.0625 / 2), 1e-15);
    assert_near(aob_mean_of(&exhibit, image, NULL), 0.75, 0);
    d = aob_difference_of(&exhibit, image, wanted, mask);
    assert_int_equal(d.count, 1);
    assert_near(d.most, 0, 0);
    mask[2] = false; /* nothing is left, and nothing passes unseen */
    assert_true(isnan(aob_difference_of(&exhibit, image, wanted, mask).most));
    assert_true(isnan(aob_mean_of(&exhibit, image, mask)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_property_is_whole),
        cmocka_unit_test(each_bound_has_a_property_and_a_reason),
        cmocka_unit_test(the_worst_answer_is_held_to_the_bound),
        cmocka_unit_test(what_is_no_number_or_no_answer_fails),
        cmocka_unit_test(an_excuse_is_not_applicable),
        cmocka_unit_test(a_late_excuse_takes_back_no_failure),
        cmocka_unit_test(a_declaration_excuses_its_own_property_where_it_fails),
        cmocka_unit_test(differences_are_over_surfaces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
