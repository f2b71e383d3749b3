/* Files that are no image any more, or never were one. */
#include "image_sample.h"
#include <fcntl.h>
#include "base/file.h"

static void test_files_that_are_no_image(void **state)
{
    (void)state;
    static const char *const paths[] = {"/nonexistent.exr", "/tmp", "/dev/null", "/proc/self/exe"};
    for (size_t i = 0; i < AOB_COUNT(paths); i++) {
        struct aob_image image;
        struct aob_error error = {0};
        assert_false(aob_image_read(&image, paths[i], &error));
        assert_int_not_equal(error.text[0], 0);
        assert_int_equal(image.channel_count, 0);
    }
}

/* Reads the bytes as a file of another program, which has no seal; whatever comes of it must not crash, and a failure
 * says why. As a file of ours it is refused. */
static void read_damaged(const char *path, const char *bytes, size_t size)
{
    struct aob_error error = {0};
    struct aob_image image;
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    fwrite(bytes, 1, size, file);
    fclose(file);
    if (aob_image_read_layers(&image, path, choose_all, NULL, &error))
        aob_image_finish(&image);
    else
        assert_int_not_equal(error.text[0], 0);
    assert_false(aob_image_read(&image, path, &error));
    assert_int_equal(image.channel_count, 0);
}

/* No byte of a file is beyond the seal, those of the header and of unused room neither. */
static void test_one_changed_bit_is_refused(void **state)
{
    (void)state;
    char path[PATH_SIZE];
    test_path(path, "bit.exr");
    struct aob_image image = {.width = 5, .height = 4}, back;
    fill(aob_image_add(&image, "AO"), 20, 1);
    assert_true(aob_image_write(&image, path, NULL));
    aob_image_finish(&image);
    size_t size;
    char *bytes = aob_file_read(path, 1 << 24, &size, NULL);
    int file = open(path, O_WRONLY);
    for (size_t bit = 0; bit < 8 * size; bit++) {
        char changed = (char)(bytes[bit / 8] ^ (1 << bit % 8));
        assert_int_equal(pwrite(file, &changed, 1, (off_t)(bit / 8)), 1);
        assert_false(aob_image_read(&back, path, NULL));
        assert_int_equal(pwrite(file, bytes + bit / 8, 1, (off_t)(bit / 8)), 1);
    }
    close(file);
    assert_true(aob_image_read(&back, path, NULL));
    aob_image_finish(&back);
    free(bytes);
    unlink(path);
}

static void test_damaged_files_never_crash(void **state)
{
    (void)state;
    char path[PATH_SIZE];
    test_path(path, "damaged.exr");
    struct aob_image image = sample_image(29, 37);
    assert_true(aob_image_write(&image, path, NULL));
    aob_image_finish(&image);
    size_t size;
    char *bytes = aob_file_read(path, 1 << 24, &size, NULL);
    for (size_t cut = 0; cut < size; cut += cut < 700 ? 7 : 301)
        read_damaged(path, bytes, cut);
    uint32_t seed = 1;
    for (int i = 0; i < 1500; i++) {
        /* Two of three in the header, where the numbers are that decide about memory. */
        size_t at = (random_next(&seed) >> 8) % (i % 3 ? 900 : size), bit = (random_next(&seed) >> 8) % 8;
        bytes[at] = (char)(bytes[at] ^ (1 << bit));
        read_damaged(path, bytes, size);
        bytes[at] = (char)(bytes[at] ^ (1 << bit));
    }
    free(bytes);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_files_that_are_no_image),
        cmocka_unit_test(test_damaged_files_never_crash),
        cmocka_unit_test(test_one_changed_bit_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
