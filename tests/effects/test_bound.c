/* Bounds of what an effect can change, against closed forms of single surfaces. */
#include "check.h"
#include <math.h>
#include "effects/bound.h"
#include "random.h"

static struct aob_seen_surface surface(double visible, double diffuse)
{
    struct aob_seen_surface s = {.normal = {0, 0, 1}, .apart = 0.25f, .visible = (float)visible};
    for (int c = 0; c < 3; c++) {
        s.diffuse[c] = (float)diffuse;
        s.mirror[c] = 0.1f;
        s.even[c] = 0.05f;
    }
    return s;
}

static struct aob_effect_bounds bounds_of(struct aob_seen_surface *surfaces, size_t count,
                                          const struct aob_light *light)
{
    struct aob_effect_bounds bounds;
    const struct aob_seen seen = {.count = count, .surfaces = surfaces, .light = *light, .mean_light = 0.5};
    aob_effect_bounds_find(&seen, &bounds);
    return bounds;
}

/* f(.5) at an albedo of .8 is .811; at .05 it is less than .5, so nothing is gained. Even light has no direction. */
static void test_even(void **state)
{
    struct aob_seen_surface white = surface(0.5, 0.8), dark = surface(0.5, 0.05), open = surface(1, 0.8);
    struct aob_effect_bounds b = bounds_of(&white, 1, &aob_light_uniform);
    (void)state;
    assert_near(b.most[AOB_EFFECT_MULTI_BOUNCE], (0.8 + 0.05 * (0.5 + 0.25) / 0.5) * 0.311125 / 0.5, 1e-4);
    assert_near(b.most[AOB_EFFECT_DIRECTIONAL], 0, 1e-6);
    assert_near(b.most[AOB_EFFECT_BENT_NORMAL], 0, 1e-6);
    assert_near(b.most[AOB_EFFECT_SPECULAR], 0.25 * 0.1 / 0.5, 1e-6);
    assert_true(isinf(b.most[AOB_EFFECT_VISIBILITY]) && isinf(b.most[AOB_EFFECT_TEMPORAL]) &&
                isinf(b.most[AOB_EFFECT_HALF_SIZE]));
    b = bounds_of(&dark, 1, &aob_light_uniform);
    assert_near(b.most[AOB_EFFECT_MULTI_BOUNCE], 0, 1e-6);
    b = bounds_of(&open, 1, &aob_light_uniform);
    assert_near(b.most[AOB_EFFECT_MULTI_BOUNCE], 0, 1e-6);
    assert_near(b.most[AOB_EFFECT_SPECULAR], 0, 1e-6);
}

/* A bound is the largest of the normals about one, up to 6 % above it. */
static void check_bound(double most, double right)
{
    assert_true(most >= 0.998 * right && most <= 1.06 * right);
}

/* Light 1 + k z: over the cosine's hemisphere about z its variance is k^2 (1/2 - 4/9). */
static void test_slanted(void **state)
{
    struct aob_seen_surface s[2] = {surface(0.5, 0.8), surface(1, 0.8)};
    struct aob_light light = aob_light_uniform;
    const double k = 0.6, gain = 1.62225, weight = 0.8 * gain + 0.075 * (gain - 1); /* f(.5) / .5 */
    (void)state;
    for (int c = 0; c < 3; c++)
        light.sh[2][c] = k / sqrt(3 / (4 * 3.14159265358979323846));
    struct aob_effect_bounds b = bounds_of(s, 1, &light);
    check_bound(b.most[AOB_EFFECT_DIRECTIONAL], weight * 0.5 * k * sqrt(1 / 18.0) / 0.5);
    assert_near(b.most[AOB_EFFECT_MULTI_BOUNCE], (0.8 + 0.075) * 1.6 * 0.311125 / 0.5,
                1e-4);           /* the brightest is 1.6 */
    b = bounds_of(s, 2, &light); /* half of the surfaces are open */
    check_bound(b.most[AOB_EFFECT_DIRECTIONAL], sqrt(0.5) * weight * 0.5 * k * sqrt(1 / 18.0) / 0.5);
}

/* The brightest direction lies between the points of any grid: 1 + k d for a unit d. */
static void test_brightest(void **state)
{
    struct aob_seen_surface s = surface(0.5, 0.8);
    struct aob_light light = aob_light_uniform;
    const double d[3] = {0.3571, 0.6186, 0.6999}, k = 0.9 / sqrt(3 / (4 * 3.14159265358979323846));
    (void)state;
    for (int c = 0; c < 3; c++)
        light.sh[1][c] = k * d[1], light.sh[2][c] = k * d[2], light.sh[3][c] = k * d[0];
    double length = sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    struct aob_effect_bounds b = bounds_of(&s, 1, &light);
    assert_near(b.most[AOB_EFFECT_MULTI_BOUNCE] * 0.5 / (0.875 * 0.311125), 1 + 0.9 * length, 1e-5);
}

enum { SIDE = 64 };

