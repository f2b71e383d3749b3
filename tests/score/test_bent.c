#include <math.h>
#include "check.h"
#include "score/bent.h"

enum { W = 5, H = 4 };

/* A truth turned by i degrees in pixel i, with another length; the last column is sky, pixel 0 nearly closed, pixel 1 says
 * closed. */
static void angles_are_those_that_were_turned(void **state)
{
    (void)state;
    float depth[W * H], visibility[W * H], image[W * H][3], open[W * H][3], normal[W * H][3];
    double sum = 90;
    for (int i = 0; i < W * H; i++) {
        double a = i * M_PI / 180;
        depth[i] = i % W == W - 1 ? 1e9f : 1;
        visibility[i] = i < 10 ? 0.994f : 0.996f;
        open[i][0] = open[i][2] = 0;
        open[i][1] = 0.6f;
        normal[i][0] = normal[i][2] = 1;
        normal[i][1] = i % 2 ? 0 : sqrtf(2);
        image[i][0] = (float)(0.9 * sin(a));
        image[i][1] = (float)(0.9 * cos(a));
        image[i][2] = 0;
        if (i > 1 && i % W != W - 1)
            sum += i;
    }
    open[0][1] = 0.01f;
    image[1][0] = image[1][1] = 0;
    image[W - 1][0] = NAN; /* sky: in no score */
    struct aob_score_desc desc = {
        .width = W, .height = H, .depth = depth, .sky_depth = 5e8f, .truth = visibility};
    const struct aob_bent_truth truth = {(const float(*)[3])open, (const float(*)[3])normal};
    struct aob_metrics m;
    aob_metrics_init(&m);
    aob_bent_score(&desc, (const float(*)[3])image, &truth, &m);
    assert_near(m.bent_pixels, 15, 0); /* 20 less 4 of sky and a closed one */
    assert_near(m.bent_mean, sum / 15, 1e-4);
    assert_true(m.bent_p95 >= 18 && m.bent_p95 <= 90);
    /* Of the first ten 1 (closed: 90 degrees), 2, 3, 5, 6, 7 and 8 are in band; the odd normals lie across, the even at 45. */
    assert_near(m.bent_band_pixels, 7, 0);
    assert_near(m.bent_band, (90 + 2 + 3 + 5 + 6 + 7 + 8) / 7.0, 1e-4);
    assert_near(m.bent_band_normal, (4 * 90 + 3 * 45) / 7.0, 1e-4);
    assert_true(isnan(m.rmse)); /* the rest is left alone */
}

static void what_is_no_direction_is_refused(void **state)
{
    (void)state;
    float depth[W * H], image[W * H][3] = {{0}};
    struct aob_score_desc desc = {.width = W, .height = H, .depth = depth, .sky_depth = 5e8f};
    struct aob_error error = {{0}};
    for (int i = 0; i < W * H; i++)
        depth[i] = i % W == W - 1 ? 1e9f : 1;
    image[W - 1][0] = NAN; /* sky */
    image[3][1] = 1;
    assert_true(aob_bent_judge(&desc, (const float(*)[3])image, &error));
    image[7][2] = INFINITY;
    assert_false(aob_bent_judge(&desc, (const float(*)[3])image, &error));
    assert_contains(error.text, "pixel (2, 1)");
    image[7][2] = 1.2f;
    assert_false(aob_bent_judge(&desc, (const float(*)[3])image, &error));
}

static void a_small_angle_is_exact(void **state)
{
    (void)state;
    float depth[1] = {1}, visibility[1] = {1}, open[1][3] = {{0, 0, 1}}, image[1][3] = {{1e-4f, 0, 1}};
    struct aob_score_desc desc = {
        .width = 1, .height = 1, .depth = depth, .sky_depth = 5e8f, .truth = visibility};
    const struct aob_bent_truth truth = {(const float(*)[3])open, (const float(*)[3])open};
    struct aob_metrics m;
    aob_bent_score(&desc, (const float(*)[3])image, &truth, &m);
    assert_near(m.bent_mean, 1e-4 * 180 / M_PI, 1e-8);
    assert_true(isnan(m.bent_band) && isnan(m.bent_band_normal)); /* it is open */
    open[0][2] = 0;
    aob_bent_score(&desc, (const float(*)[3])image, &truth, &m);
    assert_true(isnan(m.bent_mean) && m.bent_pixels == 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(angles_are_those_that_were_turned),
                                       cmocka_unit_test(what_is_no_direction_is_refused),
                                       cmocka_unit_test(a_small_angle_is_exact)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
