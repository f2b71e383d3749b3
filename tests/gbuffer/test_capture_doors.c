/* What careless files bring: each is read rightly, or a line says what is wrong or doubtful. */
#include <math.h>
#include <stdlib.h>
#include <unistd.h>
#include "check.h"
#include "base/memory.h"
#include "exr_second.h"
#include "gbuffer/capture.h"
#include "store/image.h"

enum { W = 32, H = 24, COUNT = W * H };
static char path[64];
static float z[COUNT], up[COUNT], zero[COUNT];

struct door {
    struct exr_second_desc file;
    struct aob_convention convention;
};

/* A depth of this type, from `low` at the top to `high` at the bottom. */
static struct door slope(double low, double high, char type)
{
    struct door door = {.file = {.names = {"Z"}, .pixels = {z}, .types = {type}, .compression = "ZIP"}};
    door.file.width = W;
    door.file.height = H;
    for (int i = 0; i < COUNT; i++) {
        z[i] = (float)(low + (high - low) * (i / W) / (H - 1));
        up[i] = 1;
    }
    return door;
}

static bool read_door(const struct door *door, struct aob_capture *capture, struct aob_error *error)
{
    const struct aob_capture_desc desc = {.file = path, .convention = door->convention, .fov_deg = 50};
    *error = (struct aob_error){{0}};
    assert_true(exr_second_write(path, &door->file));
    return aob_capture_read(capture, &desc, error);
}

/* It is read, with one warning that holds the text, or with none (NULL). */
static struct aob_capture expect_warning(const struct door *door, const char *text)
{
    struct aob_capture capture;
    struct aob_error error;
    if (!read_door(door, &capture, &error))
        fail_msg("%s", error.text);
    if (capture.warning_count != (text != NULL))
        fail_msg("%zu warnings: %s", capture.warning_count, capture.warnings[0].text);
    if (text) {
        assert_contains(capture.warnings[0].text, text);
        assert_contains(capture.warnings[0].text, path);
        assert_null(strchr(capture.warnings[0].text, '\n'));
    }
    return capture;
}

static void warns(const struct door *door, const char *text)
{
    struct aob_capture capture = expect_warning(door, text);
    aob_capture_finish(&capture);
}

static void expect_refusal(const struct door *door, const char *text)
{
    struct aob_capture capture;
    struct aob_error error;
    assert_false(read_door(door, &capture, &error));
    assert_contains(error.text, text);
    assert_contains(error.text, path);
}

static void test_no_lengths(void **state)
{
    (void)state;
    struct door door = slope(0.05, 0.98, 'f');
    warns(&door, "every depth lies within 0..1 (0.05 to 0.98)");
    door = slope(0.9, 0.1, 'h'); /* near is white */
    warns(&door, "every depth lies within 0..1");
    door = slope(0.05, 1.01, 'f');
    warns(&door, NULL);
    z[3] = INFINITY; /* the sky is no length */
    warns(&door, NULL);

    static const char *const stated[] = {"planar", "distance"};
    for (size_t i = 0; i < AOB_COUNT(stated); i++) {
        door = slope(0.05, 0.98, 'f');
        assert_true(aob_convention_set(&door.convention, AOB_CONVENTION_DEPTH, stated[i], NULL));
        warns(&door, NULL);
    }
}

/* An image of this program is planar whatever its values are. */
static void test_own_image(void **state)
{
    (void)state;
    struct aob_image image = {.width = W, .height = H};
    const struct aob_capture_desc desc = {.file = path};
    struct aob_capture capture;
    struct aob_error error = {{0}};
    slope(0.05, 0.98, 'f');
    memcpy(aob_image_add(&image, "Z"), z, sizeof z);
    aob_image_set_number(&image, "aobudget.fov_deg", 50);
    aob_image_set_number(&image, "aobudget.ortho_height", 0);
    aob_image_set_vec3(&image, "aobudget.eye", (const double[3]){0, 0, 0});
    aob_image_set_vec3(&image, "aobudget.target", (const double[3]){0, 0, -1});
    assert_true(aob_image_write(&image, path, &error));
    assert_true(aob_capture_read(&capture, &desc, &error));
    assert_int_equal(capture.warning_count, 0);
    aob_capture_finish(&capture);
    aob_image_finish(&image);
}

static void test_half_ends(void **state)
{
    (void)state;
    struct door door = slope(100, 40000, 'h');
    warns(&door, "reach 40000: a half ends at 65504");
    door = slope(100, 40000, 'f');
    warns(&door, NULL);
    door = slope(100, 80000, 'h');
    struct aob_capture capture = expect_warning(&door, "a half ends at 65504");
    assert_true(capture.hits.depth[COUNT - 1] == 0 && capture.surface < COUNT);
    aob_capture_finish(&capture);
}

