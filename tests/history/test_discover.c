#include "check.h"
#include <math.h>
#include "history/watch.h"
#include "random.h"

/* The fifteen p-values of Benjamini and Hochberg (1995), section 4.1: at .05 four are found, and Bonferroni's rule finds three.
 * They stand in another order here. */
static void test_discoveries_of_the_paper(void **state)
{
    (void)state;
    const double p[] = {.3240, .0001, .0278, 1.0000, .0095, .0004, .4262, .0298,
                        .5719, .0019, .0344, .6528,  .0201, .0459, .7590};
    double level = aob_watch_level(p, 15, .05);
    for (size_t i = 0; i < 15; i++)
        assert_int_equal(p[i] <= level, p[i] <= .0095);
}

/* By the definition: found is what is no larger than a p-value that is at most q i / m, i values being no larger. */
static void test_discoveries_by_definition(void **state)
{
    (void)state;
    uint32_t seed = 17;
    for (int trial = 0; trial < 500; trial++) {
        double p[12];
        size_t n = random_below(&seed, 13), tested = 0;
        for (size_t i = 0; i < n; i++) {
            p[i] = random_below(&seed, 5) ? .01 * (double)random_below(&seed, 12) : NAN;
            tested += isnan(p[i]) ? 0 : 1;
        }
        double level = aob_watch_level(p, n, .05);
        for (size_t i = 0; i < n; i++) {
            bool expected = false;
            for (size_t k = 0; k < n; k++) {
                double rank = 0;
                for (size_t j = 0; j < n; j++)
                    rank += p[j] <= p[k];
                expected |= p[i] <= p[k] && p[k] <= .05 * rank / (double)tested;
            }
            assert_int_equal(p[i] <= level, expected);
        }
    }
}

/* Of the paper's fifteen four are found: the level is .05 x 4 / 15. Fifteen that are none leave .05 / 15, one NAN less .05 / 14. */
static void test_level(void **state)
{
    (void)state;
    double p[15];
    for (int i = 0; i < 15; i++)
        p[i] = i < 4 ? .0095 : .5;
    assert_float_equal(aob_watch_level(p, 15, .05), .05 * 4 / 15, 1e-15);
    for (int i = 0; i < 4; i++)
        p[i] = .5;
    assert_float_equal(aob_watch_level(p, 15, .05), .05 / 15, 1e-15);
    p[7] = NAN;
    assert_float_equal(aob_watch_level(p, 15, .05), .05 / 14, 1e-15);
    assert_float_equal(aob_watch_level(p, 0, .05), .05, 1e-15);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_discoveries_of_the_paper),
        cmocka_unit_test(test_discoveries_by_definition),
        cmocka_unit_test(test_level),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
