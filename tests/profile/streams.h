/* Streams of line numbers, and caches written as plainly as possible to compare with. */
#ifndef AOB_TESTS_PROFILE_STREAMS_H
#define AOB_TESTS_PROFILE_STREAMS_H
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "random.h"

struct stream {
    uint32_t *items;
    size_t count, capacity;
};

static inline void stream_add(struct stream *stream, uint32_t number)
{
    *AOB_PUSH(stream->items, stream->count, stream->capacity) = number;
}

/* 0 .. lines - 1 again and again. */
static inline struct stream stream_cyclic(uint32_t lines, int rounds)
{
    struct stream stream = {0};
    for (int r = 0; r < rounds; r++)
        for (uint32_t l = 0; l < lines; l++)
            stream_add(&stream, l);
    return stream;
}

/* Up and down in turn. */
static inline struct stream stream_sawtooth(uint32_t lines, int passes)
{
    struct stream stream = {0};
    for (int p = 0; p < passes; p++)
        for (uint32_t l = 0; l < lines; l++)
            stream_add(&stream, p % 2 ? lines - 1 - l : l);
    return stream;
}

/* Evenly from all lines, but every other time near the one before: both short and long distances come. */
static inline struct stream stream_random(uint32_t lines, size_t count, uint32_t seed)
{
    struct stream stream = {0};
    uint32_t line = 0;
    for (size_t i = 0; i < count; i++) {
        if (random_below(&seed, 2))
            line = (uint32_t)random_below(&seed, lines);
        else
            line = (line + (uint32_t)random_below(&seed, 5)) % lines;
        stream_add(&stream, line);
    }
    return stream;
}

/* One set as an array in the order of use. A number is line * sectors + sector. */
struct plain_set {
    uint32_t lines[512], sectors[512];
    size_t count;
};

static inline bool plain_access(struct plain_set *set, size_t ways, uint32_t line, uint32_t sector)
{
    size_t at = 0;
    while (at < set->count && set->lines[at] != line)
        at++;
    uint32_t here = at < set->count ? set->sectors[at] : 0;
    if (at == set->count)
        set->count += set->count < ways;
    at = at < set->count ? at : set->count - 1;
    memmove(set->lines + 1, set->lines, at * sizeof *set->lines);
    memmove(set->sectors + 1, set->sectors, at * sizeof *set->sectors);
    set->lines[0] = line;
    set->sectors[0] = here | 1u << sector;
    return here >> sector & 1;
}

/* Misses of a fully associative cache of that many lines, at most 512. */
static inline uint64_t plain_associative(const struct stream *stream, size_t lines, uint32_t sectors)
{
    struct plain_set *set = AOB_NEW(struct plain_set);
    uint64_t misses = 0;
    for (size_t i = 0; i < stream->count; i++)
        misses += !plain_access(set, lines, stream->items[i] / sectors, stream->items[i] % sectors);
    free(set);
    return misses;
}
#endif
