/* What a mean over many frames can change, from two: against noise whose variance is known. */
#include "check.h"
#include <math.h>
#include "effects/noise.h"
#include "random.h"

enum {
    V = 1 << AOB_EFFECT_VISIBILITY,
    BOUNCES = 1 << AOB_EFFECT_MULTI_BOUNCE,
    HALF = 1 << AOB_EFFECT_HALF_SIZE,
    MEAN = 1 << AOB_EFFECT_TEMPORAL,
    SIDE = 100
};
static struct aob_seen_surface surfaces[SIDE * SIDE];
static struct aob_drawn_surface images[AOB_EFFECT_IMAGES][SIDE * SIDE];

/* Visibility .6 and noise, evenly within `spread`, at full size and at half; `after` times the first noise and the rest anew is the
 * second frame's. Bounces double what is seen. */
static double noise_of(double full, double half, double after, unsigned open)
{
    const double spreads[2] = {full, half};
    struct aob_drawn drawn[AOB_EFFECT_IMAGES];
    struct aob_seen seen = {
        .count = SIDE * SIDE, .surfaces = surfaces, .light = aob_light_uniform, .mean_light = 0.25};
    uint32_t random = 5;
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        surfaces[i] = (struct aob_seen_surface){.diffuse = {0.5f, 0.5f, 0.5f}, .light = {1, 1, 1}};
        for (size_t k = 0; k < 2; k++) {
            double first = spreads[k] * (random_unit(&random) - 0.5),
                   other = after * first + sqrt(1 - after * after) * spreads[k] * (random_unit(&random) - 0.5),
                   seen_by[2] = {0.6 + first, 0.6 + (first + other) / 2};
            for (size_t mean = 0; mean < 2; mean++) {
                struct aob_drawn_surface *d = &images[k + 2 * mean][i];
                d->visible = (float)seen_by[mean];
                d->bounced[0] = d->bounced[1] = d->bounced[2] = 2 * d->visible;
            }
        }
    }
    for (size_t k = 0; k < AOB_EFFECT_IMAGES; k++)
        drawn[k].surfaces = images[k];
    return aob_effect_noise(&seen, drawn, open);
}

/* Even noise of spread s has the variance s^2 / 12; half of it is reflected, of a mean of .25. */
static void test_even(void **state)
{
    const double one = 0.5 * 0.2 / sqrt(12) / 0.25;
    (void)state;
    assert_near(noise_of(0.2, 0.2, 0, V | HALF | MEAN), one, 0.02 * one);
    assert_near(noise_of(0.2, 0.4, 0, V | HALF | MEAN), 2 * one, 0.04 * one); /* the larger size counts */
    assert_near(noise_of(0.2, 0.4, 0, V | MEAN), one, 0.02 * one);
    assert_near(noise_of(0.2, 0.2, 0, V | BOUNCES | HALF | MEAN), 2 * one, 0.04 * one); /* and the larger set */
    assert_near(noise_of(0, 0, 0, V | HALF | MEAN), 0, 1e-7);
}

/* Frames that even each other out seem noisier, by the root of 2 at most: the bound holds. */
static void test_opposite(void **state)
{
    const double one = 0.5 * 0.2 / sqrt(12) / 0.25;
    (void)state;
    assert_near(noise_of(0.2, 0.2, -1, V | HALF | MEAN), sqrt(2) * one, 0.03 * one);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_even),
        cmocka_unit_test(test_opposite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
