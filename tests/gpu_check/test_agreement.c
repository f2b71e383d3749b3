#include "check.h"
#include <math.h>
#include "gpu_check/agreement.h"

/* Images of a row of pixels with figures that are worked out by hand. The last pixel of each is sky. */

enum { COUNT = 1000 };
static float image[COUNT + 1], expected[COUNT + 1], truth[COUNT + 1], depth[COUNT + 1];
static const struct aob_agreement_desc row = {.width = COUNT + 1,
                                              .height = 1,
                                              .image = image,
                                              .expected = expected,
                                              .truth = truth,
                                              .depth = depth,
                                              .sky_depth = 100};

static int fill(void **state)
{
    (void)state;
    for (int i = 0; i <= COUNT; i++) {
        image[i] = expected[i] = 0.5f;
        truth[i] = 0.75f;
        depth[i] = 1;
    }
    depth[COUNT] = 1000;
    image[COUNT] = 0;
    return 0;
}

static struct aob_agreement measure(void)
{
    struct aob_agreement agreement;
    aob_agreement_measure(&row, &agreement);
    return agreement;
}

static void equal_images_agree(void **state)
{
    (void)state;
    struct aob_agreement a = measure();
    assert_int_equal(a.pixels, COUNT);
    assert_true(a.visible_share == 0 && a.bias == 0 && a.rms == 0 && a.max == 0);
    assert_near(a.rmse, 0.25, 1e-12);
    assert_near(a.expected_rmse, 0.25, 1e-12);
    assert_true(aob_agreement_judge(&a, true, NULL));
}

static void figures_are_those_worked_out(void **state)
{
    (void)state;
    for (int i = 0; i < 40; i++) /* 4 % of the pixels, by a quarter */
        image[i] = 0.25f;
    for (int i = 40; i < 60; i++) /* 2 %, by less than a step of 1/255 */
        image[i] = 0.501953125f;
    struct aob_agreement a = measure();
    assert_near(a.visible_share, 0.04, 1e-12);
    assert_near(a.bias, -0.25 * 0.04 + 0.001953125 * 0.02, 1e-12);
    assert_near(a.rms, sqrt(0.0625 * 0.04 + 0.001953125 * 0.001953125 * 0.02), 1e-12);
    assert_near(a.max, 0.25, 1e-12);
    assert_near(a.rmse, sqrt(0.25 * 0.04 + 0.248046875 * 0.248046875 * 0.02 + 0.0625 * 0.94), 1e-12);
}

/* Whether the row fails with these words, on a GPU or on a software driver. */
static void refuse(bool software, const char *words)
{
    struct aob_error error = {{0}};
    struct aob_agreement a = measure();
    assert_false(aob_agreement_judge(&a, software, &error));
    assert_contains(error.text, words);
}

static void many_pixels_that_differ_are_found(void **state)
{
    struct aob_agreement a;
    for (int i = 0; i < 98; i++)
        image[i] = i % 2 ? 0.495f : 0.505f;
    a = measure();
    assert_true(aob_agreement_judge(&a, false, NULL)); /* 9.8 % */
    refuse(true, "9.80 % of the pixels differ by more than 1/255 (0.1 % may)");
    for (int i = 98; i < 102; i++)
        image[i] = i % 2 ? 0.495f : 0.505f;
    refuse(false, "10.20 % of the pixels differ by more than 1/255 (10 % may)");
    (void)state;
}

static void an_image_that_is_darker_or_brighter_is_found(void **state)
{
    for (int i = 0; i < COUNT; i++)
        image[i] = 0.497f;
    refuse(false, "0.00300 darker on the whole");
    for (int i = 0; i < COUNT; i++)
        image[i] = 0.503f;
    refuse(false, "0.00300 brighter on the whole");
    for (int i = 0; i < COUNT; i++)
        image[i] = 0.5002f;
    refuse(true, "0.00020 brighter on the whole");
    (void)state;
}

static void an_error_against_the_truth_that_moved_is_found(void **state)
{
    for (int i = 0; i < 19; i++) { /* in balance, and few, but far from the truth */
        image[i] = i % 2 ? 0.0f : 1.0f;
        truth[i] = i % 2 ? 1.0f : 0.0f;
    }
    image[18] = 0.5f;
    refuse(false, "its RMSE against the truth is 0.");
    (void)state;
}

static void what_is_no_number_is_found(void **state)
{
    image[7] = NAN;
    struct aob_agreement a = measure();
    assert_near(a.visible_share, 1e-3, 1e-12);
    assert_true(isinf(a.max));
    refuse(false, "on the whole");
    (void)state;
}

static void a_view_of_sky_alone_is_no_agreement(void **state)
{
    for (int i = 0; i <= COUNT; i++)
        depth[i] = 1000;
    refuse(true, "shows no surface");
    (void)state;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(equal_images_agree, fill),
        cmocka_unit_test_setup(figures_are_those_worked_out, fill),
        cmocka_unit_test_setup(many_pixels_that_differ_are_found, fill),
        cmocka_unit_test_setup(an_image_that_is_darker_or_brighter_is_found, fill),
        cmocka_unit_test_setup(an_error_against_the_truth_that_moved_is_found, fill),
        cmocka_unit_test_setup(what_is_no_number_is_found, fill),
        cmocka_unit_test_setup(a_view_of_sky_alone_is_no_agreement, fill),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
