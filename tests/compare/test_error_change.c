#include "check.h"
#include <math.h>
#include "compare/error_change.h"
#include "random.h"

/* Images and truths are made up, so that the exact error is known: of N pixels the first BAND show something, where an image
 * errs by up to .1 either way and the truth of one ray a pixel has a standard error of .15 to .25. */
enum { N = 4000, BAND = 1500, TRIALS = 400 };

struct scene {
    double error[2][N], noise[N]; /* of image A and B; of a truth of one ray */
};
struct sample {
    double sum, squares;
};

static void make(struct scene *scene, uint32_t *state)
{
    for (int i = 0; i < N; i++) {
        scene->error[0][i] = scene->error[1][i] = i < BAND ? 0.2 * random_unit(state) - 0.1 : 0;
        scene->noise[i] = i < BAND ? 0.15 + 0.1 * random_unit(state) : 0;
    }
}

/* The truth as the tracer makes it: the mean of two halves, and half their difference as its standard error. */
static double trace(const struct scene *scene, double rays, double truth[N], uint32_t *state)
{
    double squares = 0;
    for (int i = 0; i < N; i++) {
        double half = scene->noise[i] * sqrt(2 / rays), a = half * random_normal(state),
               b = half * random_normal(state);
        truth[i] = (a + b) / 2;
        squares += (a - b) * (a - b) / 4;
    }
    return sqrt(squares / N);
}

static struct aob_error_side score(const double error[N], const double truth[N], double se)
{
    double squares = 0;
    for (int i = 0; i < N; i++)
        squares += (error[i] - truth[i]) * (error[i] - truth[i]);
    return (struct aob_error_side){sqrt(squares / N), se, BAND};
}

static void add(struct sample *sample, double value)
{
    sample->sum += value;
    sample->squares += value * value;
}

static double deviation(const struct sample *sample)
{
    double mean = sample->sum / TRIALS;
    return sqrt(sample->squares / TRIALS - mean * mean);
}

/* One image against truths of 16 rays and of 1024: its RMSE differs by the noise, and its error does not. */
static void test_other_rays(void **state)
{
    (void)state;
    uint32_t random = 1;
    struct scene scene;
    struct sample coarse = {0};
    double truth[N], foreseen = 0;
    int told = 0;
    make(&scene, &random);
    for (int t = 0; t < TRIALS; t++) {
        double se = trace(&scene, 16, truth, &random);
        struct aob_error_pair pair = {.a = score(scene.error[0], truth, se), .apart = NAN};
        se = trace(&scene, 1024, truth, &random);
        pair.b = score(scene.error[0], truth, se);
        assert_true(pair.a.rmse - pair.b.rmse > 10 * AOB_ERROR_LEAST);
        told += aob_error_change(&pair) != AOB_ERROR_EQUAL;
        add(&coarse, pair.a.rmse * pair.a.rmse - pair.a.se * pair.a.se);
        foreseen += 2 * pair.a.se * pair.a.rmse / sqrt(BAND) / TRIALS;
    }
    assert_true(told <= 6);                             /* 1.1 of 400 by the normal distribution */
    assert_near(deviation(&coarse) / foreseen, 1, 0.2); /* 3.5 % is its own scatter */
    const double none[N] = {0};
    double exact = score(scene.error[0], none, 0).rmse;
    assert_near(coarse.sum / TRIALS, exact * exact, 4 * foreseen / sqrt(TRIALS));
}

/* The same two truths, and an image whose error is 10 % larger: by about eight standard errors. */
static void test_larger_error(void **state)
{
    (void)state;
    uint32_t random = 2;
    struct scene scene;
    double truth[N];
    int more = 0, less = 0;
    make(&scene, &random);
    for (int i = 0; i < N; i++)
        scene.error[1][i] *= 1.1;
    for (int t = 0; t < TRIALS; t++) {
        double se = trace(&scene, 64, truth, &random);
        struct aob_error_pair pair = {.a = score(scene.error[0], truth, se), .apart = NAN};
        se = trace(&scene, 1024, truth, &random);
        pair.b = score(scene.error[1], truth, se);
        more += aob_error_change(&pair) == AOB_ERROR_MORE;
        const struct aob_error_pair turned = {pair.b, pair.a, NAN};
        less += aob_error_change(&turned) == AOB_ERROR_LESS;
    }
    assert_true(more >= TRIALS * 99 / 100 && less == more);
}

