/* aobudget/points.h: point sets for the tables that a technique's fill() writes. All are deterministic; a set of
 * `count` points is the same on every machine. */
#ifndef AOBUDGET_POINTS_H
#define AOBUDGET_POINTS_H
#include <math.h>
#include <stdint.h>

/* Element i of the van der Corput sequence in a base: its digits mirrored at the point (Niederreiter 1992, 3.1). */
static inline float aob_point_inverse(uint32_t i, uint32_t base)
{
    double value = 0, digit = 1.0 / base;
    for (; i; i /= base, digit /= base)
        value += digit * (i % base);
    return (float)value;
}

/* Point i of `count` in the unit square (Hammersley set): the first coordinate even, the second base 2. */
static inline void aob_point_square(uint32_t i, uint32_t count, float point[2])
{
    point[0] = ((float)i + 0.5f) / (float)count;
    point[1] = aob_point_inverse(i, 2);
}

/* Point i of `count` in the unit cube: even, base 2, base 3. */
static inline void aob_point_cube(uint32_t i, uint32_t count, float point[3])
{
    aob_point_square(i, count, point);
    point[2] = aob_point_inverse(i, 3);
}

/* A unit vector from two numbers in [0, 1), uniform over the sphere (Archimedes). */
static inline void aob_point_on_sphere(float u, float v, float direction[3])
{
    float z = 1 - 2 * u, r = sqrtf(fmaxf(0, 1 - z * z)), a = 6.28318531f * v;
    direction[0] = r * cosf(a);
    direction[1] = r * sinf(a);
    direction[2] = z;
}
#endif
