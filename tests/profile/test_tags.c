/* A set-associative cache, by every path that this machine has, against a list a set, and against closed forms. */
#include "check.h"
#include "profile/tags.h"
#include "streams.h"

static uint32_t log2_of(uint32_t n)
{
    return n > 1 ? 1 + log2_of(n / 2) : 0;
}

static uint32_t plain_index(const struct aob_tags_desc *desc, uint32_t line)
{
    uint64_t wide = line;
    uint32_t b = log2_of(desc->sets);
    return desc->index == AOB_INDEX_MODULO ? line % desc->sets
                                           : (uint32_t)((wide ^ (wide >> b) ^ (wide >> b >> b)) % desc->sets);
}

/* What a path says, access by access, is what a list a set says. */
static void compare(const struct aob_tags_desc *desc, const struct stream *stream)
{
    struct plain_set *sets = AOB_NEW_ARRAY(struct plain_set, desc->sets);
    uint32_t *missed = AOB_NEW_ARRAY(uint32_t, stream->count), sectors = desc->sectors ? desc->sectors : 1;
    struct aob_tags *tags = aob_tags_create(desc);
    size_t count = aob_tags_access(tags, stream->items, stream->count, missed), at = 0;
    for (size_t i = 0; i < stream->count; i++) {
        uint32_t line = stream->items[i] / sectors;
        bool hit = plain_access(&sets[plain_index(desc, line)], desc->ways, line, stream->items[i] % sectors);
        bool says = !(at < count && missed[at] == i);
        at += !says;
        if (hit != says)
            fail_msg("path %d, %u sets, %u ways, index %d: access %zu of line %u", desc->path, desc->sets,
                     desc->ways, desc->index, i, line);
    }
    assert_int_equal(at, count);
    aob_tags_clear(tags);
    assert_int_equal(aob_tags_access(tags, stream->items, stream->count, NULL), count);
    aob_tags_destroy(tags);
    free(missed);
    free(sets);
}

/* Ways that fill a register and ways that do not; sets that are powers of two and others. */
static void test_paths(void **state)
{
    (void)state;
    static const uint32_t ways[] = {1, 2, 3, 4, 5, 7, 8, 9, 12, 15, 16, 17, 24, 96};
    static const uint32_t sets[] = {1, 2, 3, 16, 12, 64};
    struct stream stream = stream_random(3000, 20000, 1);
    int paths = 0;
    for (int path = 0; path < AOB_TAGS_PATH_COUNT; path++)
        for (size_t w = 0; w < AOB_COUNT(ways); w++)
            for (size_t s = 0; s < AOB_COUNT(sets); s++)
                for (int index = 0; index < AOB_INDEX_COUNT; index++) {
                    struct aob_tags_desc desc = {.sets = sets[s],
                                                 .ways = ways[w],
                                                 .index = (enum aob_index)index,
                                                 .numbers = 3000,
                                                 .path = (enum aob_tags_path)path};
                    bool power = (desc.sets & (desc.sets - 1)) == 0;
                    if ((!power && index == AOB_INDEX_XOR) || !aob_tags_can(&desc))
                        continue;
                    compare(&desc, &stream);
                    paths |= 1 << path;
                }
    print_message("paths compared: %#x\n", (unsigned)paths);
    assert_true(paths & 1 << AOB_TAGS_BEST && paths & 1 << AOB_TAGS_PORTABLE && paths & 1 << AOB_TAGS_LIST);
    free(stream.items);
}

/* Each SIMD path that the processor has was compared above: it says yes to the ways that fit. */
static void test_paths_are_offered(void **state)
{
    (void)state;
#if defined(__x86_64__)
    const struct {
        enum aob_tags_path path;
        uint32_t most;
        bool has;
    } rows[] = {{AOB_TAGS_SSE41, 4, __builtin_cpu_supports("sse4.1")},
                {AOB_TAGS_AVX2, 16, __builtin_cpu_supports("avx2")},
                {AOB_TAGS_AVX512, 16, __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("bmi")}};
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_tags_desc desc = {.sets = 4, .ways = rows[i].most, .numbers = 9, .path = rows[i].path};
        assert_int_equal(aob_tags_can(&desc), rows[i].has);
        desc.ways++;
        assert_false(aob_tags_can(&desc));
    }
