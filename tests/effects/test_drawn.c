/* The lit image of a set, and its error against a truth of few rays. */
#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "effects/small.h"
#include "random.h"

enum {
    V = 1 << AOB_EFFECT_VISIBILITY,
    BOUNCES = 1 << AOB_EFFECT_MULTI_BOUNCE,
    BENT = 1 << AOB_EFFECT_BENT_NORMAL,
    LIGHT = 1 << AOB_EFFECT_DIRECTIONAL,
    LOBE = 1 << AOB_EFFECT_SPECULAR
};

static struct aob_seen_surface plain_surface(void)
{
    struct aob_seen_surface s = {.normal = {0, 0, 1}};
    for (int c = 0; c < 3; c++) {
        s.diffuse[c] = 0.5f;
        s.light[c] = 1;
        s.mirror[c] = 0.2f;
        s.even[c] = 0.1f;
    }
    return s;
}

static double lit(unsigned set)
{
    struct aob_seen_surface s = plain_surface();
    struct aob_drawn_surface d = {.visible = 0.5f,
                                  .lobe = 0.25f,
                                  .bounced = {0.75f, 0.75f, 0.75f},
                                  .light = {0.4f, 0.4f, 0.4f},
                                  .bent = {0, 2, 0}};
    const struct aob_drawn drawn = {&d};
    struct aob_seen seen = {.count = 1, .surfaces = &s, .light = aob_light_uniform};
    double rgb[3];
    seen.light.sh[1][0] = 0.6; /* brighter along y */
    aob_drawn_light(&seen, &drawn, set, 0, rgb);
    return rgb[0];
}

/* By the formula of technique/composite.h, term by term. */
static void test_sets(void **state)
{
    const double along_y = 1 + 2.0 / 3 * 0.6 * sqrt(3 / (4 * 3.14159265358979323846));
    (void)state;
    assert_near(lit(0), 0.5 + 0.2, 1e-6);
    assert_near(lit(V), 0.5 * 0.5 + 0.5 * 0.2, 1e-6);
    assert_near(lit(V | LOBE), 0.5 * 0.5 + 0.25 * 0.2, 1e-6);
    assert_near(lit(V | LIGHT), 0.5 * 0.4 + 0.5 * 0.2, 1e-6);
    assert_near(lit(V | BENT), 0.5 * 0.5 * along_y + 0.5 * 0.2, 1e-6);
    assert_near(lit(V | BOUNCES), 0.5 * 0.75 + 0.5 * 0.2 + 0.5 * 0.1 * (0.25 / 0.5), 1e-6);
    assert_near(lit(V | BOUNCES | LIGHT | LOBE), 0.5 * 0.6 + 0.25 * 0.2 + 0.75 * 0.1 * (0.2 / 0.5), 1e-6);
}

/* Surfaces that show .7 and whose truth is `right` on the one and `other` on the next, of two halves that scatter evenly by `spread`, all
 * channels by the same rays. */
static void make_two(struct aob_seen *seen, size_t side, const double rights[2], double spread,
                     uint32_t random)
{
    double sum = 0;
    *seen = (struct aob_seen){
        .width = (int)side, .height = (int)side, .count = side * side, .light = aob_light_uniform};
    seen->surfaces = AOB_NEW_ARRAY(struct aob_seen_surface, seen->count);
    seen->pixel = AOB_NEW_ARRAY(size_t, seen->count);
    for (size_t i = 0; i < seen->count; i++) {
        struct aob_seen_surface *s = &seen->surfaces[i];
        *s = plain_surface();
        seen->pixel[i] = i;
        double a = rights[i % 2] + spread * (random_unit(&random) - 0.5),
               b = rights[i % 2] + spread * (random_unit(&random) - 0.5);
        for (int c = 0; c < 3; c++) {
            s->truth[c] = (float)((a + b) / 2);
            s->se[c] = (float)(fabs(a - b) / 2);
            sum += (a + b) * (a + b) / 4 - (a - b) * (a - b) / 4;
        }
    }
    seen->mean_light = sqrt(sum / (3 * (double)seen->count));
}

static void make(struct aob_seen *seen, size_t side, double right, double spread)
{
    const double rights[2] = {right, right};
    make_two(seen, side, rights, spread, 7);
}

