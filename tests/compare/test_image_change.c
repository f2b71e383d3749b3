#include "check.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "compare/image_change.h"

enum { W = 5, H = 2 };

/* A flat image of 0.5 whose last pixel is sky. */
static void make(struct aob_image *image)
{
    *image = (struct aob_image){.width = W, .height = H};
    float *z = aob_image_add(image, "Z"), *ao = aob_image_add(image, "technique.AO");
    for (int i = 0; i < W * H; i++) {
        z[i] = i == W * H - 1 ? INFINITY : 3;
        ao[i] = 0.5f;
    }
}

static struct aob_image_change measure(const struct aob_image *a, const struct aob_image *b)
{
    struct aob_image_change change;
    struct aob_error error = {{0}};
    if (!aob_image_change_measure(&change, a, b, &error))
        fail_msg("%s", error.text);
    return change;
}

static void test_figures(void **state)
{
    (void)state;
    struct aob_image a, b;
    make(&a);
    make(&b);
    float *ao = aob_image_channel(&b, "technique.AO");
    ao[W * H - 1] = 0; /* sky is not judged */
    struct aob_image_change none = measure(&a, &b);
    assert_false(none.moved);
    assert_true(none.max == 0 && none.rmse == 0 && none.share == 0);
    assert_int_equal(none.pixels, W * H - 1);
    ao[0] = 0.25f;
    ao[3] = 0.5f + 1 / 512.0f;
    struct aob_image_change change = measure(&a, &b), back = measure(&b, &a);
    assert_true(change.moved && back.moved);
    assert_near(change.max, 0.25, 1e-12);
    assert_near(change.rmse, sqrt((0.0625 + 1 / 262144.0) / 9), 1e-12);
    assert_near(change.share, 1 / 9.0, 1e-12);
    assert_near(back.rmse, change.rmse, 0);
    aob_image_finish(&a);
    aob_image_finish(&b);
}

/* An image is all that the technique wrote: a bent normal moves too, and so does one that is new. */
static void test_bent(void **state)
{
    (void)state;
    struct aob_image a, b;
    make(&a);
    make(&b);
    aob_image_add(&b, "technique.bent.Y");
    assert_true(measure(&a, &b).moved);
    aob_image_add(&a, "technique.bent.Y");
    assert_false(measure(&a, &b).moved);
    aob_image_channel(&b, "technique.bent.Y")[W * H - 1] = 1;
    assert_false(measure(&a, &b).moved);
    aob_image_channel(&b, "technique.bent.Y")[1] = 1e-6f;
    assert_true(measure(&a, &b).moved);
    assert_true(measure(&a, &b).max == 0);
    aob_image_finish(&a);
    aob_image_finish(&b);
}

static void test_refusals(void **state)
{
    (void)state;
    struct aob_image a, b = {.width = W, .height = H};
    struct aob_image_change change;
    struct aob_error error = {{0}};
    make(&a);
    assert_false(aob_image_change_measure(&change, &a, &b, &error));
    assert_contains(error.text, "technique.AO");
    aob_image_finish(&b);
    make(&b);
    b.height = 1;
    assert_false(aob_image_change_measure(&change, &a, &b, &error));
    assert_contains(error.text, "5x2 and 5x1");
    assert_false(aob_image_change_write(&a, &b, "/dev/full/none.exr", &error));
    aob_image_finish(&a);
    aob_image_finish(&b);
}

static void test_map(void **state)
{
    (void)state;
    char path[] = "/tmp/aob-map-XXXXXX";
    struct aob_image a, b, map;
    struct aob_error error = {{0}};
    close(mkstemp(path));
    make(&a);
    make(&b);
    aob_image_channel(&b, "technique.AO")[2] = 0.75f;
    aob_image_channel(&b, "technique.AO")[W * H - 1] = 1;
    assert_true(aob_image_change_write(&a, &b, path, &error));
    assert_true(aob_image_read(&map, path, &error));
    for (int i = 0; i < W * H; i++)
        assert_true(aob_image_channel(&map, "error.AO")[i] == (i == 2 ? 0.25f : 0));
    assert_true(aob_image_channel(&map, "technique.AO")[2] == 0.75f);
    assert_true(aob_image_channel(&map, "reference.AO")[2] == 0.5f);
    assert_true(isinf(aob_image_channel(&map, "Z")[W * H - 1]));
    unlink(path);
    aob_image_finish(&a);
    aob_image_finish(&b);
    aob_image_finish(&map);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_figures), cmocka_unit_test(test_bent),
                                       cmocka_unit_test(test_refusals), cmocka_unit_test(test_map)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
