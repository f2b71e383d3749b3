/* Directions over the hemisphere: Owen-scrambled Sobol points in two dimensions, mapped about a normal.
 * Points: Sobol' 1967, dimensions 1 and 2. Scramble: the hash of Laine and Karras 2011 ("Stratified Sampling
 * for Stochastic Transparency") on bit-reversed numbers, with the multipliers of Burley 2020 ("Practical
 * Hash-based Owen Scrambling", JCGT 9(4)). Each set of `count` points is a prefix of the sequence under a
 * scramble of its own, so two sets with different seeds are independent, unbiased estimates. Order: sixteen
 * neighbours in the arrays lie in one cell of azimuth x height (a scramble keeps such cells together),
 * because rays close in direction are traced faster. Thread-safe once created. */
#ifndef AOB_REFERENCE_SAMPLER_H
#define AOB_REFERENCE_SAMPLER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { AOB_PACKET = 16 }; /* arrays of directions are padded to a multiple of it */

struct aob_sampler {
    size_t count, padded;       /* points, and the length of the arrays */
    bool mixture;               /* density (cosine + 1/2) / (2 pi) instead of cosine / pi */
    uint32_t *azimuth, *height; /* padded: the unscrambled coordinates, bits reversed, in tracing order */
};

/* A `mixture` is half cosine and half uniform over the hemisphere. It serves both weightings with weights of at most
 * 2. */
void aob_sampler_init(struct aob_sampler *sampler, size_t count, bool mixture);
void aob_sampler_finish(struct aob_sampler *sampler);

/* Two orthonormal tangents and the normal, which stay put for a given normal. */
struct aob_basis {
    float tangent[3], bitangent[3], normal[3];
};

/* One set; each array has `padded` elements. The cosine with the normal is at least 2^-12, far above
 * rounding, so that no direction lies below its own surface. */
struct aob_directions {
    float *x, *y, *z, *cosine;
};
void aob_sampler_directions(const struct aob_sampler *sampler, const struct aob_basis *basis, uint64_t seed,
                            const struct aob_directions *directions);

/* The scrambled points themselves, each number within (0, 1), for what maps them in its own way. Both arrays have
 * `padded` elements. */
void aob_sampler_points(const struct aob_sampler *sampler, uint64_t seed, float *u, float *v);

/* One cosine-distributed direction about the basis's normal, of a seed of its own. The cosine is at least 2^-12 too. */
void aob_sampler_direction(const struct aob_basis *basis, uint64_t seed, float direction[3]);

/* A well-mixed 64-bit number from two (SplitMix64's finaliser, Steele et al. 2014). */
uint64_t aob_sampler_mix(uint64_t a, uint64_t b);
#endif
