/* The order of threads, on an image of 16 x 16 that was worked out by hand. A texel has 16 bytes and a line too, and a row
 * of 16 texels is a row of memory: so a number is y * 16 + x. */
#include "check.h"
#include "made.h"
#include "profile/gather.h"
#include "streams.h"

enum { SIDE = 16, MAX_WARP = 16 };

struct seen { /* warps, in their order */
    struct {
        int unit, slots;
        uint32_t start[4], numbers[256], pixels[256];
    } warps[MAX_WARP];
    int count;
};

static void see(void *self, const struct aob_warp *warp)
{
    struct seen *seen = self;
    assert_true(seen->count < MAX_WARP && warp->slots < 4);
    uint32_t count = warp->start[warp->slots];
    seen->warps[seen->count].unit = warp->unit;
    seen->warps[seen->count].slots = warp->slots;
    memcpy(seen->warps[seen->count].start, warp->start, ((size_t)warp->slots + 1) * sizeof *warp->start);
    memcpy(seen->warps[seen->count].numbers, warp->numbers, count * sizeof *warp->numbers);
    memcpy(seen->warps[seen->count].pixels, warp->pixels, count * sizeof *warp->pixels);
    seen->count++;
}

struct rig {
    struct aob_profile profile;
    struct aob_trace_frame frame;
    struct aob_placed_frame placed;
    struct aob_trace_pass pass;
    struct aob_cache_pass counts;
    struct seen seen;
    struct aob_gather *gather;
};

static void open_rig(struct rig *rig, int width, int height)
{
    struct aob_error error = {{0}};
    rig->profile = made_profile();
    rig->profile.levels[0].line = rig->profile.levels[0].sector = 16;
    made_texture(&rig->frame, "own", AOB_RGBA32F, SIDE, SIDE, 1);
    assert_true(aob_layout_place(&rig->profile, &rig->frame, &rig->placed, &error));
    rig->pass = made_pass(&rig->frame, width, height);
}

static void begin(struct rig *rig)
{
    rig->gather = aob_gather_create(&(struct aob_gather_desc){&rig->profile, &rig->placed, &rig->pass,
                                                              &rig->counts, true, &rig->seen, see});
}

static void gather(struct rig *rig, const uint32_t *words, int slots)
{
    struct aob_error error = {{0}};
    struct aob_trace_band band = {.rows = rig->pass.height,
                                  .count = (size_t)(rig->pass.width * rig->pass.height),
                                  .slots = slots,
                                  .words = words};
    begin(rig);
    assert_true(aob_gather_band(rig->gather, &band, &error));
    assert_true(aob_gather_end(rig->gather, &error));
    aob_gather_destroy(rig->gather);
}

/* Two warps a tile, of quads: left to right, then downward. Tiles 0 and 2, the left ones, are unit 0's. */
static void test_quads_and_tiles(void **state)
{
    (void)state;
    static const uint32_t first[32] = {0,  1,  16, 17, 2,  3,  18, 19, 4,  5,  20, 21, 6,  7,  22, 23,
                                       32, 33, 48, 49, 34, 35, 50, 51, 36, 37, 52, 53, 38, 39, 54, 55};
    static const uint32_t begins[8] = {0, 64, 8, 72, 128, 192, 136, 200};
    static const int units[8] = {0, 0, 1, 1, 0, 0, 1, 1};
    struct rig *rig = AOB_NEW(struct rig);
    uint32_t words[SIDE * SIDE];
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        words[i] = i;
    open_rig(rig, SIDE, SIDE);
    gather(rig, words, 1);
    assert_int_equal(rig->seen.count, 8);
    for (int w = 0; w < 8; w++) {
        assert_int_equal(rig->seen.warps[w].unit, units[w]);
        assert_int_equal(rig->seen.warps[w].start[1], 32);
        for (int i = 0; i < 32; i++) {
            assert_int_equal(rig->seen.warps[w].numbers[i], begins[w] + first[i]);
            assert_int_equal(rig->seen.warps[w].pixels[i], begins[w] + first[i]);
        }
    }
    assert_int_equal(rig->counts.lanes_busy, 256);
    assert_int_equal(rig->counts.lanes_issued, 256);
    assert_int_equal(rig->counts.bytes_asked, 256 * 16);
    free(rig);
}

