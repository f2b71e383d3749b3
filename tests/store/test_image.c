#include "store/image.h"
#include "base/file.h"
#include "base/memory.h"
#include <OpenEXR/openexr.h>
#include <fcntl.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include <cmocka.h>
#include "random.h"

enum { PATH_SIZE = 256 };

static void test_path(char path[PATH_SIZE], const char *name)
{
    const char *folder = getenv("TMPDIR");
    snprintf(path, PATH_SIZE, "%s/aob-test-image-%ld-%s", folder ? folder : "/tmp", (long)getpid(), name);
}

/* Smooth waves with noise, and the values that a careless path would change. */
static void fill(float *pixels, size_t count, uint32_t seed)
{
    static const uint32_t special[] = {0x7f800000u, 0xff800000u, 0x7fc12345u, 0x80000000u, 1u, 0x7f7fffffu};
    for (size_t i = 0; i < count; i++)
        pixels[i] = sinf(0.01f * (float)i) + (float)(random_next(&seed) >> 8 & 255) / 4096.0f;
    for (size_t i = 0; i < AOB_COUNT(special) && i < count; i++)
        memcpy(&pixels[count - 1 - i], &special[i], sizeof special[i]);
}

static struct aob_image sample_image(int width, int height)
{
    static const char *const names[] = {"technique.AO", "Z", "N.X",
                                        "a.channel.with.a.name.over.31.characters"};
    struct aob_image image = {.width = width, .height = height};
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        fill(aob_image_add(&image, names[i]), (size_t)width * (size_t)height, (uint32_t)i);
    aob_image_set_number(&image, "aobudget.fov_deg", 60.25);
    aob_image_set_vec3(&image, "aobudget.eye", (double[3]){0.1, -2, 4e-7});
    aob_image_set_text(&image, "aobudget.technique", "gtao \"x\" \xc3\xbc");
    return image;
}

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

