/* What a mean over many frames can change, from two: against noise whose variance is known. */
#include "check.h"
#include <math.h>
#include "effects/mean_gain.h"
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
 * second frame's. Bounces double what is seen. The truth is what the mean shows of visibility, and `off` more. */
struct draw {
    double spread[2], after, off;
};
static double gain_of(const struct draw *draw, unsigned open)
{
    struct aob_drawn drawn[AOB_EFFECT_IMAGES];
    struct aob_seen seen = {
        .count = SIDE * SIDE, .surfaces = surfaces, .light = aob_light_uniform, .mean_light = 0.25};
    uint32_t random = 5;
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        surfaces[i] = (struct aob_seen_surface){.diffuse = {0.5f, 0.5f, 0.5f}, .light = {1, 1, 1}};
        for (int c = 0; c < 3; c++)
            surfaces[i].truth[c] = (float)(0.3 + draw->off);
        for (size_t k = 0; k < 2; k++) {
            double spread = draw->spread[k], first = spread * (random_unit(&random) - 0.5),
                   other = draw->after * first +
                           sqrt(1 - draw->after * draw->after) * spread * (random_unit(&random) - 0.5),
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
    return aob_effect_mean_gain(&seen, drawn, open);
}

/* Even noise of spread s has the variance s^2 / 12; half of it is reflected, of a mean light of .25. */
static double noise(double spread)
{
    return 0.5 * spread / sqrt(12) / 0.25;
}

static double right(double spread, double off)
{
    return sqrt(noise(spread) * noise(spread) + off * off / (0.25 * 0.25)) - off / 0.25;
}

/* Of noise alone nothing is left, and beside another error it hardly counts. */
static void test_even(void **state)
{
    (void)state;
    assert_near(gain_of(&(struct draw){{0.2, 0.2}, 0, 0}, V | HALF | MEAN), noise(0.2), 0.03 * noise(0.2));
    assert_near(gain_of(&(struct draw){{0.2, 0.2}, 0, 0.05}, V | HALF | MEAN), right(0.2, 0.05),
                0.04 * right(0.2, 0.05));
    assert_near(gain_of(&(struct draw){{0.2, 0.2}, 0, 0.2}, V | HALF | MEAN), right(0.2, 0.2),
                0.05 * right(0.2, 0.2));
    assert_true(right(0.2, 0.2) < 0.1 * noise(0.2));
    assert_near(gain_of(&(struct draw){{0, 0}, 0, 0.05}, V | HALF | MEAN), 0, 1e-7);
}

/* The set that gains most counts: the noisier size; and bounces, whose noise is all that is wrong with them if the truth is .6. */
static void test_most(void **state)
{
    (void)state;
    assert_near(gain_of(&(struct draw){{0.2, 0.4}, 0, 0.05}, V | HALF | MEAN), right(0.4, 0.05),
                0.04 * right(0.4, 0.05));
    assert_near(gain_of(&(struct draw){{0.2, 0.4}, 0, 0.05}, V | MEAN), right(0.2, 0.05),
                0.04 * right(0.2, 0.05));
    assert_near(gain_of(&(struct draw){{0.2, 0.2}, 0, 0.3}, V | BOUNCES | MEAN), 2 * noise(0.2),
                0.03 * noise(0.2));
    assert_near(gain_of(&(struct draw){{0.2, 0.2}, 0, 0.3}, V | MEAN), right(0.2, 0.3),
                0.05 * right(0.2, 0.3));
}

/* Frames that even each other out seem noisier, by the root of 2: the gain comes out larger, not smaller. */
static void test_opposite(void **state)
{
    (void)state;
    assert_near(gain_of(&(struct draw){{0.2, 0.2}, -1, 1}, V | HALF | MEAN), 2 * right(0.2, 1),
                0.05 * right(0.2, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_even),
        cmocka_unit_test(test_most),
        cmocka_unit_test(test_opposite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
