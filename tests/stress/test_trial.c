/* What cannot be measured is worse than any number, so that it does not pass. */
#include "stress/trial.h"
#include "check.h"
#include <math.h>
#include "stress/resolution.h"

static void no_number_is_the_worst_of_two(void **state)
{
    (void)state;
    assert_near(aob_worse(1, 2), 2, 0);
    assert_near(aob_worse(2, 1), 2, 0);
    assert_near(aob_worse(-2, -1), -1, 0);
    assert_true(isnan(aob_worse(NAN, 1)));
    assert_true(isnan(aob_worse(1, NAN)));
    assert_true(isnan(aob_worse(INFINITY, NAN)));
}

static void no_number_is_not_over_zero(void **state)
{
    (void)state;
    assert_near(aob_over(-1), 0, 0);
    assert_near(aob_over(0.5), 0.5, 0);
    assert_true(isnan(aob_over(NAN)));
}

static void the_darkest_of_no_pixels_is_no_number(void **state)
{
    (void)state;
    float depth[2] = {2, 3};
    const float image[2] = {0.5f, 0.25f};
    bool mask[2] = {true, false};
    const struct aob_exhibit exhibit = {.width = 2, .height = 1, .gbuffer = {.depth = depth}};
    assert_near(aob_resolution_darkest(&exhibit, image, NULL), 0.25, 0);
    assert_near(aob_resolution_darkest(&exhibit, image, mask), 0.5, 0);
    mask[0] = false;
    assert_true(isnan(aob_resolution_darkest(&exhibit, image, mask)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_number_is_the_worst_of_two),
        cmocka_unit_test(no_number_is_not_over_zero),
        cmocka_unit_test(the_darkest_of_no_pixels_is_no_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
