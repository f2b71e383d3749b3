/* The knee of a curve of misses over the radius. */
#include "check.h"
#include <math.h>
#include "reports/page/curves.h"

#define KNEE(...)                                                                                            \
    aob_curve_knee((const struct aob_curve_point[]){__VA_ARGS__},                                            \
                   sizeof((const struct aob_curve_point[]){__VA_ARGS__}) / sizeof(struct aob_curve_point))

static void between_two_points(void **state)
{
    (void)state;
    /* half of 80 is a third of the way from 30 to 60, in octaves from 1 to 8: the radius 2 */
    assert_near(KNEE({.x = 0.5, .y = 1}, {.x = 1, .y = 30}, {.x = 8, .y = 60}, {.x = 16, .y = 80},
                     {.x = 32, .y = 80}),
                2, 1e-12);
    /* at a point */
    assert_near(KNEE({.x = 1, .y = 2}, {.x = 2, .y = 5}, {.x = 4, .y = 10}, {.x = 8, .y = 9}), 2, 1e-12);
    /* a curve twice as far is the same curve: only the radius doubles */
    assert_near(KNEE({.x = 2, .y = 2}, {.x = 4, .y = 5}, {.x = 8, .y = 10}, {.x = 16, .y = 9}), 4, 1e-12);
}

static void unknown(void **state)
{
    (void)state;
    assert_true(isnan(
        KNEE({.x = 1, .y = 6}, {.x = 2, .y = 9}, {.x = 4, .y = 10}, {.x = 8, .y = 10}))); /* begins above */
    assert_true(isnan(KNEE({.x = 1, .y = 1}, {.x = 2, .y = 3}, {.x = 4, .y = 10})));      /* rises on */
    assert_true(isnan(KNEE({.x = 1, .y = 1}, {.x = 2, .y = 10})));
    assert_true(isnan(KNEE({.x = 1, .y = 0}, {.x = 2, .y = 0}, {.x = 4, .y = 0})));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(between_two_points), cmocka_unit_test(unknown)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