/* llvmpipe's: stamps of 4 x 4 in a tile, each of two vectors of 4 x 2. */
static void test_blocks(void **state)
{
    (void)state;
    static const uint32_t begins[8] = {0, 32, 4, 36, 64, 96, 68, 100},
                          first[8] = {0, 1, 16, 17, 2, 3, 18, 19};
    struct rig *rig = AOB_NEW(struct rig);
    uint32_t words[SIDE * SIDE];
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        words[i] = i % SIDE < 8 && i < 8 * SIDE ? i : AOB_TRACE_NONE;
    open_rig(rig, 8, 8);
    rig->pass.width = 8;
    for (uint32_t i = 0; i < 64; i++)
        words[i] = i / 8 * SIDE + i % 8;
    rig->profile.block = (struct aob_size2){4, 4};
    rig->profile.warp = (struct aob_size2){4, 2};
    gather(rig, words, 1);
    assert_int_equal(rig->seen.count, 8);
    for (int w = 0; w < 8; w++)
        for (int i = 0; i < 8; i++)
            assert_int_equal(rig->seen.warps[w].numbers[i], begins[w] + first[i]);
    free(rig);
}

/* An area of 10 x 5: its second tile has two columns. Lanes outside have no invocation and are idle; warps without any
 * do not run. */
static void test_edges(void **state)
{
    (void)state;
    struct rig *rig = AOB_NEW(struct rig);
    uint32_t words[50];
    for (uint32_t i = 0; i < 50; i++)
        words[i] = i / 10 * SIDE + i % 10;
    open_rig(rig, 10, 5);
    gather(rig, words, 1);
    assert_int_equal(rig->seen.count, 4);
    static const uint32_t counts[4] = {32, 8, 8, 2};
    for (int w = 0; w < 4; w++)
        assert_int_equal(rig->seen.warps[w].start[1], counts[w]);
    assert_int_equal(rig->seen.warps[3].numbers[0], 4 * SIDE + 8);
    assert_int_equal(rig->seen.warps[3].numbers[1], 4 * SIDE + 9);
    assert_int_equal(rig->seen.warps[3].pixels[1], 49);
    assert_int_equal(rig->counts.invocations, 50);
    assert_int_equal(rig->counts.lanes_busy, 50);
    assert_int_equal(rig->counts.lanes_issued, 4 * 32);
    free(rig);
}

/* What an invocation asks for again is counted and goes nowhere; the others stay in their slots. */
static void test_asked_twice(void **state)
{
    (void)state;
    struct rig *rig = AOB_NEW(struct rig);
    uint32_t words[64 * 3];
    for (uint32_t i = 0; i < 64; i++) {
        words[3 * i] = 7;
        words[3 * i + 1] = i == 5 ? 9 : 7;
        words[3 * i + 2] = i < 32 ? 7 : AOB_TRACE_NONE;
    }
    open_rig(rig, 8, 8);
    gather(rig, words, 3);
    assert_int_equal(rig->counts.fetches, 64 * 2 + 32);
    assert_int_equal(rig->counts.distinct, 64 + 1);
    assert_int_equal(rig->counts.texels, 64 + 1);
    assert_int_equal(rig->seen.warps[0].start[1], 32);
    assert_int_equal(rig->seen.warps[0].start[2], 33);
    assert_int_equal(rig->seen.warps[0].start[3], 33);
    assert_int_equal(rig->seen.warps[0].numbers[32], 9);
    assert_int_equal(rig->seen.warps[0].pixels[32], 5);
    assert_int_equal(rig->counts.lanes_busy, 64 * 2 + 32);
    assert_int_equal(rig->counts.lanes_issued, 64 * 2 + 32);
    free(rig);
}

/* Four texels; two at an edge, in a corner one. At the right and the lower edge the footprint ends with the plane, at the
 * others the word says so. */