/* The standard error is the scatter over truths of other rays, not that of the error over the image: half of it is off by .01 and half by .4. */
static void test_scatter(void **state)
{
    enum { TRUTHS = 60 };
    const double rights[2] = {0.69, 0.3}, spreads[] = {0, 0.2, 0.8};
    (void)state;
    for (size_t k = 0; k < 3; k++) {
        double sum = 0, squares = 0, told = 0;
        for (uint32_t t = 0; t < TRUTHS; t++) {
            struct aob_seen seen;
            make_two(&seen, 40, rights, spreads[k], 1 + 977 * t);
            seen.mean_light = 0.5;
            struct aob_lit_error e = aob_drawn_error(&seen, NULL, 0);
            sum += e.rmse / TRUTHS;
            squares += e.rmse * e.rmse / TRUTHS;
            told += e.rmse_se / TRUTHS;
            aob_seen_finish(&seen);
        }
        double scatter = sqrt(fmax(squares - sum * sum, 0) * TRUTHS / (TRUTHS - 1.0));
        print_message("           scatters by %.5f of %.4f, says %.5f\n", scatter, sum, told);
        assert_near(sum, sqrt((0.01 * 0.01 + 0.4 * 0.4) / 2) / 0.5, 0.002);
        assert_true(told >= 0.7 * scatter - 1e-6 && told <= 1.35 * scatter + 1e-6);
    }
}

/* The error that endless rays would give comes out, whatever the noise, within what the standard error says. */
static void test_noise(void **state)
{
    const double rights[] = {0.7, 0.65, 0.5}, spreads[] = {0, 0.3, 1.2};
    (void)state;
    for (size_t r = 0; r < 3; r++)
        for (size_t k = 0; k < 3; k++) {
            struct aob_seen seen;
            double known = fabs(0.7 - rights[r]) / rights[r];
            make(&seen, 120, rights[r], spreads[k]);
            struct aob_lit_error e = aob_drawn_error(&seen, NULL, 0);
            print_message("           %.4f +- %.4f of %.4f\n", e.rmse, e.rmse_se, known);
            assert_true(fabs(e.rmse - known) <= 4 * e.rmse_se + 1e-5);
            assert_true(e.rmse_se < 0.05 && (rights[r] == 0.7 || e.rmse_se < 0.02));
            aob_seen_finish(&seen);
        }
}

static double flip_of(const struct aob_seen *seen, int shrink)
{
    struct aob_small small;
    aob_small_init(&small, seen, NULL, 0, shrink);
    double flip = aob_small_flip(&small, 1);
    aob_small_finish(&small);
    return flip;
}

/* Pixels that become one have less noise to see, and equal images are equal. */
static void test_flip(void **state)
{
    struct aob_seen seen;
    (void)state;
    make(&seen, 48, 0.7, 0);
    assert_near(flip_of(&seen, 1), 0, 1e-5);
    aob_seen_finish(&seen);
    make(&seen, 48, 0.7, 0.6);
    assert_true(flip_of(&seen, 1) > 0.02 && flip_of(&seen, 4) < 0.5 * flip_of(&seen, 1));
    assert_true(isnan(flip_of(&seen, 100)));
    aob_seen_finish(&seen);
}

/* Sky counts in no pixel: one of two surfaces and two of sky is the mean of the surfaces. */
static void test_small(void **state)
{
    struct aob_seen seen;
    struct aob_small small;
    (void)state;
    make(&seen, 4, 0.5, 0);
    seen.count = 2;
    seen.pixel[1] = 5;
    seen.surfaces[1].truth[0] = 1.5f;
    aob_small_init(&small, &seen, NULL, 0, 2);
    assert_int_equal(small.width, 2);
    assert_near(small.truth[0], 1, 1e-6);
    assert_near(small.truth[1], 0.5, 1e-6);
    assert_near(small.image[0], 0.7, 1e-6);
    assert_true(small.depth[0] == 1 && isinf(small.depth[1]) && isinf(small.depth[2]) &&
                isinf(small.depth[3]));
    aob_small_finish(&small);
    aob_seen_finish(&seen);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_sets), cmocka_unit_test(test_noise), cmocka_unit_test(test_scatter),
        cmocka_unit_test(test_flip), cmocka_unit_test(test_small),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
