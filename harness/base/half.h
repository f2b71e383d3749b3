/* IEEE 754 half floats as their bits. The compiler's _Float16 rounds to the nearest, ties to even. */
#ifndef AOB_BASE_HALF_H
#define AOB_BASE_HALF_H
#include <stdint.h>

#define AOB_HALF_MAX 65504.0f

static inline uint16_t aob_half_from_float(float value)
{
    union {
        _Float16 half;
        uint16_t bits;
    } u = {.half = (_Float16)value};
    return u.bits;
}

static inline float aob_half_to_float(uint16_t bits)
{
    union {
        uint16_t bits;
        _Float16 half;
    } u = {.bits = bits};
    return (float)u.half;
}
#endif