static void test_bilinear(void **state)
{
    (void)state;
    enum { RIGHT = SIDE - 1, LOW = SIDE * (SIDE - 1), WORDS = 9 };
    static const uint32_t texels[WORDS] = {17,
                                           2 * SIDE + RIGHT,
                                           LOW + 3,
                                           2 * SIDE | AOB_TRACE_ONE_COLUMN,
                                           5 | AOB_TRACE_ONE_ROW,
                                           0 | AOB_TRACE_ONE_COLUMN | AOB_TRACE_ONE_ROW,
                                           RIGHT | AOB_TRACE_ONE_ROW,
                                           LOW | AOB_TRACE_ONE_COLUMN,
                                           LOW + RIGHT};
    static const uint32_t expected[] = {17, 18, 33, 34, 47, 63, 243, 244, 32, 48, 5, 6, 0, 15, 240, 255};
    struct rig *rig = AOB_NEW(struct rig);
    uint32_t words[WORDS];
    for (uint32_t i = 0; i < WORDS; i++)
        words[i] = texels[i] | AOB_TRACE_BILINEAR;
    open_rig(rig, WORDS, 1);
    rig->profile.tile = rig->profile.block = (struct aob_size2){16, 2};
    rig->profile.warp = (struct aob_size2){16, 2};
    gather(rig, words, 1);
    assert_int_equal(rig->counts.fetches, WORDS);
    assert_int_equal(rig->counts.distinct, WORDS);
    assert_int_equal(rig->counts.texels, AOB_COUNT(expected));
    for (size_t i = 0; i < AOB_COUNT(expected); i++)
        assert_int_equal(rig->seen.warps[0].numbers[i], expected[i]);
    free(rig);
}

/* Fragments fill warps in the order in which they come, wherever they lie and however the bands cut them. */
static void test_fragments(void **state)
{
    (void)state;
    enum { COUNT = 70 };
    struct aob_error error = {{0}};
    struct rig *rig = AOB_NEW(struct rig);
    uint32_t words[COUNT], pixels[COUNT], seed = 3;
    for (uint32_t i = 0; i < COUNT; i++) {
        words[i] = i;
        pixels[i] = (uint32_t)random_below(&seed, SIDE) | (uint32_t)random_below(&seed, SIDE) << 16;
    }
    open_rig(rig, SIDE, SIDE);
    rig->pass.fragments = true;
    begin(rig);
    for (size_t at = 0, size = 1; at < COUNT; at += size, size = 23) {
        size = COUNT - at < size ? COUNT - at : size;
        struct aob_trace_band band = {.count = size, .pixels = pixels + at, .slots = 1, .words = words + at};
        assert_true(aob_gather_band(rig->gather, &band, &error));
    }
    assert_true(aob_gather_end(rig->gather, &error));
    aob_gather_destroy(rig->gather);
    assert_int_equal(rig->seen.count, 3);
    for (uint32_t i = 0; i < COUNT; i++) {
        assert_int_equal(rig->seen.warps[i / 32].numbers[i % 32], i);
        assert_int_equal(rig->seen.warps[i / 32].pixels[i % 32],
                         (pixels[i] >> 16) * SIDE + (pixels[i] & 0xffff));
        assert_int_equal(rig->seen.warps[i / 32].unit, i / 32 % 2);
    }
    assert_int_equal(rig->counts.invocations, COUNT);
    assert_int_equal(rig->counts.lanes_issued, 96);
    free(rig);
}

/* A capture that does not hold what it says is refused, not simulated. */
static void test_refused(void **state)
{
    (void)state;
    struct rig *rig = AOB_NEW(struct rig);
    struct aob_error error = {{0}};
    uint32_t word = SIDE * SIDE, pixel = SIDE;
    open_rig(rig, SIDE, SIDE);
    rig->pass.fragments = true;
    begin(rig);
    struct aob_trace_band band = {.count = 1, .pixels = &pixel, .slots = 1, .words = &word};
    assert_false(aob_gather_band(rig->gather, &band, &error));
    assert_contains(error.text, "fragment at (16, 0)");
    pixel = 0;
    assert_true(aob_gather_band(rig->gather, &band, &error));
    assert_false(aob_gather_end(rig->gather, &error));
    assert_contains(error.text, "names texel 256");
    aob_gather_destroy(rig->gather);
    begin(rig);
    word = 5 | AOB_TRACE_ONE_ROW; /* of one texel, so it is no flag */
    assert_true(aob_gather_band(rig->gather, &band, &error));
    assert_false(aob_gather_end(rig->gather, &error));
    assert_contains(error.text, "names texel 536870917");
    aob_gather_destroy(rig->gather);
    free(rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_quads_and_tiles), cmocka_unit_test(test_blocks),
        cmocka_unit_test(test_edges),           cmocka_unit_test(test_asked_twice),
        cmocka_unit_test(test_bilinear),        cmocka_unit_test(test_fragments),
        cmocka_unit_test(test_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