static const struct aob_attribute *find_attribute(const struct aob_image *image, const char *name)
{
    for (size_t i = 0; i < image->attribute_count; i++)
        if (strcmp(image->attributes[i].name, name) == 0)
            return &image->attributes[i];
    return NULL;
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

static bool choose_all(void *user, const char *const *names, size_t count, bool *wanted,
                       struct aob_error *error)
{
    (void)user;
    (void)names;
    (void)error;
    memset(wanted, true, count * sizeof *wanted);
    return true;
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

/* 0, 1/8, 2/8 .. 31/8 as half: exact, so that a test can compare. */
static uint16_t half_of_eighths(int eighths)
{
    if (eighths == 0)
        return 0;
    int exponent = 15 - 3, mantissa = eighths << 10;
    while (mantissa >= 2048) {
        mantissa >>= 1;
        exponent++;
    }
    return (uint16_t)((exponent << 10) | (mantissa & 1023));
}

struct foreign {
    int width, height, tile; /* tile 0: scan lines */
    exr_compression_t compression;
    uint16_t *half;
    uint32_t *whole;
};

static void encode(exr_context_t file, const struct foreign *f, const exr_chunk_info_t *chunk, int x, int y)
{
    exr_encode_pipeline_t pipeline = {0};
    assert_int_equal(exr_encoding_initialize(file, 0, chunk, &pipeline), 0);
    size_t at = (size_t)y * (size_t)f->width + (size_t)x;
    for (int c = 0; c < pipeline.channel_count; c++) {
        exr_coding_channel_info_t *channel = &pipeline.channels[c];
        bool half = channel->data_type == EXR_PIXEL_HALF;
        channel->encode_from_ptr = half ? (const uint8_t *)(f->half + at) : (const uint8_t *)(f->whole + at);
        channel->user_bytes_per_element = half ? 2 : 4;
        channel->user_pixel_stride = half ? 2 : 4;
        channel->user_line_stride = f->width * (half ? 2 : 4);
        channel->user_data_type = channel->data_type;
    }
    assert_int_equal(exr_encoding_choose_default_routines(file, 0, &pipeline), 0);
    assert_int_equal(exr_encoding_run(file, 0, &pipeline), 0);
    exr_encoding_destroy(file, &pipeline);
}

static void write_blocks(exr_context_t file, const struct foreign *f)
{
    exr_chunk_info_t chunk;
    if (f->tile == 0) {
        int32_t lines;
        assert_int_equal(exr_get_scanlines_per_chunk(file, 0, &lines), 0);
        for (int y = 0; y < f->height; y += lines) {
            assert_int_equal(exr_write_scanline_chunk_info(file, 0, y - 7, &chunk), 0);
            encode(file, f, &chunk, 0, y);
        }
        return;
    }
    for (int y = 0; y < f->height; y += f->tile)
        for (int x = 0; x < f->width; x += f->tile) {
            assert_int_equal(exr_write_tile_chunk_info(file, 0, x / f->tile, y / f->tile, 0, 0, &chunk), 0);
            encode(file, f, &chunk, x, y);
        }
}

/* A file as another program may write it: half and whole numbers, a corner that is not 0, 0, floats as
 * attributes. */
static void write_foreign(const char *path, const struct foreign *f)
{
    exr_context_t file = NULL;
    int part;
    exr_attr_box2i_t window = {.min = {.x = 5, .y = -7}, .max = {.x = 4 + f->width, .y = f->height - 8}};
    exr_attr_v2f_t centre = {.x = 0, .y = 0};
    exr_attr_v3f_t eye = {.x = 1, .y = 2, .z = 0.5f};
    assert_int_equal(exr_start_write(&file, path, EXR_WRITE_FILE_DIRECTLY, NULL), 0);
    assert_int_equal(exr_add_part(file, "p", f->tile ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE, &part), 0);
    assert_int_equal(exr_initialize_required_attr(file, part, &window, &window, 1, &centre, 1,
                                                  EXR_LINEORDER_INCREASING_Y, f->compression),
                     0);
    if (f->tile)
        assert_int_equal(exr_set_tile_descriptor(file, part, (uint32_t)f->tile, (uint32_t)f->tile,
                                                 EXR_TILE_ONE_LEVEL, EXR_TILE_ROUND_DOWN),
                         0);
    assert_int_equal(exr_add_channel(file, part, "Z", EXR_PIXEL_HALF, EXR_PERCEPTUALLY_LINEAR, 1, 1), 0);
    assert_int_equal(exr_add_channel(file, part, "id", EXR_PIXEL_UINT, EXR_PERCEPTUALLY_LINEAR, 1, 1), 0);
    assert_int_equal(exr_attr_set_float(file, part, "fov", 0.5f), 0);
    assert_int_equal(exr_attr_set_int(file, part, "frame", -3), 0);
    assert_int_equal(exr_attr_set_v3f(file, part, "eye", &eye), 0);
    assert_int_equal(exr_write_header(file), 0);
    write_blocks(file, f);
    assert_int_equal(exr_finish(&file), 0);
}

static void check_foreign(const struct foreign *f, const char *path)
{
    struct aob_image image;
    struct aob_error error = {0};
    write_foreign(path, f);
    if (!aob_image_read_layers(&image, path, choose_all, NULL, &error))
        fail_msg("%s", error.text);
    assert_int_equal(image.width, f->width);
    const float *z = aob_image_channel(&image, "Z"), *id = aob_image_channel(&image, "id");
    for (int i = 0; i < f->width * f->height; i++) {
        assert_true(z[i] == (float)(i % 32) / 8);
        assert_true(id[i] == (float)(i * 3));
    }
    const struct aob_attribute *a = find_attribute(&image, "eye");
    assert_true(a && a->count == 3 && a->values[2] == 0.5);
    a = find_attribute(&image, "frame");
    assert_true(a && a->count == 1 && a->values[0] == -3);
    a = find_attribute(&image, "fov");
    assert_true(a && a->count == 1 && a->values[0] == 0.5);
    aob_image_finish(&image);
}

static void test_half_and_tiled_files_of_others(void **state)
{
    (void)state;
    static const exr_compression_t methods[] = {EXR_COMPRESSION_NONE, EXR_COMPRESSION_ZIP,
                                                EXR_COMPRESSION_ZIPS, EXR_COMPRESSION_PIZ};
    static const int tiles[] = {0, 16, 32};
    char path[PATH_SIZE];
    test_path(path, "foreign.exr");
    struct foreign f = {.width = 53, .height = 41};
    f.half = AOB_NEW_ARRAY(uint16_t, 53 * 41);
    f.whole = AOB_NEW_ARRAY(uint32_t, 53 * 41);
    for (int i = 0; i < 53 * 41; i++) {
        f.half[i] = half_of_eighths(i % 32);
        f.whole[i] = (uint32_t)i * 3;
    }
    for (size_t m = 0; m < AOB_COUNT(methods); m++)
        for (size_t t = 0; t < AOB_COUNT(tiles); t++) {
            f.compression = methods[m];
            f.tile = tiles[t];
            check_foreign(&f, path);
        }
    free(f.half);
    free(f.whole);
    unlink(path);
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
        cmocka_unit_test(test_files_that_are_no_image),
        cmocka_unit_test(test_damaged_files_never_crash),
        cmocka_unit_test(test_one_changed_bit_is_refused),
        cmocka_unit_test(test_half_and_tiled_files_of_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
