#include "check.h"
#include "technique/param.h"

struct values {
    float radius;
    int32_t steps, mode;
};
static const char *const modes[] = {"cosine", "uniform", NULL};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .min = 0.1, .max = 10, .initial = 0.5, .doc = "."),
    AOB_PARAM(struct values, steps, .min = 1, .max = 64, .initial = 6, .doc = "."),
    AOB_PARAM(struct values, mode, .choices = modes, .doc = "."),
};

static void test_whole_text_or_nothing(void **state)
{
    (void)state;
    static const char *const bad_radius[] = {"",    " 1",   "1 ",   "1x", "0x",    "nan",
                                             "inf", "-inf", "0.05", "11", "1e400", "1,5"};
    static const char *const bad_steps[] = {"1.5", "0", "65", "8xyz", "six"};
    double value = 7;
    struct aob_error error;
    for (size_t i = 0; i < sizeof bad_radius / sizeof *bad_radius; i++) {
        assert_false(aob_param_parse(&params[0], bad_radius[i], &value, &error));
        assert_contains(error.text, "radius");
        assert_true(value == 7);
    }
    for (size_t i = 0; i < sizeof bad_steps / sizeof *bad_steps; i++)
        assert_false(aob_param_parse(&params[1], bad_steps[i], &value, &error));
    assert_false(aob_param_parse(&params[2], "1", &value, &error));
    assert_contains(error.text, "cosine, uniform");
    assert_true(aob_param_parse(&params[0], "0.1", &value, &error));
    assert_true(value == (double)0.1f);
    assert_true(aob_param_parse(&params[2], "uniform", &value, &error));
    assert_true(value == 1);
}

static void test_prints_what_parses_back(void **state)
{
    (void)state;
    static const char *const texts[] = {"0.1", "0.25", "3.1415927", "10", "0.33333334"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        struct aob_text text = {0};
        double value;
        assert_true(aob_param_parse(&params[0], texts[i], &value, NULL));
        aob_param_print(&params[0], value, &text);
        assert_string_equal(text.data, texts[i]);
        aob_text_finish(&text);
    }
}

static void test_rules_are_kept(void **state)
{
    (void)state;
    static const struct aob_param odd = {
        .name = "blur", .type = AOB_INT, .min = 0, .max = 33, .rule = AOB_ODD, .doc = "."};
    static const struct aob_param power = {
        .name = "divisor", .type = AOB_INT, .min = 0, .max = 8, .rule = AOB_POWER_OF_TWO, .doc = "."};
    struct aob_error error;
    double value;
    for (int i = 0; i <= 8; i++) {
        char text[8];
        snprintf(text, sizeof text, "%d", i);
        assert_int_equal(aob_param_parse(&odd, text, &value, &error), i == 0 || i % 2 == 1);
        assert_int_equal(aob_param_parse(&power, text, &value, &error), i == 1 || i == 2 || i == 4 || i == 8);
    }
    assert_false(aob_param_parse(&odd, "4", &value, &error));
    assert_string_equal(error.text, "blur: 4: must be odd, or 0");
    assert_false(aob_param_parse(&power, "3", &value, &error));
    assert_string_equal(error.text, "divisor: 3: must be a power of two");
}

static void test_packs_by_offset(void **state)
{
    (void)state;
    struct values values;
    aob_param_pack(params, 3, (const double[]){2.5, 12, 1}, &values, sizeof values);
    assert_true(values.radius == 2.5f);
    assert_int_equal(values.steps, 12);
    assert_int_equal(values.mode, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_whole_text_or_nothing), cmocka_unit_test(test_prints_what_parses_back),
        cmocka_unit_test(test_rules_are_kept), cmocka_unit_test(test_packs_by_offset)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
