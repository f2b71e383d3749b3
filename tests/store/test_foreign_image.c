/* Images that other programs have written. */
#include "image_sample.h"
#include <OpenEXR/openexr.h>

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

/* One pixel of fourteen channels, within a display window of 16384 x 2441. */
static void write_wide(const char *path)
{
    static const char *const names[] = {"A", "B", "C", "D", "E", "F", "G", "H", "I", "J", "K", "L", "M", "N"};
    exr_context_t file = NULL;
    exr_chunk_info_t chunk;
    int part;
    uint16_t half = 0x3c00;
    struct foreign f = {.width = 1, .height = 1, .half = &half};
    exr_attr_box2i_t pixel = {.min = {.x = 0, .y = 0}}, display = {.max = {.x = 16383, .y = 2440}};
    exr_attr_v2f_t centre = {.x = 0, .y = 0};
    assert_int_equal(exr_start_write(&file, path, EXR_WRITE_FILE_DIRECTLY, NULL), 0);
    assert_int_equal(exr_add_part(file, "p", EXR_STORAGE_SCANLINE, &part), 0);
    assert_int_equal(exr_initialize_required_attr(file, part, &display, &pixel, 1, &centre, 1,
                                                  EXR_LINEORDER_INCREASING_Y, EXR_COMPRESSION_NONE),
                     0);
    for (size_t i = 0; i < AOB_COUNT(names); i++)
        assert_int_equal(exr_add_channel(file, part, names[i], EXR_PIXEL_HALF, EXR_PERCEPTUALLY_LINEAR, 1, 1),
                         0);
    assert_int_equal(exr_write_header(file), 0);
    assert_int_equal(exr_write_scanline_chunk_info(file, 0, 0, &chunk), 0);
    encode(file, &f, &chunk, 0, 0);
    assert_int_equal(exr_finish(&file), 0);
}

static bool choose_last(void *user, const char *const *names, size_t count, bool *wanted,
                        struct aob_error *error)
{
    (void)user;
    (void)names;
    (void)error;
    wanted[count - 1] = true;
    return true;
}

/* What the image takes is the display window's, however few pixels the file has: 14 x 39993344 is more than 2^29. */
static void test_a_display_window_counts(void **state)
{
    (void)state;
    char path[PATH_SIZE];
    struct aob_image image;
    struct aob_error error = {0};
    test_path(path, "wide.exr");
    write_wide(path);
    assert_false(aob_image_read_layers(&image, path, choose_all, NULL, &error));
    assert_contains(error.text, "refused: 14 channels of 39993344 pixels");
    assert_true(aob_image_read_layers(&image, path, choose_last, NULL, &error));
    assert_true(image.width == 16384 && image.height == 2441 && image.channel_count == 1);
    const float *pixels = aob_image_channel(&image, "N");
    assert_true(pixels[0] == 1 && isnan(pixels[1]));
    aob_image_finish(&image);
    unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_half_and_tiled_files_of_others),
        cmocka_unit_test(test_a_display_window_counts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
