#include "check.h"
#include "direct_flip.h"
#include "score/flip.h"
#include "pairs.h"

enum { WIDTH = 24, HEIGHT = 18, SIZE = WIDTH * HEIGHT, SCENES = 9 };
struct colours {
    float image[3 * SIZE], truth[3 * SIZE], depth[SIZE];
    struct aob_score_desc desc;
};

/* No sky, and images that hold one colour each. */
static void colours_fill(struct colours *c, const float image[3], const float truth[3])
{
    for (int i = 0; i < SIZE; i++) {
        memcpy(c->image + 3 * i, image, 3 * sizeof *image);
        memcpy(c->truth + 3 * i, truth, 3 * sizeof *truth);
        c->depth[i] = 2;
    }
    c->desc = (struct aob_score_desc){.width = WIDTH, .height = HEIGHT, .depth = c->depth, .sky_depth = 5e8f};
}

static double flip(const struct colours *c, double exposure)
{
    return aob_flip_colour(&c->desc, c->image, c->truth, exposure);
}

static void put_white(struct colours *c, int i)
{
    for (int k = 0; k < 3; k++)
        c->image[3 * i + k] = c->truth[3 * i + k] = 1;
}

/* The light of one channel: noise, or stripes of full primaries, whose blurred colours no screen shows, or patches that
 * are even across and differ by a little. */
static double channel_light(int kind, int x, int y, int k, double noise)
{
    switch (kind) {
    case 0:
        return noise;
    case 1:
        return (x / 3 + y / 5 + 3 - k) % 3 == 0;
    default:
        return 0.2 + 0.6 * ((x / 6 + 2 * (y / 6) + k) % 4) / 3 + 0.1 * noise;
    }
}

/* Three kinds of images by three kinds of differences; each second scene has a white sky. */
static void colours_make(struct colours *c, int index)
{
    static const float black[3] = {0};
    uint32_t state = 901u + (uint32_t)index;
    colours_fill(c, black, black);
    for (int i = 0; i < 3 * SIZE; i++) {
        int x = i / 3 % WIDTH, y = i / 3 / WIDTH;
        double truth = channel_light(index % 3, x, y, i % 3, random_unit(&state));
        double shift = index / 3 == 1 ? 0.3 * (i % 3) - 0.2 : 0.5 * (random_unit(&state) - 0.5);
        double other = channel_light((index + 1) % 3, x, y, i % 3, random_unit(&state));
        c->truth[i] = pair_clamp(truth);
        c->image[i] = pair_clamp(index / 3 == 2 ? other : truth + shift);
    }
    for (int i = 0; i < SIZE && index % 2; i++)
        if (i / WIDTH < 4 + i % WIDTH / 8) {
            put_white(c, i);
            c->depth[i] = 1e9f;
        }
}

static double second_flip(const struct colours *c)
{
    struct direct_colour image[SIZE], truth[SIZE];
    bool sky[SIZE];
    for (int i = 0; i < SIZE; i++) {
        for (int k = 0; k < 3; k++) {
            image[i].c[k] = c->image[3 * i + k];
            truth[i].c[k] = c->truth[3 * i + k];
        }
        sky[i] = c->depth[i] >= c->desc.sky_depth;
    }
    return direct_flip(&(struct direct_pair){WIDTH, HEIGHT, image, truth, sky});
}

static void test_direct_convolution(void **state)
{
    (void)state;
    double low = 1, high = 0;
    for (int i = 0; i < SCENES; i++) {
        struct colours c;
        colours_make(&c, i);
        double now = flip(&c, 1);
        assert_near(now, second_flip(&c), 1e-9);
        low = fmin(low, now);
        high = fmax(high, now);
    }
    assert_true(low < 0.35 && high > 0.8); /* the scenes are not all alike */
}

/* A grey has no colour: its opponents are 0, and what is left are the steps of aob_flip. */
static void test_grey(void **state)
{
    (void)state;
    for (int i = 0; i < PAIR_COUNT; i++) {
        struct pair pair;
        float image[3 * PAIR_SIZE], truth[3 * PAIR_SIZE];
        pair_make(&pair, i);
        for (int k = 0; k < 3 * PAIR_SIZE; k++) {
            image[k] = pair.image[k / 3];
            truth[k] = pair.truth[k / 3];
        }
        assert_near(aob_flip_colour(&pair.desc, image, truth, 1), aob_flip(&pair.desc), 1e-12);
    }
}

struct constant {
    float image[3], truth[3];
    double
        flip; /* from the formulas by another program, with the nine digits of white that the authors give */
};