#endif
}

/* A line has one tag and comes in parts. */
static void test_sectors(void **state)
{
    (void)state;
    struct stream stream = stream_random(4000, 20000, 2);
    for (uint32_t sectors = 2; sectors <= 32; sectors *= 2)
        for (uint32_t ways = 1; ways <= 7; ways += 3)
            for (uint32_t sets = 4; sets <= 16; sets *= 4)
                compare(&(struct aob_tags_desc){.sets = sets,
                                                .ways = ways,
                                                .sectors = sectors,
                                                .index = AOB_INDEX_XOR,
                                                .numbers = 4000},
                        &stream);
    free(stream.items);
}

/* The numbers at the upper end have all their bits: a shift or a sign would show. */
static void test_large_numbers(void **state)
{
    (void)state;
    struct stream stream = stream_random(3000, 20000, 3);
    for (size_t i = 0; i < stream.count; i++)
        stream.items[i] = UINT32_MAX - 1 - stream.items[i] * 1234567;
    for (int path = AOB_TAGS_BEST; path < AOB_TAGS_LIST; path++)
        for (uint32_t sets = 1; sets <= 1u << 20; sets *= 32) {
            struct aob_tags_desc desc = {.sets = sets,
                                         .ways = 4,
                                         .index = AOB_INDEX_XOR,
                                         .numbers = UINT32_MAX,
                                         .path = (enum aob_tags_path)path};
            if (aob_tags_can(&desc) && sets <= 1024)
                compare(&desc, &stream);
            uint32_t place, line = 0xdeadbeef;
            aob_index_sets(&desc, &line, 1, &place);
            assert_int_equal(place, plain_index(&desc, line));
        }
    free(stream.items);
}

/* Calls may be of any length: what was held stays between them. */
static void test_pieces(void **state)
{
    (void)state;
    struct stream stream = stream_random(500, 5000, 4);
    struct aob_tags_desc desc = {.sets = 8, .ways = 6, .numbers = 500};
    struct aob_tags *whole = aob_tags_create(&desc), *parts = aob_tags_create(&desc);
    size_t all = aob_tags_access(whole, stream.items, stream.count, NULL), sum = 0;
    for (size_t at = 0, size = 1; at < stream.count; at += size, size = size % 700 + 13) {
        size_t left = stream.count - at;
        sum += aob_tags_access(parts, stream.items + at, left < size ? left : size, NULL);
    }
    assert_int_equal(sum, all);
    aob_tags_destroy(whole);
    aob_tags_destroy(parts);
    free(stream.items);
}

static size_t misses(struct stream stream, uint32_t sets, uint32_t ways)
{
    struct aob_tags *tags =
        aob_tags_create(&(struct aob_tags_desc){.sets = sets, .ways = ways, .numbers = 200000});
    size_t count = aob_tags_access(tags, stream.items, stream.count, NULL);
    aob_tags_destroy(tags);
    free(stream.items);
    return count;
}

static void test_closed_forms(void **state)
{
    (void)state;
    struct stream touched = {0};
    for (uint32_t i = 0; i < 1600000; i++)
        stream_add(&touched, i / 16);
    assert_int_equal(misses(touched, 64, 4), 100000);
    assert_int_equal(misses(stream_cyclic(256, 50), 64, 4), 256);
    assert_int_equal(misses(stream_cyclic(257, 50), 1, 256), 12850);
    for (uint32_t extra = 0; extra <= 64; extra += 8) /* a set of five lines misses all of them, each round */
        assert_int_equal(misses(stream_cyclic(256 + extra, 50), 64, 4), 256 + extra + 49 * 5 * extra);
    assert_int_equal(misses(stream_sawtooth(300, 10), 1, 256), 300 + 9 * (300 - 256));
    assert_int_equal(misses(stream_sawtooth(200, 10), 1, 256), 200);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_paths),   cmocka_unit_test(test_paths_are_offered),
        cmocka_unit_test(test_sectors), cmocka_unit_test(test_large_numbers),
        cmocka_unit_test(test_pieces),  cmocka_unit_test(test_closed_forms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
