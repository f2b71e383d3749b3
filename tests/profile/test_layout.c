/* Where texels lie, against the same layouts written in another way, and against what is published of them. */
#include "check.h"
#include "gpu/gpu.h"
#include "made.h"
#include "profile/layout.h"
#include "streams.h"

static const int sides[][2] = {{1, 1}, {7, 5}, {64, 64}, {100, 37}, {129, 260}};

/* No two texels share a byte, and all lie within the size. */
static void test_one_place_each(void **state)
{
    (void)state;
    for (int layout = 0; layout < AOB_LAYOUT_COUNT; layout++)
        for (size_t s = 0; s < AOB_COUNT(sides); s++)
            for (int bytes = 1; bytes <= 16; bytes *= 2) {
                struct aob_profile profile = {.layout = (enum aob_layout)layout, .block_height = 16};
                struct aob_placed placed = aob_layout_level(&profile, bytes, sides[s][0], sides[s][1], 1024);
                uint8_t *taken = AOB_NEW_ARRAY(uint8_t, placed.size);
                for (uint32_t y = 0; y < (uint32_t)sides[s][1]; y++)
                    for (uint32_t x = 0; x < (uint32_t)sides[s][0]; x++) {
                        uint64_t at = aob_layout_address(&placed, x, y);
                        assert_true(at >= 1024 && at + (uint64_t)bytes <= 1024 + placed.size);
                        assert_int_equal(at % (uint64_t)bytes, 0);
                        assert_int_equal(taken[at - 1024]++, 0);
                    }
                free(taken);
            }
}

static void test_linear(void **state)
{
    (void)state;
    struct aob_profile profile = {.layout = AOB_LAYOUT_LINEAR};
    struct aob_placed placed = aob_layout_level(&profile, 4, 100, 10, 0);
    assert_int_equal(aob_layout_address(&placed, 3, 2), 2 * 512 + 12); /* 400 bytes become 512 */
    placed = aob_layout_level(&profile, 4, 64, 10, 0);
    assert_int_equal(aob_layout_address(&placed, 63, 9), 9 * 256 + 252);
}

/* The bits of x and y in turn, from a loop. */
static uint64_t interleave(uint32_t x, uint32_t y)
{
    uint64_t code = 0;
    for (int bit = 0; bit < 3; bit++)
        code |= (uint64_t)(x >> bit & 1) << (2 * bit) | (uint64_t)(y >> bit & 1) << (2 * bit + 1);
    return code;
}

static void test_morton(void **state)
{
    (void)state;
    struct aob_profile profile = {.layout = AOB_LAYOUT_MORTON};
    struct aob_placed placed = aob_layout_level(&profile, 4, 100, 37, 0);
    for (uint32_t y = 0; y < 37; y++)
        for (uint32_t x = 0; x < 100; x++) {
            uint64_t tile = y / 8 * 13 + x / 8, at = aob_layout_address(&placed, x, y);
            assert_int_equal(at, (tile * 64 + interleave(x % 8, y % 8)) * 4);
            /* a line of 64 bytes holds 4 x 4 texels of four bytes, one of 128 bytes 8 x 4 */
            assert_int_equal(at / 64, aob_layout_address(&placed, x & ~3u, y & ~3u) / 64);
            assert_int_equal(at / 128, aob_layout_address(&placed, x & ~7u, y & ~3u) / 128);
        }
}

/* The formula of the Tegra X1 Technical Reference Manual, as it is printed there, with divisions. */
static uint64_t printed(uint64_t x, uint64_t y, uint64_t gobs, uint64_t height)
{
    uint64_t gob =
        y / (8 * height) * 512 * height * gobs + x / 64 * 512 * height + y % (8 * height) / 8 * 512;
    return gob + x % 64 / 32 * 256 + y % 8 / 2 * 64 + x % 32 / 16 * 32 + y % 2 * 16 + x % 16;
}

