#include "check.h"
#include <math.h>
#include "score/score.h"

enum { W = 10, H = 4 };

/* Truth .5 everywhere but a row at 1; the image is too bright by known steps; the last column is sky. */
static struct aob_score_desc scene(float *image, float *truth, float *depth)
{
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            truth[y * W + x] = y == 0 ? 1.0f : 0.5f;
            image[y * W + x] = y == 0 ? 1.0f : 0.5f + 0.01f * (float)x;
            depth[y * W + x] = x == W - 1 ? 1e9f : 2.0f;
        }
    return (struct aob_score_desc){.width = W,
                                   .height = H,
                                   .image = image,
                                   .truth = truth,
                                   .depth = depth,
                                   .sky_depth = 5e8f,
                                   .radius = 1,
                                   .pixel_scale = 1,
                                   .perspective = 1};
}

static void test_known_errors(void **state)
{
    (void)state;
    float image[W * H], truth[W * H], depth[W * H];
    struct aob_score_desc desc = scene(image, truth, depth);
    struct aob_metrics s;
    aob_score(&desc, &s);
    /* errors 0, .01 ... .08 in three rows of nine, and nine zeros: sum of squares 3 * 204e-4 */
    assert_int_equal(s.pixels, 36);
    assert_int_equal(s.band_pixels, 27);
    assert_near(s.rmse, sqrt(3 * 204e-4 / 36), 1e-7);
    assert_near(s.band_rmse, sqrt(3 * 204e-4 / 27), 1e-7);
    assert_near(s.bias, 3 * 0.36 / 36, 1e-7);
    assert_near(s.mae, s.bias, 1e-9);
    assert_near(s.max, 0.08, 1e-6);
    assert_near(s.reference_se, 0, 0);
}

/* Reach: radius 1 at depth 2 with scale 1 is half a pixel, so only pixels whose centre lies within .5 of the
 * edge: none. */
static void test_border(void **state)
{
    (void)state;
    float image[W * H], truth[W * H], depth[W * H];
    struct aob_score_desc desc = scene(image, truth, depth);
    struct aob_metrics s;
    aob_score(&desc, &s);
    assert_true(isnan(s.border_rmse));
    desc.radius =
        2; /* one pixel: the outermost ring; of it row 3 has errors 0...08 and rows 1, 2 only x = 0 */
    aob_score(&desc, &s);
    assert_near(s.border_rmse, sqrt(204e-4 / 20), 1e-7);
    assert_near(s.border_share, 1 / 3.0, 1e-6);
    desc.radius = INFINITY;
    aob_score(&desc, &s);
    assert_near(s.border_rmse, s.rmse, 1e-12);
}

static void test_identity_and_offset(void **state)
{
    (void)state;
    float image[W * H], truth[W * H], depth[W * H], se[W * H];
    struct aob_score_desc desc = scene(image, truth, depth);
    struct aob_metrics s;
    desc.image = truth;
    desc.truth_se = se;
    for (int i = 0; i < W * H; i++)
        se[i] = i % 2 ? 0.03f : 0.01f;
    aob_score(&desc, &s);
    assert_true(s.rmse == 0 && s.bias == 0 && s.max == 0 && s.p95 == 0);
    assert_near(s.reference_se, sqrt((5 * 1e-4 + 4 * 9e-4) / 9), 1e-7);
}

static void test_rubbish_is_invalid(void **state)
{
    (void)state;
    const float bad[] = {NAN, INFINITY, -0.01f, 1.01f};
    for (size_t i = 0; i < 4; i++) {
        float image[W * H], truth[W * H], depth[W * H];
        struct aob_score_desc desc = scene(image, truth, depth);
        struct aob_error error = {{0}};
        image[W + 3] = bad[i];
        assert_false(aob_score_judge(&desc, &error));
        assert_contains(error.text, "pixel (3, 1)");
        image[W + 3] = 0.5f;
        image[W - 1] = bad[i]; /* sky: in no score */
        assert_true(aob_score_judge(&desc, &error));
    }
}

static void fill(float *pixels, size_t count, float value)
{
    for (size_t i = 0; i < count; i++)
        pixels[i] = value;
}

/* A hundred columns and rows: a hundredth of the pixels is 100. The truth of the left half is 0.5, of the right one
 * 1. */
static void test_nothing_drawn(void **state)
{
    (void)state;
    enum { SIDE = 100, COUNT = SIDE * SIDE };
    static float image[COUNT], truth[COUNT], claim[COUNT], depth[COUNT];
    const struct aob_score_desc desc = {
        .width = SIDE, .height = SIDE, .image = image, .truth = truth, .depth = depth, .sky_depth = 10};
    struct aob_error error = {{0}};
    fill(depth, COUNT, 1);
    fill(image, COUNT, 0.25f);
    for (int i = 0; i < COUNT; i++)
        truth[i] = i % SIDE < SIDE / 2 ? 0.5f : 1;
    image[7] = 1;
    depth[7] = 11; /* sky does not count */
    assert_false(aob_score_judge_drawn(&desc, NULL, &error));
    assert_contains(error.text, "0.25 in 98 % of the pixels, where the truth spans 0.500 .. 1.000");
    assert_false(aob_score_judge_drawn(&desc, truth, &error));
    fill(claim, COUNT, 0.25f); /* the technique claims nothing else */
    assert_true(aob_score_judge_drawn(&desc, claim, &error));
    for (int i = 100; i < 150; i++) /* single pixels of noise are no picture */
        image[i] = 0;
    assert_false(aob_score_judge_drawn(&desc, NULL, &error));
    for (int i = 150; i < 350; i++) /* two hundredths are */
        image[i] = 0;
    assert_true(aob_score_judge_drawn(&desc, NULL, &error));
}

/* The frame is 1 in every pixel, and so is the truth but for single pixels: right, and not blank. */
static void test_noisy_truth_of_an_open_view(void **state)
{
    (void)state;
    enum { SIDE = 100, COUNT = SIDE * SIDE };
    static float image[COUNT], truth[COUNT], depth[COUNT];
    const struct aob_score_desc desc = {
        .width = SIDE, .height = SIDE, .image = image, .truth = truth, .depth = depth, .sky_depth = 10};
    struct aob_error error = {{0}};
    fill(depth, COUNT, 1);
    fill(image, COUNT, 1);
    fill(truth, COUNT, 1);
    fill(truth, 50, 0.5f);
    assert_true(aob_score_judge_drawn(&desc, NULL, &error));
    fill(truth, 200, 0.5f);
    assert_false(aob_score_judge_drawn(&desc, NULL, &error));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_errors),        cmocka_unit_test(test_border),
        cmocka_unit_test(test_identity_and_offset), cmocka_unit_test(test_rubbish_is_invalid),
        cmocka_unit_test(test_nothing_drawn),       cmocka_unit_test(test_noisy_truth_of_an_open_view)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
