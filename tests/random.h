/* Numbers that look random and are the same in every run and on every machine, to damage files and to make images with.
 * A test owns the state; its first value is the seed. The high bits are the good ones. */
#ifndef AOB_TESTS_RANDOM_H
#define AOB_TESTS_RANDOM_H
#include <stddef.h>
#include <stdint.h>

static inline uint32_t random_next(uint32_t *state)
{
    return *state = *state * 1664525u + 1013904223u;
}

/* 0..n-1. */
static inline size_t random_below(uint32_t *state, size_t n)
{
    return (size_t)(((uint64_t)random_next(state) * n) >> 32);
}

/* 0 <= x < 1, in steps of 2^-24. */
static inline double random_unit(uint32_t *state)
{
    return (random_next(state) >> 8) / 16777216.0;
}

/* About normal, of mean 0 and variance 1: the sum of twelve even values. */
static inline double random_normal(uint32_t *state)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += random_unit(state);
    return sum;
}
#endif
