#include "sampler.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"

static uint32_t reversed(uint32_t x)
{
    x = __builtin_bswap32(x);
    x = (x >> 4 & 0x0f0f0f0f) | (x & 0x0f0f0f0f) << 4;
    x = (x >> 2 & 0x33333333) | (x & 0x33333333) << 2;
    return (x >> 1 & 0x55555555) | (x & 0x55555555) << 1;
}

/* Sobol's second dimension: direction numbers v, v ^ v/2, ... */
static uint32_t sobol_second(uint32_t index)
{
    uint32_t x = 0;
    for (uint32_t v = 1u << 31; index; index >>= 1, v ^= v >> 1)
        if (index & 1)
            x ^= v;
    return x;
}

/* Spreads the upper 16 bits of x over the even places of a 32-bit number. */
static uint32_t spread(uint32_t x)
{
    x >>= 16;
    x = (x | x << 8) & 0x00ff00ff;
    x = (x | x << 4) & 0x0f0f0f0f;
    x = (x | x << 2) & 0x33333333;
    return (x | x << 1) & 0x55555555;
}

struct point {
    uint32_t cell, azimuth, height;
};

static int by_cell(const void *a, const void *b)
{
    const struct point *p = a, *q = b;
    if (p->cell != q->cell)
        return p->cell < q->cell ? -1 : 1;
    return p->azimuth < q->azimuth ? -1 : p->azimuth > q->azimuth;
}

void aob_sampler_init(struct aob_sampler *sampler, size_t count, bool mixture)
{
    size_t padded = (count + AOB_PACKET - 1) / AOB_PACKET * AOB_PACKET;
    *sampler = (struct aob_sampler){.count = count, .padded = padded, .mixture = mixture};
    struct point *points = aob_alloc(count, sizeof *points);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t azimuth = reversed(i), height = sobol_second(i);
        points[i] = (struct point){spread(azimuth) << 1 | spread(height), azimuth, height};
    }
    qsort(points, count, sizeof *points, by_cell);
    sampler->azimuth = aob_alloc(padded, sizeof *sampler->azimuth);
    sampler->height = aob_alloc(padded, sizeof *sampler->height);
    for (size_t i = 0; i < count; i++) {
        sampler->azimuth[i] = reversed(points[i].azimuth);
        sampler->height[i] = reversed(points[i].height);
    }
    free(points);
}

void aob_sampler_finish(struct aob_sampler *sampler)
{
    free(sampler->azimuth);
    free(sampler->height);
    *sampler = (struct aob_sampler){0};
}

uint64_t aob_sampler_mix(uint64_t a, uint64_t b)
{
    uint64_t x = a * 0x9e3779b97f4a7c15u + b + 0x9e3779b97f4a7c15u;
    x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9u;
    x = (x ^ x >> 27) * 0x94d049bb133111ebu;
    return x ^ x >> 31;
}

/* Owen's scramble of a number whose bits are reversed; the result is the right way round again. */
static inline uint32_t scrambled(uint32_t x, uint32_t seed)
{
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    x = x >> 16 | x << 16;
    x = (x >> 8 & 0x00ff00ff) | (x & 0x00ff00ff) << 8;
    x = (x >> 4 & 0x0f0f0f0f) | (x & 0x0f0f0f0f) << 4;
    x = (x >> 2 & 0x33333333) | (x & 0x33333333) << 2;
    return (x >> 1 & 0x55555555) | (x & 0x55555555) << 1;
}

/* Bits become a float and back through a union, because the vectoriser sees through it, unlike a call. */
union word {
    uint32_t bits;
    float number;
};

/* The bits of positive floats have the order of the numbers. A float comparison would not be vectorised. */
static inline float at_least(float x, float least)
{
    union word a = {.number = x}, b = {.number = least};
    a.bits = (uint32_t)((int32_t)a.bits > (int32_t)b.bits ? (int32_t)a.bits : (int32_t)b.bits);
    return a.number;
}

/* Returns a number in (0, 1), exact in 24 bits. */
static inline float unit_float(uint32_t x)
{
    return ((float)(int)(x >> 9) + 0.5f) * (1 / 8388608.f);
}

struct pair {
    float cosine, sine;
};

