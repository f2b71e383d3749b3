/* Images of this program, as they are written and come back. */
#include "image_sample.h"
#include "base/file.h"

static void assert_same(const struct aob_image *a, const struct aob_image *b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_int_equal(a->channel_count, b->channel_count);
    size_t size = (size_t)a->width * (size_t)a->height * sizeof(float);
    for (size_t i = 0; i < a->channel_count; i++) {
        const float *other = aob_image_channel(b, a->channels[i].name);
        assert_non_null(other);
        assert_memory_equal(a->channels[i].pixels, other, size);
    }
}

static void test_round_trip_is_bit_exact(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {1, 33}, {37, 1}, {129, 47}, {480, 270}};
    char path[PATH_SIZE];
    test_path(path, "round.exr");
    for (size_t i = 0; i < AOB_COUNT(sizes); i++) {
        struct aob_image image = sample_image(sizes[i][0], sizes[i][1]), back;
        struct aob_error error = {0};
        assert_true(aob_image_write(&image, path, &error));
        assert_true(aob_image_read(&back, path, &error));
        assert_same(&image, &back);
        aob_image_finish(&image);
        aob_image_finish(&back);
    }
    unlink(path);
}

static void test_attributes_come_back_and_can_be_written_again(void **state)
{
    (void)state;
    char path[PATH_SIZE];
    test_path(path, "attributes.exr");
    struct aob_image image = sample_image(8, 8), back, again;
    aob_image_set_number(&image, "aobudget.fov_deg", 1.0 / 3.0);
    assert_true(aob_image_write(&image, path, NULL));
    assert_true(aob_image_read(&back, path, NULL));
    assert_true(aob_image_write(&back, path, NULL));
    assert_true(aob_image_read(&again, path, NULL));
    assert_int_equal(again.attribute_count, 3);
    const struct aob_attribute *fov = find_attribute(&again, "aobudget.fov_deg");
    assert_true(fov && fov->count == 1 && fov->values[0] == 1.0 / 3.0);
    const struct aob_attribute *eye = find_attribute(&again, "aobudget.eye");
    assert_true(eye && eye->count == 3 && eye->values[0] == 0.1 && eye->values[2] == 4e-7);
    const struct aob_attribute *text = find_attribute(&again, "aobudget.technique");
    assert_true(text && text->count == 0);
    assert_string_equal(text->text, "gtao \"x\" \xc3\xbc");
    aob_image_finish(&image);
    aob_image_finish(&back);
    aob_image_finish(&again);
    unlink(path);
}

static void test_same_image_gives_same_bytes(void **state)
{
    (void)state;
    char path[PATH_SIZE];
    test_path(path, "bytes.exr");
    struct aob_image image = sample_image(65, 33);
    char *bytes[2];
    size_t size[2];
    for (int i = 0; i < 2; i++) {
        assert_true(aob_image_write(&image, path, NULL));
        bytes[i] = aob_file_read(path, 1 << 24, &size[i], NULL);
        assert_non_null(bytes[i]);
    }
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(bytes[0], bytes[1], size[0]);
    free(bytes[0]);
    free(bytes[1]);
    aob_image_finish(&image);
    unlink(path);
}

static void test_channel_is_found_or_not(void **state)
{
    (void)state;
    struct aob_image image = {.width = 3, .height = 2};
    float *z = aob_image_add(&image, "Z");
    z[5] = 4;
    assert_ptr_equal(aob_image_channel(&image, "Z"), z);
    assert_null(aob_image_channel(&image, "z"));
    assert_ptr_equal(aob_image_add(&image, "Z"), z);
    assert_true(z[5] == 0);
    assert_int_equal(image.channel_count, 1);
    aob_image_finish(&image);
    aob_image_finish(&image);
}

static void test_unwritable_path_is_one_line(void **state)
{
    (void)state;
    struct aob_image image = sample_image(4, 4), empty = {0};
    struct aob_error error = {0};
    assert_false(aob_image_write(&image, "/nonexistent/folder/x.exr", &error));
    assert_non_null(strstr(error.text, "/nonexistent/folder/x.exr"));
    assert_null(strchr(error.text, '\n'));
    assert_false(aob_image_write(&empty, "/tmp/never.exr", &error));
    assert_false(aob_file_exists("/tmp/never.exr"));
    aob_image_finish(&image);
}

static void test_failed_write_leaves_the_old_file(void **state)
{
    (void)state;
    char path[PATH_SIZE];
    test_path(path, "folder.exr");
    struct aob_error error = {0};
    assert_true(aob_folder_create(path, &error));
    struct aob_image image = sample_image(4, 4);
    assert_false(aob_image_write(&image, path, &error));
    aob_image_finish(&image);
    assert_int_equal(rmdir(path), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_round_trip_is_bit_exact),
        cmocka_unit_test(test_attributes_come_back_and_can_be_written_again),
        cmocka_unit_test(test_same_image_gives_same_bytes),
        cmocka_unit_test(test_channel_is_found_or_not),
        cmocka_unit_test(test_unwritable_path_is_one_line),
        cmocka_unit_test(test_failed_write_leaves_the_old_file),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
