/* Captures at the ends of what there is: of one warp, of nothing, of more than a machine can hold. */
#include "check.h"
#include "limited.h"
#include "made.h"

/* An image of one warp: it never finds others to take turns with. All of its misses are on the map. */
static void test_one_warp(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_profile profile = made_profile();
    struct aob_trace_frame frame = {.texture_count = 0};
    uint32_t words[32];
    made_texture(&frame, "own", AOB_RGBA32F, 64, 64, 1);
    struct aob_trace_pass pass = made_pass(&frame, 8, 4);
    for (uint32_t i = 0; i < 32; i++)
        words[i] = 64 * i; /* each in a line of its own */
    struct aob_simulation *simulation = aob_simulation_create(
        &(struct aob_simulation_desc){.profile = &profile, .map = true, .map_flight = AOB_FLIGHT_MOST});
    struct aob_trace_sink sink = aob_simulation_sink(simulation);
    assert_true(made_send(&sink, &frame, &pass, words, 1, &error));
    const struct aob_cache_pass *found = &aob_simulation_result(simulation)->passes[0];
    assert_int_equal(found->levels[0][AOB_FLIGHT_MOST].misses, 32);
    for (int i = 0; i < 32; i++)
        assert_int_equal(found->map[i], 1);
    aob_simulation_destroy(simulation);
}

/* A pass may fetch nothing, in no slot or in unused ones: it has invocations, and writes. */
static void test_no_fetch(void **state)
{
    (void)state;
    uint32_t words[64];
    struct aob_profile profile = made_profile();
    for (size_t i = 0; i < 64; i++)
        words[i] = AOB_TRACE_NONE;
    for (int slots = 0; slots <= 1; slots++) {
        struct aob_error error = {{0}};
        struct aob_trace_frame frame = {.texture_count = 0};
        made_texture(&frame, "own", AOB_R8, 8, 8, 1);
        struct aob_trace_pass pass = made_pass(&frame, 8, 8);
        pass.plane_count = 0;
        pass.write_count = 1;
        struct aob_simulation *simulation = aob_simulation_create(
            &(struct aob_simulation_desc){.profile = &profile, .curve = AOB_CURVE_EVERY, .map = true});
        struct aob_trace_sink sink = aob_simulation_sink(simulation);
        assert_true(made_send(&sink, &frame, &pass, words, slots, &error));
        const struct aob_cache_pass *found = &aob_simulation_result(simulation)->frame;
        assert_int_equal(found->invocations, 64);
        assert_int_equal(found->bytes_written, 64);
        assert_int_equal(found->texels + found->lanes_issued + found->levels[0][AOB_FLIGHT_MOST].accesses, 0);
        aob_simulation_destroy(simulation);
    }
}

/* What no machine can hold is refused before a pass begins, with a line that says what would help. */
static void test_too_large(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_profile profile = made_profile();
    struct aob_trace_frame frame = {.texture_count = 0};
    profile.units = 256;
    profile.levels[0].line = profile.levels[0].sector = 16;
    struct aob_simulation_desc desc = {.profile = &profile, .curve = AOB_CURVE_POWERS};
    made_texture(&frame, "own", AOB_RGBA32F, 16384, 16384, 1);
    for (int textures = 1; textures <= 17; textures += 16) {
        struct aob_trace_pass pass = made_pass(&frame, 8, 8);
        struct aob_simulation *simulation = aob_simulation_create(&desc);
        struct aob_trace_sink sink = aob_simulation_sink(simulation);
        assert_false(sink.begin(sink.self, &frame, &pass, &error));
        assert_contains(error.text, "profile made: ");
        assert_contains(error.text,
                        textures == 1 ? "lower the size, the units" : "more lines than can be numbered");
        aob_simulation_destroy(simulation);
        for (int t = 1; t < 17; t++)
            made_texture(&frame, "more", AOB_RGBA32F, 16384, 16384, 1);
    }
}

/* A pass whose warps wait for their turn: 16 units x 16 warps of 32 lanes x 64 words of up to four numbers in arrays that
 * double are 16 MiB; those of one unit that go down the levels are one more. And caches of a texture of 2^20 lines with a
 * curve: 12 bytes for each line in both orders are 24 MiB. */
enum { WAITING = 1, CACHES = 2, SLOTS = 64 };

static bool fits(int parts, double mib, struct aob_room *room)
{
    static uint32_t words[32 * SLOTS], pixels[32];
    struct aob_error error = {{0}};
    struct aob_profile profile = made_profile();
    struct aob_trace_frame frame = {.texture_count = 0};
    int side = parts & CACHES ? 1024 : 8;
    profile.units = parts & WAITING ? 16 : 1;
    profile.in_flight = parts & WAITING ? 16 : 2;
    if (parts == (CACHES | WAITING)) /* one unit has the caches, and as many warps as sixteen */
        profile.units = 1, profile.in_flight = 128;
    profile.levels[0].line = profile.levels[0].sector = 16;
    profile.levels[0].ways = 16;
    made_texture(&frame, "own", AOB_RGBA32F, side, side, 1);
    struct aob_trace_pass pass = made_pass(&frame, 8, 4);
    pass.fragments = true;                    /* any number of them */
    limit_memory((rlim_t)(2 * mib * 0x1p20)); /* half of it is for simulations */
    struct aob_simulation *simulation = aob_simulation_create(
        &(struct aob_simulation_desc){.profile = &profile, .curve = AOB_CURVE_POWERS, .room = room});
    struct aob_trace_sink sink = aob_simulation_sink(simulation);
    const struct aob_trace_band band = {
        .rows = 4, .count = 32, .pixels = pixels, .slots = SLOTS, .words = words};
    bool ok = sink.begin(sink.self, &frame, &pass, &error) && sink.band(sink.self, &band, &error) &&
              sink.end(sink.self, &error);
    if (!ok)
        assert_contains(error.text, "profile made: its simulation may take ");
    aob_simulation_destroy(simulation);
    limit_memory(RLIM_INFINITY);
    return ok;
}

static void test_half_of_the_memory(void **state)
{
    (void)state;
    assert_true(fits(WAITING, 19, NULL));
    assert_false(fits(WAITING, 16, NULL));
    assert_true(fits(CACHES, 26, NULL));
    assert_false(fits(CACHES, 24, NULL));
    assert_true(
        fits(WAITING | CACHES, 26 + 8 + 10, NULL)); /* half as many wait, and eight times as many go down */
    assert_false(fits(WAITING | CACHES, 26 + 8, NULL));
    struct aob_room room = {0};
    assert_true(fits(CACHES, 40, &room));
    assert_false(fits(CACHES, 40, &room)); /* beside the first */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_one_warp),
        cmocka_unit_test(test_no_fetch),
        cmocka_unit_test(test_too_large),
        cmocka_unit_test(test_half_of_the_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
