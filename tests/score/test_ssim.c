#include "check.h"
#include "score/ssim.h"
#include "pairs.h"

/* The paper's weighted sums, written out: means first, then deviations from them. */
static double direct_window(const struct pair *pair, int cx, int cy)
{
    double total = 0, mean_x = 0, mean_y = 0, var_x = 0, var_y = 0, covariance = 0;
    for (int pass = 0; pass < 3; pass++)
        for (int v = -5; v <= 5; v++)
            for (int u = -5; u <= 5; u++) {
                double w = exp(-(u * u + v * v) / (2 * 1.5 * 1.5));
                double a = pair_pixel(pair, pair->image, cx + u, cy + v);
                double b = pair_pixel(pair, pair->truth, cx + u, cy + v);
                if (pass == 0) {
                    total += w;
                } else if (pass == 1) {
                    mean_x += w / total * a;
                    mean_y += w / total * b;
                } else {
                    var_x += w / total * (a - mean_x) * (a - mean_x);
                    var_y += w / total * (b - mean_y) * (b - mean_y);
                    covariance += w / total * (a - mean_x) * (b - mean_y);
                }
            }
    double luminance = (2 * mean_x * mean_y + 1e-4) / (mean_x * mean_x + mean_y * mean_y + 1e-4);
    double contrast = (2 * sqrt(var_x) * sqrt(var_y) + 9e-4) / (var_x + var_y + 9e-4);
    double structure = (covariance + 4.5e-4) / (sqrt(var_x) * sqrt(var_y) + 4.5e-4);
    return luminance * contrast * structure;
}

static double direct_ssim(const struct pair *pair)
{
    double sum = 0;
    int count = 0;
    for (int y = 5; y < PAIR_HEIGHT - 5; y++)
        for (int x = 5; x < PAIR_WIDTH - 5; x++)
            if (pair->depth[y * PAIR_WIDTH + x] < pair->desc.sky_depth) {
                sum += direct_window(pair, x, y);
                count++;
            }
    return sum / count;
}

static void test_second_implementation(void **state)
{
    (void)state;
    double low = 1, high = -1;
    for (int i = 0; i < PAIR_COUNT; i++) {
        struct pair pair;
        pair_make(&pair, i);
        double ssim = aob_ssim(&pair.desc);
        assert_near(ssim, direct_ssim(&pair), 1e-6);
        low = fmin(low, ssim);
        high = fmax(high, ssim);
    }
    assert_true(low < 0.2 && high > 0.9); /* the pairs are not all alike */
}

static void test_identities(void **state)
{
    (void)state;
    for (int i = 0; i < PAIR_COUNT; i++) {
        struct pair pair;
        pair_make(&pair, i);
        double forth = aob_ssim(&pair.desc);
        pair.desc.image = pair.truth;
        assert_true(aob_ssim(&pair.desc) == 1);
        pair.desc.truth = pair.image;
        assert_near(aob_ssim(&pair.desc), forth, 1e-12);
        assert_true(forth < 1);
    }
}

/* Of constants only the luminance term is left. */
static void test_constants(void **state)
{
    (void)state;
    const float values[][2] = {{0, 1}, {0.25f, 0.75f}, {0.5f, 0.5f}, {1, 0.875f}};
    for (size_t i = 0; i < 4; i++) {
        struct pair pair;
        double a = values[i][0], b = values[i][1];
        pair_fill(&pair, values[i][0], values[i][1]);
        assert_near(aob_ssim(&pair.desc), (2 * a * b + 1e-4) / (a * a + b * b + 1e-4), 1e-9);
    }
}

/* The more noise, or the wider a blur, the less alike; a negative is unlike. */
static void test_order(void **state)
{
    (void)state;
    struct pair pair;
    pair_make(&pair, 4);
    double noisy = 1, blurred = 1;
    for (int step = 1; step <= 5; step++) {
        pair_add_noise(&pair, 0.1 * step);
        double now = aob_ssim(&pair.desc);
        assert_true(now < noisy);
        noisy = now;
    }
    for (int radius = 1; radius <= 4; radius++) {
        pair_blur(&pair, radius);
        double now = aob_ssim(&pair.desc);
        assert_true(now < blurred);
        blurred = now;
    }
    for (int i = 0; i < PAIR_SIZE; i++)
        pair.image[i] = 1 - pair.truth[i];
    assert_true(aob_ssim(&pair.desc) < 0);
}

static void test_no_window(void **state)
{
    (void)state;
    struct pair pair;
    pair_make(&pair, 1);
    pair.desc.height = 10;
    assert_true(isnan(aob_ssim(&pair.desc)));
    pair.desc.height = 11;
    assert_true(isfinite(aob_ssim(&pair.desc)));
    pair.desc.width = 3;
    assert_true(isnan(aob_ssim(&pair.desc)));
    pair.desc.width = PAIR_WIDTH;
    for (int i = 0; i < PAIR_SIZE; i++)
        pair.depth[i] = 1e9f;
    assert_true(isnan(aob_ssim(&pair.desc)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_second_implementation),
                                       cmocka_unit_test(test_identities), cmocka_unit_test(test_constants),
                                       cmocka_unit_test(test_order), cmocka_unit_test(test_no_window)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
