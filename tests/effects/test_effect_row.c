/* Sets of effects: each that can be made is listed once. */
#include "check.h"
#include <stdlib.h>
#include <string.h>
#include "effects/effect_row.h"

/* Nothing; then visibility with or without bounces, specular, the mean over time and half size, and none or one of two ways to light. */
static void test_all(void **state)
{
    unsigned sets[AOB_EFFECT_SETS], seen[AOB_EFFECT_ALL + 1] = {0};
    size_t count = aob_effect_sets(AOB_EFFECT_ALL, sets);
    (void)state;
    assert_int_equal(count, 1 + 2 * 2 * 2 * 2 * 3);
    assert_int_equal(sets[0], 0);
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(seen[sets[i]]++, 0);
        assert_true(!sets[i] || aob_effect_has(sets[i], AOB_EFFECT_VISIBILITY));
        assert_false(aob_effect_has(sets[i], AOB_EFFECT_BENT_NORMAL) &&
                     aob_effect_has(sets[i], AOB_EFFECT_DIRECTIONAL));
    }
}

static void test_some(void **state)
{
    unsigned sets[AOB_EFFECT_SETS];
    (void)state;
    assert_int_equal(aob_effect_sets(0, sets), 1);
    assert_int_equal(
        aob_effect_sets(AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY) | AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR), sets),
        3);
    assert_int_equal(aob_effect_sets(AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR), sets),
                     1); /* it is made of visibility */
}

static void test_print(void **state)
{
    struct aob_text text = {0};
    (void)state;
    aob_effect_set_print(AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY) | AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE), &text);
    assert_string_equal(text.data, "visibility + half_size");
    aob_text_finish(&text);
    aob_effect_set_print(0, &text);
    assert_string_equal(text.data, "nothing");
    aob_text_finish(&text);
}

static void test_choices(void **state)
{
    (void)state;
    assert_true(aob_effect_is_choice("lit") && aob_effect_is_choice("visibility_rgb") &&
                aob_effect_is_choice("history") && aob_effect_is_choice("divisor"));
    assert_false(aob_effect_is_choice("radius") || aob_effect_is_choice("normals") ||
                 aob_effect_is_choice("visibility"));
}

/* Each image holds the sets of its size and its frames, and no set lies in two. */
static void test_images(void **state)
{
    const unsigned visible = AOB_EFFECT_BIT(AOB_EFFECT_VISIBILITY),
                   half = AOB_EFFECT_BIT(AOB_EFFECT_HALF_SIZE), mean = AOB_EFFECT_BIT(AOB_EFFECT_TEMPORAL),
                   more = AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR);
    (void)state;
    assert_int_equal(aob_effect_image_of(visible), 0);
    assert_int_equal(aob_effect_image_of(visible | half), 1);
    assert_int_equal(aob_effect_image_of(visible | mean), 2);
    assert_int_equal(aob_effect_image_of(visible | mean | half), 3);
    assert_int_equal(aob_effect_image_of(visible | mean | more), 2);
    /* What a still view is judged by is as long as the mean that a config gets. */
    assert_int_equal(atoi(aob_effect_rows[AOB_EFFECT_TEMPORAL].param.on), AOB_EFFECT_HISTORY);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all),    cmocka_unit_test(test_some),    cmocka_unit_test(test_print),
        cmocka_unit_test(test_images), cmocka_unit_test(test_choices),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