/* Two images of one error, which lie on the other side of the truth in half of the pixels, against one coarse truth. */
static void test_one_truth(void **state)
{
    (void)state;
    uint32_t random = 3;
    struct scene scene;
    struct sample change = {0};
    double truth[N], apart = 0, foreseen = 0;
    int told = 0;
    make(&scene, &random);
    for (int i = 0; i < N; i++) {
        scene.error[1][i] *= random_below(&random, 2) ? 1 : -1;
        apart += (scene.error[1][i] - scene.error[0][i]) * (scene.error[1][i] - scene.error[0][i]) / N;
    }
    for (int t = 0; t < TRIALS; t++) {
        double se = trace(&scene, 16, truth, &random);
        const struct aob_error_pair pair = {score(scene.error[0], truth, se),
                                            score(scene.error[1], truth, se), sqrt(apart)};
        told += aob_error_change(&pair) != AOB_ERROR_EQUAL;
        add(&change, pair.b.rmse * pair.b.rmse - pair.a.rmse * pair.a.rmse);
        foreseen += 2 * se * sqrt(apart) / sqrt(BAND) / TRIALS;
    }
    assert_true(told <= 6);
    assert_near(deviation(&change) / foreseen, 1, 0.2);
}

/* A hair's difference of two images counts where one truth served both, and is lost between two. */
static void test_noise_in_common(void **state)
{
    (void)state;
    struct aob_error_pair pair = {{0.0500, 0.01, 2500}, {0.0504, 0.01, 2500}, NAN};
    /* 3 x hypot(2 x .01 x .05, 2 x .01 x .0504) / 50 is 8.5e-5; the squares differ by 4.0e-5. */
    assert_int_equal(aob_error_change(&pair), AOB_ERROR_EQUAL);
    pair.apart = 0.002; /* 3 x 2 x .01 x .002 / 50 = 2.4e-6 */
    assert_int_equal(aob_error_change(&pair), AOB_ERROR_MORE);
    pair.apart = 0.034; /* 4.1e-5 */
    assert_int_equal(aob_error_change(&pair), AOB_ERROR_EQUAL);
    pair.apart = 0.033; /* 4.0e-5: just below the difference of 4.016e-5 */
    assert_int_equal(aob_error_change(&pair), AOB_ERROR_MORE);
}

static void test_edges(void **state)
{
    (void)state;
    char text[200];
    struct aob_error_pair pair = {{0.05, 0, 100}, {0.05 + 0.99 * AOB_ERROR_LEAST, 0, 100}, NAN};
    assert_int_equal(aob_error_change(&pair), AOB_ERROR_EQUAL);
    pair.b.rmse = 0.05 - 1.01 * AOB_ERROR_LEAST;
    assert_int_equal(aob_error_change(&pair), AOB_ERROR_LESS);
    pair.b.se = NAN;
    assert_int_equal(aob_error_change(&pair), AOB_ERROR_UNKNOWN);
    aob_error_change_print(&pair, text, sizeof text);
    assert_string_equal(text, "RMSE 0.0500 -> 0.0499 (not known which is better)");
    pair.b.rmse = NAN;
    aob_error_change_print(&pair, text, sizeof text);
    assert_string_equal(text, "the error of one is not known");
    /* An image that is right: all of its RMSE is the truth's. */
    const struct aob_error_side right = {0.02, 0.0201, 100};
    assert_near(aob_error_true_rmse(&right), 0, 0);
    pair = (struct aob_error_pair){{0.05, 0.03, 100}, {0.04, 0, 100}, NAN};
    aob_error_change_print(&pair, text, sizeof text);
    assert_string_equal(text,
                        "RMSE 0.0500 -> 0.0400, without the noise of the truths 0.0400 -> 0.0400 (equal)");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_other_rays), cmocka_unit_test(test_larger_error),
        cmocka_unit_test(test_one_truth),  cmocka_unit_test(test_noise_in_common),
        cmocka_unit_test(test_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