/* Constants have no features, and the filters keep them: only the colours' difference is left. */
static void test_constants(void **state)
{
    static const struct constant table[] = {
        {{1, 0, 0}, {0, 1, 0}, 0.98666228},
        {{0, 0, 1}, {1, 1, 0}, 0.99897210},
        {{0.25f, 0.5f, 0.75f}, {0.3125f, 0.5f, 0.625f}, 0.23824936},
        {{0.001953125f, 0, 0}, {0, 0, 0.00390625f}, 0.01417837},
        {{0.015625f, 0.03125f, 0}, {0.0078125f, 0.03125f, 0.0625f}, 0.27589843},
        {{1, 1, 1}, {0, 0, 0}, 0.96737976},
        {{0.5f, 0.5f, 0.5f}, {0.5f, 0.5f, 0.53125f}, 0.10151664},
    };
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        const float *a = table[i].image, *b = table[i].truth;
        struct colours c;
        colours_fill(&c, a, b);
        assert_near(flip(&c, 1), table[i].flip, 1e-7);
        assert_near(flip(&c, 1),
                    direct_flip_of_colours((struct direct_colour){{a[0], a[1], a[2]}},
                                           (struct direct_colour){{b[0], b[1], b[2]}}),
                    1e-11);
    }
}

/* Of all pairs of the screen's corners, green and blue differ most, and by 1. */
static void test_largest(void **state)
{
    enum { GREEN = 2, BLUE = 4, CORNERS = 8 };
    (void)state;
    for (int i = 0; i < CORNERS; i++)
        for (int j = 0; j < i; j++) {
            const float a[3] = {i & 1, i >> 1 & 1, i >> 2}, b[3] = {j & 1, j >> 1 & 1, j >> 2};
            struct colours c;
            colours_fill(&c, a, b);
            c.desc.width = c.desc.height = 1;
            if (i == BLUE && j == GREEN)
                assert_near(flip(&c, 1), 1, 1e-12);
            else
                assert_true(flip(&c, 1) < 0.9999);
        }
}

static void test_exposure(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        struct colours c;
        colours_make(&c, i);
        double half = flip(&c, 0.5), twice = flip(&c, 2);
        assert_true(fabs(half - flip(&c, 1)) > 1e-3 && fabs(twice - flip(&c, 1)) > 1e-3);
        for (int k = 0; k < 3 * SIZE; k++) {
            c.image[k] *= 0.5f;
            c.truth[k] *= 0.5f;
        }
        assert_near(flip(&c, 1), half, 1e-12);
        assert_near(flip(&c, 4), twice, 1e-12);
    }
}

/* A screen shows nothing above 1 or below 0. */
static void test_cut(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        struct colours c;
        colours_make(&c, i);
        double shown = flip(&c, 1);
        for (int k = 0; k < 3 * SIZE; k++) {
            float *values[2] = {&c.image[k], &c.truth[k]};
            for (int v = 0; v < 2; v++)
                *values[v] = *values[v] == 1 ? (float)(2 + k % 5) : *values[v] == 0 ? -3 : *values[v];
        }
        assert_true(flip(&c, 1) == shown);
    }
}

/* The sky may hold anything at any exposure, and is seen as white. */
static void test_sky_values(void **state)
{
    (void)state;
    for (int i = 1; i < SCENES; i += 2) {
        struct colours c;
        colours_make(&c, i);
        double white = flip(&c, 1);
        for (int k = 0; k < 3 * SIZE; k++)
            if (c.depth[k / 3] > c.desc.sky_depth) {
                c.image[k] = k % 2 ? NAN : 0;
                c.truth[k] = 0.3f;
            }
        assert_true(flip(&c, 1) == white);
    }
}

/* Where both images are white, and out of the filters' reach, nothing adds to the sum. Sky there leaves the sum, and
 * changes what it is divided by. */
static void test_sky_count(void **state)
{
    (void)state;
    struct colours c;
    colours_make(&c, 0);
    for (int i = 0; i < SIZE; i++)
        if (i % WIDTH >= 8)
            put_white(&c, i);
    double all = flip(&c, 1);
    for (int i = 0; i < SIZE; i++)
        if (i % WIDTH >= 20)
            c.depth[i] = 1e9f;
    assert_near(flip(&c, 1), all * WIDTH / 20, 1e-12);
    for (int i = 0; i < SIZE; i++)
        c.depth[i] = 1e9f;
    assert_true(isnan(flip(&c, 1)));
}

static void test_identities(void **state)
{
    (void)state;
    for (int i = 0; i < SCENES; i++) {
        struct colours c;
        colours_make(&c, i);
        double forth = flip(&c, 1);
        assert_near(aob_flip_colour(&c.desc, c.truth, c.image, 1), forth, 1e-12);
        assert_true(aob_flip_colour(&c.desc, c.truth, c.truth, 1) == 0);
        assert_true(forth > 0 && forth < 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_direct_convolution), cmocka_unit_test(test_grey),
        cmocka_unit_test(test_constants),          cmocka_unit_test(test_largest),
        cmocka_unit_test(test_exposure),           cmocka_unit_test(test_cut),
        cmocka_unit_test(test_sky_values),         cmocka_unit_test(test_sky_count),
        cmocka_unit_test(test_identities)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