static void test_block_linear(void **state)
{
    (void)state;
    static const struct {
        int height, most, gobs; /* of the plane; of a block as the profile says; of one as it is */
    } rows[] = {{8, 16, 1}, {9, 16, 2}, {64, 16, 8}, {65, 16, 16}, {720, 16, 16}, {720, 4, 4}, {720, 1, 1}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_profile profile = {.layout = AOB_LAYOUT_BLOCK_LINEAR, .block_height = rows[i].most};
        struct aob_placed placed = aob_layout_level(&profile, 4, 100, rows[i].height, 0);
        for (uint32_t y = 0; y < (uint32_t)rows[i].height; y++)
            for (uint32_t x = 0; x < 100; x++) {
                uint64_t at = aob_layout_address(&placed, x, y);
                assert_int_equal(at, printed(4 * x, y, 7, (uint64_t)rows[i].gobs));
                /* a sector of 32 bytes holds 4 x 2 texels */
                assert_int_equal(at / 32, aob_layout_address(&placed, x & ~3u, y & ~1u) / 32);
            }
    }
}

static void test_formats(void **state)
{
    (void)state;
    for (int f = 0; f < AOB_FORMAT_COUNT; f++)
        assert_int_equal(aob_layout_texel_bytes((enum aob_format)f), aob_gpu_texel_size((enum aob_format)f));
}

/* Textures and levels behind one another; the screen's depth and normal as the profile says. */
static void test_frame(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_trace_frame frame = {.texture_count = 0};
    struct aob_placed_frame *placed = AOB_NEW(struct aob_placed_frame);
    struct aob_profile profile = {.layout = AOB_LAYOUT_LINEAR, .depth_bytes = 8, .normal_bytes = 4};
    made_screen(&frame, AOB_TRACE_ROLE_DEPTH, AOB_R32F, 200, 100, 3);
    made_screen(&frame, AOB_TRACE_ROLE_NORMAL, AOB_RGBA32F, 200, 100, 1);
    made_texture(&frame, "depth", AOB_R16F, 5, 3, 2); /* the technique's own */
    assert_true(aob_layout_place(&profile, &frame, placed, &error));
    assert_int_equal(placed->bytes[0], 8);
    assert_int_equal(placed->bytes[1], 4);
    assert_int_equal(placed->bytes[2], 2);
    assert_int_equal(placed->levels[0][0].base, 0);
    assert_int_equal(placed->levels[0][1].base, 100 * 1792);             /* 1600 bytes become 1792 */
    assert_int_equal(placed->levels[0][2].base, 100 * 1792 + 50 * 1024); /* 800 become 1024 */
    assert_int_equal(placed->levels[1][0].base, 262144); /* 100 * 1792 + 50 * 1024 + 25 * 512 = 243200 */
    assert_int_equal(placed->levels[2][0].base, 262144 + 131072);
    assert_int_equal(placed->levels[2][1].base, 262144 + 131072 + 1024); /* three rows of 256, up to 512 */
    frame.textures[2].levels = AOB_LAYOUT_MAX_LEVEL + 1;
    assert_false(aob_layout_place(&profile, &frame, placed, &error));
    assert_contains(error.text, "'depth' has 16 levels");
    free(placed);
}

/* A capture whose planes are not those of its frame is refused. */
static void test_judged(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_trace_frame frame = {.texture_count = 0};
    made_texture(&frame, "depth", AOB_R32F, 200, 101, 3);
    struct aob_trace_pass pass = made_pass(&frame, 10, 10);
    assert_true(aob_layout_judge(&frame, &pass, &error));
    pass.planes[0] = (struct aob_trace_plane){.width = 50, .height = 25, .level = 2};
    assert_true(aob_layout_judge(&frame, &pass, &error));
    pass.planes[0].height = 26;
    assert_false(aob_layout_judge(&frame, &pass, &error));
    assert_contains(error.text, "plane 0");
    pass.planes[0] = (struct aob_trace_plane){.width = 25, .height = 12, .level = 3};
    assert_false(aob_layout_judge(&frame, &pass, &error));
    pass.plane_count = 0;
    pass.write_count = 1;
    pass.writes[0].texture = 1;
    assert_false(aob_layout_judge(&frame, &pass, &error));
    assert_contains(error.text, "target 0");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_place_each), cmocka_unit_test(test_linear),  cmocka_unit_test(test_morton),
        cmocka_unit_test(test_block_linear),   cmocka_unit_test(test_formats), cmocka_unit_test(test_frame),
        cmocka_unit_test(test_judged),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
