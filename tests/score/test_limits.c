#include "check.h"
#include <float.h>
#include <math.h>
#include "score/bent.h"
#include "score/score.h"

/* Where each class of pixels begins and ends, at the limit itself and one float beside it. */

enum { MAX = 32 };

/* A row of pixels: errors are image less truth, nothing is sky. */
struct row {
    float image[MAX], truth[MAX], depth[MAX];
    struct aob_score_desc desc;
};

static void init(struct row *row, int count)
{
    *row = (struct row){.desc = {.width = count,
                                 .height = 1,
                                 .image = row->image,
                                 .truth = row->truth,
                                 .depth = row->depth,
                                 .sky_depth = 5e8f,
                                 .radius = 0,
                                 .pixel_scale = 1,
                                 .perspective = 1}};
    for (int i = 0; i < count; i++)
        row->depth[i] = 1;
}

/* In band is what lies below 0.995, whose nearest float is 0.99500000477. */
static void test_band_limit(void **state)
{
    (void)state;
    struct row row;
    struct aob_metrics m;
    init(&row, 5);
    const float truths[5] = {0, 0.99f, nextafterf(0.995f, 0), 0.995f, 1};
    for (int i = 0; i < 5; i++) {
        row.truth[i] = truths[i];
        row.image[i] = truths[i] + 0.01f * (float)(i + 1);
    }
    aob_score(&row.desc, &m);
    assert_int_equal(m.band_pixels, 3);
    assert_near(m.band_rmse, sqrt((1 + 4 + 9) * 1e-4 / 3), 1e-6);
    assert_near(m.rmse, sqrt(55e-4 / 5), 1e-6);
}

/* The sky begins at its depth. */
static void test_sky_limit(void **state)
{
    (void)state;
    struct row row;
    struct aob_metrics m;
    init(&row, 4);
    const float depths[4] = {1, nextafterf(5e8f, 0), 5e8f, NAN};
    for (int i = 0; i < 4; i++) {
        row.depth[i] = depths[i];
        row.image[i] = 0.25f;
        assert_int_equal(aob_score_is_sky(&row.desc, (size_t)i), i >= 2);
    }
    aob_score(&row.desc, &m);
    assert_int_equal(m.pixels, 2);
    assert_near(m.rmse, 0.25, 0);
}

/* Pixel centres lie at .5, 1.5 ...: a reach of 1.5 pixels takes the outermost of a row in, and not the next. */
static void test_border_limit(void **state)
{
    (void)state;
    static const struct {
        double radius;
        int outer; /* pixels on each side */
    } rows[] = {{0.5, 0}, {0.5001, 1}, {1.5, 1}, {1.5001, 2}, {2.4999, 2}, {2.5001, 3}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct row row;
        struct aob_metrics m;
        float tall[9 * 9] = {0}, depth[9 * 9];
        init(&row, 9);
        row.desc.height = 9; /* the middle pixel is 4.5 from each edge */
        row.desc.image = tall;
        row.desc.truth = tall;
        row.desc.depth = depth;
        row.desc.radius = rows[i].radius;
        for (int p = 0; p < 81; p++)
            depth[p] = 1;
        float image[81] = {0};
        for (int p = 0; p < 9; p++) /* along the middle row, errors 1, 2, 3 ... from both edges */
            image[4 * 9 + p] = (float)(p < 5 ? p + 1 : 9 - p);
        row.desc.image = image;
        aob_score(&row.desc, &m);
        double inside = 0, all = 25;
        for (int k = 1; k <= 4; k++) {
            all += 2.0 * k * k;
            inside += k <= rows[i].outer ? 2.0 * k * k : 0;
        }
        assert_near(m.border_share, inside / all, 1e-9);
    }
}

/* The 95th percentile of 0 .. 20 hundredths is 19 of them; of 0 .. 19 it lies a twentieth past the 18th. */
static void test_percentile(void **state)
{
    (void)state;
    struct row row;
    struct aob_metrics m;
    for (int count = 20; count <= 21; count++) {
        init(&row, count);
        for (int i = 0; i < count; i++) /* in no order, of both signs */
            row.image[i] = (i % 2 ? -0.01f : 0.01f) * (float)(7 * i % count);
        if (count == 21) /* 7 divides 21 */
            for (int i = 0; i < count; i++)
                row.image[i] = (i % 2 ? -0.01f : 0.01f) * (float)(8 * i % count);
        aob_score(&row.desc, &m);
        assert_near(m.p95, count == 21 ? 0.19 : 0.1805, 1e-7);
        assert_near(m.max, 0.01 * (count - 1), 1e-7);
    }
}

/* A visibility may be 0 and 1, and nothing past them. */
static void test_judge_limits(void **state)
{
    (void)state;
    struct row row;
    struct aob_error error;
    init(&row, 2);
    const float good[] = {0, -0.0f, 1}, bad[] = {-FLT_TRUE_MIN, nextafterf(1, 2)};
    for (int i = 0; i < 3; i++) {
        row.image[1] = good[i];
        assert_true(aob_score_judge(&row.desc, &error));
    }
    for (int i = 0; i < 2; i++) {
        row.image[1] = bad[i];
        assert_false(aob_score_judge(&row.desc, &error));
    }
}

/* A bent normal may be 1 % too long, and a truth no longer than AOB_BENT_LEAST says too little. */
static void test_bent_limits(void **state)
{
    (void)state;
    struct row row;
    struct aob_error error;
    struct aob_metrics m;
    float image[21][3] = {{0}}, open[21][3] = {{0}};
    const struct aob_bent_truth truth = {(const float(*)[3])open, (const float(*)[3])open};
    init(&row, 21);
    for (int i = 0; i < 21; i++) { /* turned by i degrees */
        open[i][2] = 1;
        image[i][0] = (float)sin(i * M_PI / 180);
        image[i][2] = (float)cos(i * M_PI / 180);
    }
    aob_bent_score(&row.desc, (const float(*)[3])image, &truth, &m);
    assert_near(m.bent_mean, 10, 1e-4);
    assert_near(m.bent_p95, 19, 1e-4);
    open[20][2] = (float)AOB_BENT_LEAST * 0.999f;
    aob_bent_score(&row.desc, (const float(*)[3])image, &truth, &m);
    assert_int_equal(m.bent_pixels, 20);
    open[20][2] = (float)AOB_BENT_LEAST * 1.001f;
    aob_bent_score(&row.desc, (const float(*)[3])image, &truth, &m);
    assert_int_equal(m.bent_pixels, 21);
    image[3][0] = 0;
    image[3][2] = 1.0099f;
    assert_true(aob_bent_judge(&row.desc, (const float(*)[3])image, &error));
    image[3][2] = 1.0101f;
    assert_false(aob_bent_judge(&row.desc, (const float(*)[3])image, &error));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_band_limit),   cmocka_unit_test(test_sky_limit),
        cmocka_unit_test(test_border_limit), cmocka_unit_test(test_percentile),
        cmocka_unit_test(test_judge_limits), cmocka_unit_test(test_bent_limits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