/* Cosine and sine of an angle in 2^-32 turns, less an eighth of a turn, which makes no difference to a scrambled
 * azimuth. Taylor's series serves within +-pi/4; then the quadrant is chosen. The error is below 3e-8. */
static inline struct pair turn(uint32_t angle)
{
    uint32_t quadrant = angle >> 30;
    float a = ((float)(int)(angle >> 7 & 0x7fffff) - 4194303.5f) * (float)(M_PI / 16777216);
    float b = a * a;
    union word s = {.number =
                        a * (1 + b * (-1 / 6.f + b * (1 / 120.f + b * (-1 / 5040.f + b * (1 / 362880.f)))))};
    union word c = {.number = 1 + b * (-1 / 2.f + b * (1 / 24.f + b * (-1 / 720.f + b * (1 / 40320.f))))};
    uint32_t exchange = (s.bits ^ c.bits) & -(quadrant & 1);
    c.bits ^= exchange ^ ((quadrant + 1) & 2) << 30;
    s.bits ^= exchange ^ (quadrant & 2) << 30;
    return (struct pair){c.number, s.number};
}

/* The root of 0 < x < 4 to float rounding, by Newton's steps on 1/sqrt(x). sqrtf may set errno and so is never
 * vectorised. */
static inline float root(float x)
{
    union word guess = {.number = x};
    guess.bits = 0x5f3759dfu - (guess.bits >> 1);
    float r = guess.number, half = 0.5f * x;
    r *= 1.5f - half * r * r;
    r *= 1.5f - half * r * r;
    r *= 1.5f - half * r * r;
    return x * r;
}

/* There is no clone with fused multiply-adds, so that the same numbers come out on every machine. */
__attribute__((target_clones("avx2", "default"))) void
aob_sampler_directions(const struct aob_sampler *sampler, const struct aob_basis *basis, uint64_t seed,
                       const struct aob_directions *directions)
{
    const uint32_t *azimuth = sampler->azimuth, *height = sampler->height;
    float *x = directions->x, *y = directions->y, *z = directions->z, *cosine = directions->cosine;
    const struct aob_basis b = *basis;
    const uint32_t seed_azimuth = (uint32_t)seed, seed_height = (uint32_t)(seed >> 32);
    const float k = sampler->mixture ? 1 : 0;
#pragma omp simd
    for (size_t i = 0; i < sampler->padded; i++) {
        struct pair p = turn(scrambled(azimuth[i], seed_azimuth));
        float u = unit_float(scrambled(height[i], seed_height));
        /* c^2 + k c is spread evenly over (0, 1 + k). */
        float c = root(0.25f * k + (1 + k) * u) - 0.5f * k;
        c = at_least(c, 1 / 4096.f);
        float r = root(1 - c * c);
        float across = r * p.cosine, along = r * p.sine;
        x[i] = across * b.tangent[0] + along * b.bitangent[0] + c * b.normal[0];
        y[i] = across * b.tangent[1] + along * b.bitangent[1] + c * b.normal[1];
        z[i] = across * b.tangent[2] + along * b.bitangent[2] + c * b.normal[2];
        cosine[i] = c;
    }
}

__attribute__((target_clones("avx2", "default"))) void aob_sampler_points(const struct aob_sampler *sampler,
                                                                          uint64_t seed, float *u, float *v)
{
    const uint32_t *azimuth = sampler->azimuth, *height = sampler->height;
    const uint32_t seed_u = (uint32_t)seed, seed_v = (uint32_t)(seed >> 32);
#pragma omp simd
    for (size_t i = 0; i < sampler->padded; i++) {
        u[i] = unit_float(scrambled(azimuth[i], seed_u));
        v[i] = unit_float(scrambled(height[i], seed_v));
    }
}

void aob_sampler_direction(const struct aob_basis *basis, uint64_t seed, float direction[3])
{
    struct pair p = turn((uint32_t)seed);
    float c = at_least(root(unit_float((uint32_t)(seed >> 32))), 1 / 4096.f), r = root(1 - c * c);
    for (int k = 0; k < 3; k++)
        direction[k] =
            r * p.cosine * basis->tangent[k] + r * p.sine * basis->bitangent[k] + c * basis->normal[k];
}
