#include "check.h"
#include <math.h>
#include "score/split.h"

enum { W = 8, H = 2 };

/* Parts of known size: definition +.1, missing -.05 in the upper row and +.05 in the lower, estimator .02 x. The last
 * column is sky and holds rubbish. */
static void test_known_parts(void **state)
{
    (void)state;
    float truth[W * H], definition[W * H], screen[W * H], image[W * H], depth[W * H];
    double x_mean = 3, x_square = 13; /* of 0..6 */
    for (int i = 0; i < W * H; i++) {
        int x = i % W;
        truth[i] = 0.3f;
        definition[i] = 0.4f;
        screen[i] = definition[i] + (i < W ? -0.05f : 0.05f);
        image[i] = screen[i] + 0.02f * (float)x;
        depth[i] = x == W - 1 ? 1e9f : 1;
        if (x == W - 1)
            definition[i] = screen[i] = NAN;
    }
    struct aob_score_desc desc = {
        .width = W, .height = H, .image = image, .truth = truth, .depth = depth, .sky_depth = 5e8f};
    struct aob_metrics s;
    aob_score(&desc, &s);
    aob_split(&desc, definition, screen, &s);
    assert_near(s.definition_rmse, 0.1, 1e-6);
    assert_near(s.missing_rmse, 0.05, 1e-6);
    assert_near(s.estimator_rmse, 0.02 * sqrt(x_square), 1e-6);
    assert_near(s.claim_bias, 0.02 * x_mean, 1e-6); /* the missing parts of the two rows cancel */
    assert_near(s.definition_missing, 0, 1e-7);     /* the rows cancel */
    assert_near(s.missing_estimator, 0, 1e-7);
    assert_near(s.definition_estimator, 0.1 * 0.02 * x_mean, 1e-6);
    double sum = s.definition_rmse * s.definition_rmse + s.missing_rmse * s.missing_rmse +
                 s.estimator_rmse * s.estimator_rmse +
                 2 * (s.definition_missing + s.missing_estimator + s.definition_estimator);
    assert_near(s.rmse * s.rmse, sum, 1e-8);
}

static void test_nothing_but_sky(void **state)
{
    (void)state;
    float zero[2] = {0}, sky[2] = {1e9f, 1e9f};
    struct aob_score_desc desc = {
        .width = 2, .height = 1, .image = zero, .truth = zero, .depth = sky, .sky_depth = 5e8f};
    struct aob_metrics s;
    aob_split(&desc, zero, zero, &s);
    assert_true(isnan(s.definition_rmse) && isnan(s.missing_estimator));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_known_parts),
                                       cmocka_unit_test(test_nothing_but_sky)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
