#include "lines.h"
#include <endian.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/file.h"
#include "base/memory.h"
#include "room.h"
#include "stack.h"
#include "tags.h"

/* Bytes of memory for each number: the line and its name; while they are named, two that are sorted; later its set. */
enum { SORTING = 24, USING = 12, DIGITS = 256 };

struct stream {
    uint32_t *lines, *names; /* names: 0, 1, 2 ... in place of the lines, so that tables of them are small */
    size_t count;
    uint32_t distinct;
};

static void finish_stream(struct stream *stream)
{
    free(stream->lines);
    free(stream->names);
}

static bool read_stream(const char *path, struct stream *stream, struct aob_error *error)
{
    size_t size;
    *stream = (struct stream){0};
    char *bytes = aob_file_read(path, (size_t)(aob_room_size() / SORTING * sizeof(uint32_t)), &size, error);
    if (!bytes)
        return false;
    stream->count = size / sizeof(uint32_t);
    stream->lines = (uint32_t *)(void *)bytes;
    if (size % sizeof(uint32_t)) {
        finish_stream(stream);
        return aob_fail(error, "%s: %zu bytes are no whole number of 32-bit line numbers", path, size);
    }
    if (stream->count > UINT32_MAX) {
        finish_stream(stream);
        return aob_fail(error, "%s: a stream has at most %u line numbers, and these are %zu", path,
                        UINT32_MAX, size / sizeof(uint32_t));
    }
    for (size_t i = 0; i < stream->count; i++)
        stream->lines[i] = le32toh(stream->lines[i]);
    return true;
}

/* Sorts by one byte of the upper half, and keeps the order of equals. */
static void sort_by(uint64_t *restrict to, const uint64_t *restrict from, size_t count, int shift)
{
    size_t first[DIGITS + 1] = {0};
    for (size_t i = 0; i < count; i++)
        first[(from[i] >> shift & (DIGITS - 1)) + 1]++;
    for (int d = 0; d < DIGITS; d++)
        first[d + 1] += first[d];
    for (size_t i = 0; i < count; i++)
        to[first[from[i] >> shift & (DIGITS - 1)]++] = from[i];
}

/* Equal lines lie together when they are sorted with their places. */
static void name_lines(struct stream *stream)
{
    uint64_t *sorted = AOB_NEW_ARRAY(uint64_t, stream->count + 1);
    uint64_t *other = AOB_NEW_ARRAY(uint64_t, stream->count + 1);
    for (size_t i = 0; i < stream->count; i++)
        sorted[i] = (uint64_t)stream->lines[i] << 32 | i;
    for (int shift = 32; shift < 64; shift += 16) {
        sort_by(other, sorted, stream->count, shift);
        sort_by(sorted, other, stream->count, shift + 8);
    }
    stream->names = AOB_NEW_ARRAY(uint32_t, stream->count + 1);
    for (size_t i = 0; i < stream->count; i++) {
        stream->distinct += i == 0 || sorted[i] >> 32 != sorted[i - 1] >> 32;
        stream->names[(uint32_t)sorted[i]] = stream->distinct - 1;
    }
    free(sorted);
    free(other);
}

/* More ways than there are lines change nothing: no set is ever full. */
static struct aob_tags_desc cache_of(const struct aob_lines_desc *desc, const struct stream *stream)
{
    uint32_t most = stream->distinct ? stream->distinct : 1;
    return (struct aob_tags_desc){.sets = desc->sets,
                                  .ways = desc->ways < most ? desc->ways : most,
                                  .index = desc->index,
                                  .numbers = stream->distinct + 1};
}

static void count_misses(const struct aob_lines_desc *desc, const struct stream *stream,
                         struct aob_misses *misses)
{
    struct aob_tags_desc cache = cache_of(desc, stream);
    struct aob_tags *tags = aob_tags_create(&cache);
    uint32_t *sets = AOB_NEW_ARRAY(uint32_t, stream->count + 1);
    aob_index_sets(&cache, stream->lines, stream->count, sets);
    misses->misses = aob_tags_access_in(tags, stream->names, sets, stream->count, NULL);
    free(sets);
    aob_tags_destroy(tags);
    uint32_t size = cache.sets * cache.ways;
    struct aob_stack *stack = aob_stack_create(&(struct aob_stack_desc){stream->distinct, 1, &size, 1});
    aob_stack_access(stack, stream->names, stream->count);
    uint64_t associative = aob_stack_misses(stack, 0);
    aob_stack_destroy(stack);
    misses->accesses = stream->count;
    misses->compulsory = stream->distinct;
    misses->capacity = (int64_t)(associative - stream->distinct);
    misses->conflict = (int64_t)(misses->misses - associative);
}

static bool judge_cache(const struct aob_lines_desc *desc, const struct stream *stream,
                        struct aob_error *error)
{
    struct aob_tags_desc cache = cache_of(desc, stream);
    struct aob_room room = {0};
    char who[128];
    if (desc->index == AOB_INDEX_XOR && (desc->sets & (desc->sets - 1)))
        return aob_fail(error, "the index xor needs a power of two of sets, and %u is none", desc->sets);
    if ((double)cache.sets * cache.ways > INT32_MAX)
        return aob_fail(
            error, "a cache of %u sets and %u ways is larger than this machine can hold: lower one of them",
            desc->sets, desc->ways);
    snprintf(who, sizeof who, "a cache of %u sets and %u ways with a stream of %zu numbers", desc->sets,
             desc->ways, stream->count);
    double bytes =
        (double)USING * (double)stream->count + aob_tags_bytes(&cache) + aob_stack_bytes(stream->distinct, 1);
    return aob_room_take(&room, bytes, who, "lower one of them", error);
}

bool aob_lines_simulate(const struct aob_lines_desc *desc, struct aob_misses *misses, struct aob_error *error)
{
    struct stream stream;
    *misses = (struct aob_misses){0};
    if (!read_stream(desc->path, &stream, error))
        return false;
    name_lines(&stream);
    bool ok = judge_cache(desc, &stream, error);
    if (ok)
        count_misses(desc, &stream, misses);
    finish_stream(&stream);
    return ok;
}
