/* Twenty pairs of images of visibility, for metrics that are checked by a second implementation: pixels, ramps, waves
 * and noise, a third of the pairs with a sky that holds rubbish. */
#ifndef AOB_TESTS_SCORE_PAIRS_H
#define AOB_TESTS_SCORE_PAIRS_H
#include <math.h>
#include "random.h"
#include "score/score.h"

enum { PAIR_COUNT = 20, PAIR_WIDTH = 37, PAIR_HEIGHT = 29, PAIR_SIZE = PAIR_WIDTH * PAIR_HEIGHT };
struct pair {
    float image[PAIR_SIZE], truth[PAIR_SIZE], depth[PAIR_SIZE];
    struct aob_score_desc desc;
};

static inline float pair_clamp(double value)
{
    return (float)fmin(fmax(value, 0), 1);
}

/* One of four textures, of which `seed` chooses scale and direction. */
static inline double pair_texture(int kind, double seed, double noise, int x, int y)
{
    double along = x * cos(6 * seed) + y * sin(6 * seed);
    switch (kind) {
    case 0:
        return 0.5 + 0.4 * sin(along * (0.1 + seed));
    case 1:
        return along > 10 * seed ? 0.9 : 0.15;
    case 2:
        return fmin(fabs(along) / 30, 1);
    default:
        return noise;
    }
}

static inline void pair_make(struct pair *pair, int index)
{
    uint32_t state = 77u + (uint32_t)index;
    double seed = random_unit(&state), amount = 0.02 + 0.9 * random_unit(&state),
           offset = random_unit(&state) - 0.5;
    for (int y = 0; y < PAIR_HEIGHT; y++)
        for (int x = 0; x < PAIR_WIDTH; x++) {
            int i = y * PAIR_WIDTH + x, sky = index % 3 == 0 && y < 9 + x / 6;
            double truth = pair_texture(index % 4, seed, random_unit(&state), x, y);
            double other = index % 5 ? truth + amount * (random_unit(&state) - 0.5) + 0.3 * offset
                                     : pair_texture((index + 1) % 4, seed, random_unit(&state), x, y);
            pair->truth[i] = sky ? 3 : pair_clamp(truth);
            pair->image[i] = sky ? NAN : pair_clamp(other);
            pair->depth[i] = sky ? 1e9f : 2;
        }
    pair->desc = (struct aob_score_desc){.width = PAIR_WIDTH,
                                         .height = PAIR_HEIGHT,
                                         .image = pair->image,
                                         .truth = pair->truth,
                                         .depth = pair->depth,
                                         .sky_depth = 5e8f};
}

static inline void pair_fill(struct pair *pair, float image, float truth)
{
    pair_make(pair, 1);
    for (int i = 0; i < PAIR_SIZE; i++) {
        pair->image[i] = image;
        pair->truth[i] = truth;
    }
}

/* What a metric sees of an image: beyond the edges the nearest pixel, in the sky 1. */
static inline double pair_pixel(const struct pair *pair, const float *pixels, int x, int y)
{
    x = x < 0 ? 0 : x >= PAIR_WIDTH ? PAIR_WIDTH - 1 : x;
    y = y < 0 ? 0 : y >= PAIR_HEIGHT ? PAIR_HEIGHT - 1 : y;
    int i = y * PAIR_WIDTH + x;
    return pair->depth[i] >= pair->desc.sky_depth ? 1 : (double)pixels[i];
}

/* The image becomes the truth with noise of that amplitude. */
static inline void pair_add_noise(struct pair *pair, double amplitude)
{
    uint32_t state = 5;
    for (int i = 0; i < PAIR_SIZE; i++)
        pair->image[i] = pair_clamp(pair->truth[i] + amplitude * (random_unit(&state) - 0.5));
}

/* The image becomes the truth, averaged over squares of 2 radius + 1 pixels. */
static inline void pair_blur(struct pair *pair, int radius)
{
    for (int y = 0; y < PAIR_HEIGHT; y++)
        for (int x = 0; x < PAIR_WIDTH; x++) {
            double sum = 0;
            for (int v = -radius; v <= radius; v++)
                for (int u = -radius; u <= radius; u++)
                    sum += pair_pixel(pair, pair->truth, x + u, y + v);
            pair->image[y * PAIR_WIDTH + x] = pair_clamp(sum / ((2 * radius + 1) * (2 * radius + 1)));
        }
}
#endif