static void test_kind_of_device_depth(void **state)
{
    static const struct {
        const char *kind;
        double low, high;
        const char *doubt;
    } kinds[] = {{"device", 0.001, 0.4, "is it device_reversed?"},
                 {"device", 0.5, 0.999, NULL},
                 {"device_reversed", 0.9, 0.999, "is it device?"},
                 {"device_reversed", 0.001, 0.9, NULL}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(kinds); i++) {
        struct door door = slope(kinds[i].low, kinds[i].high, 'f');
        assert_true(aob_convention_set(&door.convention, AOB_CONVENTION_DEPTH, kinds[i].kind, NULL));
        door.convention.near = 0.1;
        door.convention.far = 1000;
        warns(&door, kinds[i].doubt);
    }
}

static void test_signs_and_no_numbers(void **state)
{
    (void)state;
    struct door door = slope(-2, -9, 'f');
    expect_refusal(&door, "768 of 768 depths are below 0: write the distance from the camera");
    door = slope(2, 9, 'f');
    z[0] = -1;
    z[1] = NAN;
    z[2] = INFINITY;
    z[3] = -INFINITY;
    z[4] = 0;
    z[5] = 1e30f;
    struct aob_capture capture = expect_warning(&door, NULL);
    for (int i = 0; i < COUNT; i++)
        assert_true(capture.hits.depth[i] == (i < 6 ? 0 : z[i]));
    aob_capture_finish(&capture);
}

static void test_missing_normals(void **state)
{
    (void)state;
    struct door door = slope(2, 2, 'f');
    static const char *const names[4] = {"Z", "N.X", "N.Y", "N.Z"};
    const float *const planes[4] = {z, zero, zero, up};
    for (int c = 0; c < 4; c++) {
        door.file.names[c] = names[c];
        door.file.pixels[c] = planes[c];
        door.file.types[c] = 'f';
    }
    warns(&door, NULL);
    for (int i = 0; i < COUNT / 2; i++)
        up[i] = i % 2 ? 0 : NAN;
    warns(&door, "384 of 768 pixels have no normal: theirs are derived");
}

static void test_forms(void **state)
{
    (void)state;
    struct door door = slope(2, 300, 'u');
    struct aob_capture capture = expect_warning(&door, NULL);
    for (int i = 0; i < COUNT; i++)
        assert_true(capture.hits.depth[i] == truncf(z[i]));
    aob_capture_finish(&capture);

    door = slope(2, 9, 'f');
    door.file.sampling = 2;
    expect_refusal(&door, "channel Z is subsampled");

    /* A channel that nobody reads may be subsampled. */
    door = slope(2, 9, 'f');
    door.file.names[1] = "RY";
    door.file.pixels[1] = up;
    door.file.types[1] = 'h';
    door.file.sampling = 2;
    capture = expect_warning(&door, NULL);
    for (int i = 0; i < COUNT; i++)
        assert_true(capture.hits.depth[i] == z[i]);
    aob_capture_finish(&capture);

    door = slope(2, 9, 'h');
    door.file.compression = "B44";
    expect_refusal(&door, "its compression (B44) is not read");
}

static void test_deep(void **state)
{
    (void)state;
    struct aob_capture capture;
    struct aob_error error = {{0}};
    const struct aob_capture_desc desc = {.file = path, .fov_deg = 50};
    assert_true(exr_second_write_deep(path, W, H));
    assert_false(aob_capture_read(&capture, &desc, &error));
    assert_contains(error.text, "deep images are not supported");
}

/* A file of two views: the first one's names are bare. */
static void test_two_views(void **state)
{
    (void)state;
    struct door door = slope(2, 9, 'f');
    static float other[COUNT];
    for (int i = 0; i < COUNT; i++)
        other[i] = 50;
    door.file.names[1] = "right.Z";
    door.file.pixels[1] = other;
    door.file.types[1] = 'f';
    door.file.views[0] = "left";
    door.file.views[1] = "right";
    struct aob_capture capture = expect_warning(&door, "reads Z as depth; right.Z would do as well");
    assert_true(capture.hits.depth[COUNT - 1] == 9);
    aob_capture_finish(&capture);
}

static int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    snprintf(path, sizeof path, "/tmp/aobudget-doors-%ld.exr", (long)getpid());
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_no_lengths),
        cmocka_unit_test(test_own_image),
        cmocka_unit_test(test_half_ends),
        cmocka_unit_test(test_kind_of_device_depth),
        cmocka_unit_test(test_signs_and_no_numbers),
        cmocka_unit_test(test_missing_normals),
        cmocka_unit_test(test_forms),
        cmocka_unit_test(test_deep),
        cmocka_unit_test(test_two_views),
    };
    return cmocka_run_group_tests(tests, NULL, remove_file);
}