/* Surfaces of which some are open, some half closed and some in a slope, each known by so many rays. */
static struct aob_effect_bounds bounds_by_rays(int spp)
{
    static struct aob_seen_surface surfaces[SIDE * SIDE];
    static size_t pixel[SIDE * SIDE];
    struct aob_effect_bounds bounds;
    struct aob_seen seen = {.width = SIDE,
                            .height = SIDE,
                            .spp = spp,
                            .count = SIDE * SIDE,
                            .pixel = pixel,
                            .surfaces = surfaces,
                            .light = aob_light_uniform,
                            .mean_light = 0.5};
    uint32_t random = 11;
    for (size_t i = 0; i < SIDE * SIDE; i++) {
        size_t x = i % SIDE, y = i / SIDE;
        double v = x < SIDE / 4 ? 1 : x < SIDE / 2 ? 0.5 : x % 5 ? 0.95 : 0.3 + 0.5 * (double)y / SIDE;
        int open = 0;
        for (int r = 0; r < spp; r++)
            open += random_unit(&random) < v;
        surfaces[i] = surface((double)open / spp, 0.8);
        pixel[i] = i;
    }
    for (int c = 0; c < 3; c++)
        seen.light.sh[2][c] = 0.6;
    aob_effect_bounds_find(&seen, &bounds);
    return bounds;
}

/* Noise makes no bound smaller, and not much larger. */
static void test_rays(void **state)
{
    static const enum aob_effect_id judged[] = {AOB_EFFECT_MULTI_BOUNCE, AOB_EFFECT_DIRECTIONAL,
                                                AOB_EFFECT_SPECULAR};
    struct aob_effect_bounds many = bounds_by_rays(256);
    (void)state;
    for (int spp = 2; spp <= 32; spp *= 2) {
        struct aob_effect_bounds few = bounds_by_rays(spp);
        for (size_t i = 0; i < 3; i++) {
            double share = few.most[judged[i]] / many.most[judged[i]];
            print_message("           %2d rays: %.3f of what 256 say\n", spp, share);
            assert_true(share > 0.99 && share < 1.5);
        }
    }
}

static unsigned open_at(double bounces, double light, double lobe, double tolerance)
{
    struct aob_effect_bounds b = {.most = {[AOB_EFFECT_VISIBILITY] = INFINITY,
                                           [AOB_EFFECT_MULTI_BOUNCE] = bounces,
                                           [AOB_EFFECT_BENT_NORMAL] = light,
                                           [AOB_EFFECT_DIRECTIONAL] = light,
                                           [AOB_EFFECT_SPECULAR] = lobe,
                                           [AOB_EFFECT_HALF_SIZE] = INFINITY}};
    return aob_effect_bounds_open(&b, tolerance);
}

/* The least go first, as long as all that went change no more than a quarter of the tolerance. */
static void test_open(void **state)
{
    const unsigned bounces = AOB_EFFECT_BIT(AOB_EFFECT_MULTI_BOUNCE),
                   lobe = AOB_EFFECT_BIT(AOB_EFFECT_SPECULAR),
                   light = AOB_EFFECT_BIT(AOB_EFFECT_DIRECTIONAL) | AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL);
    (void)state;
    assert_int_equal(open_at(0.5, 0.5, 0.5, 0.02), AOB_EFFECT_ALL);
    assert_int_equal(open_at(0.5, 0.5, 0.0051, 0.02), AOB_EFFECT_ALL);
    assert_int_equal(open_at(0.5, 0, 0.5, 0), AOB_EFFECT_ALL & ~light);
    assert_int_equal(open_at(0.004, 0, 0.003, 0.02), AOB_EFFECT_ALL & ~light & ~lobe);
    assert_int_equal(open_at(0.0019, 0, 0.003, 0.02), AOB_EFFECT_ALL & ~light & ~lobe & ~bounces);
    assert_int_equal(open_at(0.0019, 0.5, 0.003, 0.02), AOB_EFFECT_ALL & ~lobe & ~bounces);
}

/* What is left of a quarter of .02. */
static void test_left(void **state)
{
    struct aob_effect_bounds b = {.most = {[AOB_EFFECT_MULTI_BOUNCE] = 0.0019,
                                           [AOB_EFFECT_BENT_NORMAL] = 0.5,
                                           [AOB_EFFECT_DIRECTIONAL] = 0.5,
                                           [AOB_EFFECT_SPECULAR] = 0.003}};
    (void)state;
    assert_float_equal(aob_effect_bounds_left(&b, 0.02), 0.0001, 1e-12);
    b.most[AOB_EFFECT_SPECULAR] = 0.0032; /* it stays in */
    assert_float_equal(aob_effect_bounds_left(&b, 0.02), 0.0031, 1e-12);
    assert_float_equal(aob_effect_bounds_left(&b, 0), 0, 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_even), cmocka_unit_test(test_slanted), cmocka_unit_test(test_brightest),
        cmocka_unit_test(test_rays), cmocka_unit_test(test_open),    cmocka_unit_test(test_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
