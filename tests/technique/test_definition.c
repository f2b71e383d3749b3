#include "check.h"
#include <math.h>
#include "technique/definition.h"

struct values {
    float radius;
    int32_t weighting;
};
static const char *const weightings[] = {"cosine", "uniform", NULL};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .min = -9, .max = 9, .doc = "."),
    AOB_PARAM(struct values, weighting, .choices = weightings, .doc = "."),
};

static float half_open(const void *values, float t)
{
    (void)values;
    return 1 - 0.5f * t;
}
static float hard(const void *values, float t)
{
    (void)values;
    (void)t;
    return 1;
}
static float broken(const void *values, float t)
{
    (void)values;
    return t > 0.9f ? NAN : 0;
}
static float no_claim(const void *values)
{
    (void)values;
    return NAN;
}
static float endless(const void *values)
{
    (void)values;
    return INFINITY;
}
static enum aob_distance of_triangle(const void *values)
{
    (void)values;
    return AOB_DISTANCE_TRIANGLE;
}

static struct aob_definition_table table;
static struct aob_error error;

static bool tabulate(struct aob_definition definition, struct values values, uint32_t param_count)
{
    const struct aob_technique technique = {
        .name = "trial", .params = params, .param_count = param_count, .definition = definition};
    error = (struct aob_error){{0}};
    return aob_definition_tabulate(&technique, &values, &table, &error);
}

static void test_parameters_say_what_the_definition_leaves(void **state)
{
    (void)state;
    assert_true(tabulate((struct aob_definition){.weight = AOB_WEIGHT_UNIFORM}, (struct values){2, 0}, 1));
    assert_true(table.claims && table.radius == 2 && table.uniform && !table.fades && !table.of_triangle);
    assert_true(tabulate((struct aob_definition){.weight = AOB_WEIGHT_UNIFORM, .distance = of_triangle},
                         (struct values){2, 0}, 2));
    assert_true(!table.uniform &&
                table.of_triangle); /* the parameter `weighting` takes the definition's place */
    assert_true(tabulate((struct aob_definition){0}, (struct values){2, 1}, 2));
    assert_true(table.uniform);
}

static void test_falloff_lies_over_the_root(void **state)
{
    (void)state;
    assert_true(tabulate((struct aob_definition){.falloff = half_open}, (struct values){1, 0}, 1));
    assert_true(table.fades);
    assert_near(table.falloff[0], 1, 1e-7);
    assert_near(table.falloff[512], 1 - 0.5 * 0.25, 1e-7);
    assert_near(table.falloff[AOB_FALLOFF_ROWS - 1], 0.5, 1e-7);
    assert_true(tabulate((struct aob_definition){.falloff = hard}, (struct values){1, 0}, 1));
    assert_false(table.fades);
    assert_true(
        tabulate((struct aob_definition){.falloff = half_open, .radius = endless}, (struct values){1, 0}, 1));
    assert_true(table.claims && isinf(table.radius) && !table.fades);
}

static void test_nonsense_is_named(void **state)
{
    (void)state;
    assert_false(tabulate((struct aob_definition){.falloff = broken}, (struct values){1, 0}, 1));
    assert_contains(error.text, "falloff is not finite");
    assert_false(tabulate((struct aob_definition){0}, (struct values){-1, 0}, 1));
    assert_contains(error.text, "radius is -1: it must be above 0");
    assert_true(tabulate((struct aob_definition){0}, (struct values){1, 0}, 0)); /* no parameter radius */
    assert_false(table.claims);
    assert_true(
        tabulate((struct aob_definition){.radius = no_claim, .falloff = broken}, (struct values){1, 0}, 1));
    assert_false(table.claims);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_parameters_say_what_the_definition_leaves),
                                       cmocka_unit_test(test_falloff_lies_over_the_root),
                                       cmocka_unit_test(test_nonsense_is_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
