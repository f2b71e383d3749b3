#include "check.h"
#include "direct_flip.h"
#include "score/flip.h"
#include "pairs.h"

/* What a file of the image in sRGB holds at a pixel, and back. */
static double decode(double code)
{
    return code <= 0.04045 ? code / 12.92 : pow((code + 0.055) / 1.055, 2.4);
}

static double encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

static struct direct_colour pixel_colour(const struct pair *pair, const float *pixels, int i)
{
    double grey = decode(encode(pair_pixel(pair, pixels, i % PAIR_WIDTH, i / PAIR_WIDTH)));
    return (struct direct_colour){{grey, grey, grey}};
}

static double second_flip(const struct pair *pair)
{
    struct direct_colour image[PAIR_SIZE], truth[PAIR_SIZE];
    bool sky[PAIR_SIZE];
    for (int i = 0; i < PAIR_SIZE; i++) {
        image[i] = pixel_colour(pair, pair->image, i);
        truth[i] = pixel_colour(pair, pair->truth, i);
        sky[i] = pair->depth[i] >= pair->desc.sky_depth;
    }
    return direct_flip(&(struct direct_pair){PAIR_WIDTH, PAIR_HEIGHT, image, truth, sky});
}

static void test_second_implementation(void **state)
{
    (void)state;
    double low = 1, high = 0;
    for (int i = 0; i < PAIR_COUNT; i++) {
        struct pair pair;
        pair_make(&pair, i);
        double flip = aob_flip(&pair.desc);
        assert_near(flip, second_flip(&pair), 1e-9);
        low = fmin(low, flip);
        high = fmax(high, flip);
    }
    assert_true(low < 0.15 && high > 0.5); /* the pairs are not all alike */
}

static void test_identities(void **state)
{
    (void)state;
    for (int i = 0; i < PAIR_COUNT; i++) {
        struct pair pair;
        pair_make(&pair, i);
        double forth = aob_flip(&pair.desc);
        pair.desc.image = pair.truth;
        assert_true(aob_flip(&pair.desc) == 0);
        pair.desc.truth = pair.image;
        assert_near(aob_flip(&pair.desc), forth, 1e-12);
        assert_true(forth > 0 && forth < 1);
    }
}

/* Constants have no features: only the colour's difference is left. */
static void test_constants(void **state)
{
    (void)state;
    struct pair pair;
    pair_fill(&pair, 0, 1);
    assert_near(aob_flip(&pair.desc), 0.967, 0.001);
    pair_fill(&pair, 0.18418652f, 1); /* L* = 50: half the way from white to black, before the exponent */
    assert_near(aob_flip(&pair.desc), 0.95 * pow(50 / 203.2, 0.7) / 0.4, 0.001);
}

/* The more noise, or the wider a blur, the more one notices; what is finer than the eye sees goes nearly unnoticed. */
static void test_order(void **state)
{
    (void)state;
    struct pair pair;
    pair_make(&pair, 4);
    double noisy = 0, blurred = 0;
    for (int step = 1; step <= 5; step++) {
        pair_add_noise(&pair, 0.1 * step);
        double now = aob_flip(&pair.desc);
        assert_true(now > noisy);
        noisy = now;
    }
    for (int radius = 1; radius <= 4; radius++) {
        pair_blur(&pair, radius);
        double now = aob_flip(&pair.desc);
        assert_true(now > blurred);
        blurred = now;
    }
    pair_fill(&pair, 0.6f, 0.5f);
    double even = aob_flip(&pair.desc);
    for (int i = 0; i < PAIR_SIZE; i++)
        pair.image[i] = (i / PAIR_WIDTH + i % PAIR_WIDTH) % 2 ? 0.6f : 0.4f;
    assert_true(aob_flip(&pair.desc) < 0.2 * even);
}

static void test_small_images(void **state)
{
    (void)state;
    struct pair pair;
    pair_fill(&pair, 0, 1);
    pair.desc.width = pair.desc.height = 1;
    assert_near(aob_flip(&pair.desc), 0.967, 0.001);
    pair.depth[0] = 1e9f;
    assert_true(isnan(aob_flip(&pair.desc)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_second_implementation),
                                       cmocka_unit_test(test_identities), cmocka_unit_test(test_constants),
                                       cmocka_unit_test(test_order), cmocka_unit_test(test_small_images)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
