/* Streams of lines whose next one comes from a few registers, so that a program which touches them reads no memory
 * besides. The test and the program under cachegrind share them. */
#ifndef AOB_TESTS_PROFILE_REPLAY_H
#define AOB_TESTS_PROFILE_REPLAY_H
#include <stdint.h>

enum { REPLAY_CYCLIC, REPLAY_RANDOM, REPLAY_NEAR, REPLAY_TILES, REPLAY_SAWTOOTH, REPLAY_COUNT };
enum { REPLAY_ACCESSES = 100000, REPLAY_LINES = 4096 };

/* The line of access i. Cyclic: a few more lines than most caches hold. Random: evenly from 1,000. Near: a step to either
 * side of a place that wanders. Tiles: rows of 8 texels below one another, 5,120 bytes apart, as of a linear image. */
static inline uint32_t replay_line(int kind, uint32_t i)
{
    uint32_t hash = i * 2654435761u;
    hash = (hash ^ hash >> 15) * 2246822519u;
    hash ^= hash >> 13;
    switch (kind) {
    case REPLAY_CYCLIC:
        return i % 300;
    case REPLAY_RANDOM:
        return hash % 1000;
    case REPLAY_NEAR:
        return (i / 64 * 7 + (hash & 127)) % REPLAY_LINES;
    case REPLAY_TILES:
        return (i / 64 * 8 + i % 64 / 8 * 80 + (hash & 1)) % REPLAY_LINES;
    default:
        return i / 400 % 2 ? 399 - i % 400 : i % 400;
    }
}
#endif
