/* A stream from a file, of any 32-bit numbers, against lists. */
#include <unistd.h>
#include "base/file.h"
#include "check.h"
#include "limited.h"
#include "profile/lines.h"
#include "streams.h"

static char path[] = "/tmp/aobudget-lines-XXXXXX";

static void write_bytes(const void *bytes, size_t size)
{
    struct aob_error error = {{0}};
    if (!aob_file_write(path, bytes, size, &error))
        fail_msg("%s", error.text);
}

static uint32_t set_of(uint32_t line, uint32_t sets, enum aob_index index)
{
    uint32_t bits = 0;
    while (1u << bits < sets)
        bits++;
    return index == AOB_INDEX_MODULO ? line % sets : (line ^ line >> bits ^ line >> 2 * bits) % sets;
}

/* Numbers from the whole range, whose high bits decide the set; both what the cache and what a list of its size misses. */
static void compare(uint32_t sets, uint32_t ways, enum aob_index index)
{
    struct aob_error error = {{0}};
    struct aob_misses misses;
    struct stream stream = stream_random(300, 8000, sets + ways);
    struct plain_set *plain = AOB_NEW_ARRAY(struct plain_set, sets);
    uint64_t associative = plain_associative(&stream, sets * ways, 1), missed = 0;
    uint64_t distinct = plain_associative(&stream, 512, 1);
    for (size_t i = 0; i < stream.count; i++) {
        uint32_t line = stream.items[i]; /* many agree in their lower half */
        stream.items[i] = UINT32_MAX - (line / 20 << 28 | line % 20 << 17 | line % 4);
        missed += !plain_access(&plain[set_of(stream.items[i], sets, index)], ways, stream.items[i], 0);
    }
    write_bytes(stream.items, stream.count * sizeof *stream.items); /* tests run on little-endian machines */
    if (!aob_lines_simulate(&(struct aob_lines_desc){path, sets, ways, index}, &misses, &error))
        fail_msg("%s", error.text);
    assert_int_equal(misses.accesses, stream.count);
    assert_int_equal(misses.misses, missed);
    assert_int_equal(misses.compulsory, distinct);
    assert_int_equal(misses.capacity, associative - distinct);
    assert_int_equal(misses.conflict, (int64_t)(missed - associative));
    free(plain);
    free(stream.items);
}

static void test_any_numbers(void **state)
{
    (void)state;
    compare(16, 4, AOB_INDEX_XOR);
    compare(16, 4, AOB_INDEX_MODULO);
    compare(7, 3, AOB_INDEX_MODULO);
    compare(1, 40, AOB_INDEX_MODULO);
    compare(4, 20, AOB_INDEX_XOR);
    compare(1, 1, AOB_INDEX_XOR);
}

static void test_refused(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_misses misses;
    struct aob_lines_desc desc = {path, 64, 4, AOB_INDEX_XOR};
    write_bytes("1234567", 7);
    assert_false(aob_lines_simulate(&desc, &misses, &error));
    assert_contains(error.text, "7 bytes are no whole number");
    write_bytes("12345678", 8);
    desc.sets = 48;
    assert_false(aob_lines_simulate(&desc, &misses, &error));
    assert_contains(error.text, "xor needs a power of two");
    desc = (struct aob_lines_desc){path, INT32_MAX, 2, AOB_INDEX_MODULO};
    assert_false(aob_lines_simulate(&desc, &misses, &error));
    assert_contains(error.text, "larger than this machine can hold");
    desc.path = "/nowhere/lines";
    assert_false(aob_lines_simulate(&desc, &misses, &error));
    assert_contains(error.text, "/nowhere/lines: cannot open");
}

/* A stream of `count` numbers with eight lines in a machine whose half of the memory is `mib`. */
static bool fits(size_t count, uint32_t sets, double mib)
{
    struct aob_error error = {{0}};
    struct aob_misses misses;
    uint32_t *numbers = AOB_NEW_ARRAY(uint32_t, count);
    for (size_t i = 0; i < count; i++)
        numbers[i] = (uint32_t)(i % 8);
    write_bytes(numbers, count * sizeof *numbers);
    free(numbers);
    limit_memory((rlim_t)(2 * mib * 0x1p20));
    bool ok = aob_lines_simulate(&(struct aob_lines_desc){path, sets, 4, AOB_INDEX_XOR}, &misses, &error);
    limit_memory(RLIM_INFINITY);
    if (!ok && sets > 1)
        assert_contains(error.text, "with a stream of ");
    return ok;
}

/* Four ways of a set are 16 bytes, a number is 12 when the cache is there and 24 before: together they are at most half of
 * the memory. */
static void test_half_of_the_memory(void **state)
{
    (void)state;
    assert_true(fits(8, 1 << 20, 17));
    assert_false(fits(8, 1 << 20, 15));
    assert_true(fits(1 << 20, 1, 25));
    assert_false(fits(1 << 20, 1, 23));
    assert_true(fits(1 << 20, 1 << 20, 29));
    assert_false(fits(1 << 20, 1 << 20, 27)); /* each of the two would fit */
}

/* No set is ever full. */
static void test_more_ways_than_lines(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_misses misses;
    const uint32_t numbers[] = {7, 900, 7, 4000000000, 900, 7};
    const struct aob_lines_desc descs[] = {{path, 1, INT32_MAX, AOB_INDEX_MODULO},
                                           {path, 4096, INT32_MAX, AOB_INDEX_XOR}};
    write_bytes(numbers, sizeof numbers);
    for (size_t i = 0; i < AOB_COUNT(descs); i++) {
        if (!aob_lines_simulate(&descs[i], &misses, &error))
            fail_msg("%s", error.text);
        assert_int_equal(misses.misses, 3);
        assert_int_equal(misses.compulsory, 3);
        assert_int_equal(misses.capacity, 0);
        assert_int_equal(misses.conflict, 0);
    }
}

static void test_empty(void **state)
{
    (void)state;
    struct aob_error error = {{0}};
    struct aob_misses misses, none = {0};
    write_bytes("", 0);
    assert_true(aob_lines_simulate(&(struct aob_lines_desc){path, 64, 4, AOB_INDEX_XOR}, &misses, &error));
    assert_memory_equal(&misses, &none, sizeof none);
}

static int open_file(void **state)
{
    (void)state;
    int file = mkstemp(path);
    return file < 0 ? -1 : close(file);
}

static int remove_file(void **state)
{
    (void)state;
    return unlink(path);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_any_numbers),
        cmocka_unit_test(test_refused),
        cmocka_unit_test(test_half_of_the_memory),
        cmocka_unit_test(test_more_ways_than_lines),
        cmocka_unit_test(test_empty),
    };
    return cmocka_run_group_tests(tests, open_file, remove_file);
}
