/* The two engines of the miss-ratio curve against one another, against a list, and against closed forms. */
#include "check.h"
#include "profile/reuse.h"
#include "profile/stack.h"
#include "profile/tags.h"
#include "streams.h"

enum { SIZES = AOB_STACK_MAX_SIZE };

static struct aob_stack *stack_of(const struct stream *stream, uint32_t numbers, uint32_t sectors,
                                  const uint32_t *sizes, size_t count)
{
    struct aob_stack *stack = aob_stack_create(&(struct aob_stack_desc){numbers, sectors, sizes, count});
    aob_stack_access(stack, stream->items, stream->count);
    return stack;
}

static struct aob_curve curve_of(const struct stream *stream, uint32_t numbers, uint32_t sectors)
{
    struct aob_reuse *reuse = aob_reuse_create(numbers, sectors);
    struct aob_curve curve;
    aob_reuse_access(reuse, stream->items, stream->count);
    aob_reuse_curve(reuse, &curve);
    aob_reuse_destroy(reuse);
    return curve;
}

/* Both at every size, up to one that holds all. */
static void compare_all(const struct stream *stream, uint32_t numbers, uint32_t sectors)
{
    uint32_t lines = numbers / sectors + 1;
    struct aob_curve curve = curve_of(stream, numbers, sectors);
    for (uint32_t first = 1; first <= lines + 2; first += SIZES) {
        uint32_t sizes[SIZES];
        for (uint32_t i = 0; i < SIZES; i++)
            sizes[i] = first + i;
        struct aob_stack *stack = stack_of(stream, numbers, sectors, sizes, SIZES);
        for (uint32_t i = 0; i < SIZES; i++) {
            uint64_t plain = plain_associative(stream, sizes[i], sectors);
            if (aob_stack_misses(stack, i) != plain || aob_curve_at(&curve, sizes[i]) != plain)
                fail_msg("%u lines, %u sectors: list %zu, stack %zu, every size %zu", sizes[i], sectors,
                         (size_t)plain, (size_t)aob_stack_misses(stack, i),
                         (size_t)aob_curve_at(&curve, sizes[i]));
        }
        aob_stack_destroy(stack);
    }
    aob_curve_finish(&curve);
}

static void test_every_size(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 3; seed++) {
        struct stream stream = stream_random(150 * seed, 3000 * seed, seed);
        compare_all(&stream, 150 * seed, 1);
        free(stream.items);
    }
    struct stream one = stream_cyclic(1, 5);
    compare_all(&one, 1, 1);
    free(one.items);
}

static void test_sectors(void **state)
{
    (void)state;
    for (uint32_t sectors = 2; sectors <= 32; sectors *= 4) {
        struct stream stream = stream_random(400, 3000, sectors);
        compare_all(&stream, 400, sectors);
        free(stream.items);
    }
}

/* Sizes with gaps: a line passes several marks at once. */
static void test_powers(void **state)
{
    (void)state;
    static const uint32_t sizes[] = {1, 2, 4, 8, 16, 17, 32, 64, 100, 128, 256, 512};
    struct stream stream = stream_random(600, 20000, 9);
    struct aob_stack *stack = stack_of(&stream, 600, 1, sizes, AOB_COUNT(sizes));
    for (size_t i = 0; i < AOB_COUNT(sizes); i++)
        assert_int_equal(aob_stack_misses(stack, i), plain_associative(&stream, sizes[i], 1));
    aob_stack_destroy(stack);
    free(stream.items);
}

/* More accesses than the window holds, more lines than half of it: it is moved and grows, and counts the same. */
static void test_window(void **state)
{
    (void)state;
    enum { LINES = 70000, COUNT = 700000 };
    struct stream stream = stream_random(LINES, COUNT, 5);
    struct aob_curve curve = curve_of(&stream, LINES, 1);
    uint64_t before = UINT64_MAX;
    for (uint32_t size = 1; size < 2 * LINES; size = size * 3 / 2 + 1) {
        struct aob_tags *tags = aob_tags_create(
            &(struct aob_tags_desc){.sets = 1, .ways = size, .numbers = LINES, .path = AOB_TAGS_LIST});
        uint64_t misses = aob_tags_access(tags, stream.items, stream.count, NULL);
        assert_int_equal(aob_curve_at(&curve, size), misses);
        assert_true(misses <= before); /* a larger cache of this kind holds all that a smaller one does */
        before = misses;
        aob_tags_destroy(tags);
    }
    uint8_t *seen = AOB_NEW_ARRAY(uint8_t, LINES);
    size_t distinct = 0;
    for (size_t i = 0; i < stream.count; i++) {
        distinct += !seen[stream.items[i]];
        seen[stream.items[i]] = 1;
    }
    assert_int_equal(curve.misses[curve.count - 1], distinct);
    free(seen);
    aob_curve_finish(&curve);
    free(stream.items);
}

static uint64_t misses_at(struct stream stream, uint32_t size)
{
    struct aob_curve curve = curve_of(&stream, 200000, 1);
    uint64_t misses = aob_curve_at(&curve, size);
    struct aob_stack *stack = stack_of(&stream, 200000, 1, &size, 1);
    assert_int_equal(aob_stack_misses(stack, 0), misses);
    aob_stack_destroy(stack);
    aob_curve_finish(&curve);
    free(stream.items);
    return misses;
}

static void test_closed_forms(void **state)
{
    (void)state;
    assert_int_equal(misses_at(stream_cyclic(256, 50), 256), 256);
    assert_int_equal(misses_at(stream_cyclic(257, 50), 256), 12850);
    assert_int_equal(misses_at(stream_sawtooth(300, 10), 256), 300 + 9 * (300 - 256));
    assert_int_equal(misses_at(stream_sawtooth(5000, 4), 1234), 5000 + 3 * (5000 - 1234));
}

/* Evenly random over M lines, a cache of C misses a share of 1 - C / M once it is full. Five standard errors. */
static void test_uniform(void **state)
{
    (void)state;
    enum { M = 1000, COUNT = 400000 };
    struct stream stream = {0};
    uint32_t seed = 7;
    for (size_t i = 0; i < COUNT; i++)
        stream_add(&stream, (uint32_t)random_below(&seed, M));
    struct aob_curve curve = curve_of(&stream, M, 1);
    for (uint32_t size = 100; size < M; size += 100)
        assert_near((double)aob_curve_at(&curve, size) / COUNT, 1 - size / (double)M, 0.0045);
    assert_int_equal(aob_curve_at(&curve, M), M);
    aob_curve_finish(&curve);
    free(stream.items);
}

/* The sum of curves has at each size the sum of both. */
static void test_sum(void **state)
{
    (void)state;
    struct stream a = stream_random(300, 4000, 1), b = stream_random(90, 3000, 2);
    struct aob_curve first = curve_of(&a, 300, 1), second = curve_of(&b, 90, 1), sum = {0};
    aob_curve_add(&sum, &first);
    aob_curve_add(&sum, &second);
    for (uint32_t size = 0; size < 400; size++)
        assert_int_equal(aob_curve_at(&sum, size), aob_curve_at(&first, size) + aob_curve_at(&second, size));
    assert_int_equal(aob_curve_at(&sum, 0), 0);
    aob_curve_finish(&first);
    aob_curve_finish(&second);
    aob_curve_finish(&sum);
    free(a.items);
    free(b.items);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_size),   cmocka_unit_test(test_sectors),
        cmocka_unit_test(test_powers),       cmocka_unit_test(test_window),
        cmocka_unit_test(test_closed_forms), cmocka_unit_test(test_uniform),
        cmocka_unit_test(test_sum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
