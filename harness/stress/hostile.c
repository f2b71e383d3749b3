#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "numbers.h"
#include "sets.h"

/* A depth that is not a number above 0 and below the sky's is no surface (aob_is_sky in technique.h), so its pixel may be
 * anything finite. What it may not do is to reach a surface that no sample of it would reach. */
static const size_t places[] = {20 * 96 + 20, 40 * 96 + 30, 63 * 96 + 0}; /* the wall, the box, the corner */

/* What is looked at: 96 x 64 pixels of the still life, where a radius of .3 covers some 6 of them. */
struct site {
    struct aob_shot shot;
    const float *clean;
    float *depth; /* of the exhibit; what it was is in `kept` */
    float *kept;
    int reach[AOB_COUNT(places)]; /* pixels to either side */
};

static int away(size_t i, size_t j)
{
    int dx = abs((int)(i % 96) - (int)(j % 96)), dy = abs((int)(i / 96) - (int)(j / 96));
    return dx > dy ? dx : dy;
}

/* The farthest pixel that a surface moved to another depth at `place` changes: whoever reads it is as near. */
static int reach_of(struct aob_trial *trial, const struct site *site, size_t place)
{
    static const float shares[] = {0.99f, 0.95f, 0.9f, 0.5f, 1.05f, 1e3f};
    int reach = 0;
    for (size_t k = 0; k < AOB_COUNT(shares); k++) {
        site->depth[place] = shares[k] * site->kept[place];
        const float *image = aob_trial_draw(trial, &site->shot);
        site->depth[place] = site->kept[place];
        for (size_t i = 0; image && i < aob_exhibit_pixels(site->shot.exhibit); i++)
            if (image[i] != site->clean[i] && away(i, place) > reach)
                reach = away(i, place);
    }
    return reach;
}

static bool site_init(struct site *site, struct aob_trial *trial)
{
    struct aob_exhibit *exhibit = aob_set_default(trial);
    *site = (struct site){.shot = {.exhibit = exhibit, .radius = 0.3}};
    site->clean = aob_trial_draw(trial, &site->shot);
    if (!site->clean)
        return false;
    site->depth = exhibit->gbuffer.depth;
    site->kept = aob_trial_image(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        site->kept[i] = site->depth[i];
    for (size_t k = 0; k < AOB_COUNT(places); k++)
        site->reach[k] = reach_of(trial, site, places[k]);
    return true;
}

static void ask_pixel(struct aob_trial *trial, const struct site *site, size_t k, float value)
{
    bool *far = aob_trial_mask(trial, site->shot.exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(site->shot.exhibit); i++)
        far[i] = away(i, places[k]) > site->reach[k];
    site->depth[places[k]] = value;
    const float *image = aob_trial_draw(trial, &site->shot);
    site->depth[places[k]] = site->kept[places[k]];
    if (!image)
        return;
    struct aob_difference d = aob_difference_of(site->shot.exhibit, image, site->clean, far);
    aob_trial_take(trial, d.most, &(struct aob_seen){&site->shot, image, site->clean},
                   "depth %g in pixel (%zu, %zu), of reach %d, at (%zu, %zu)", (double)value, places[k] % 96,
                   places[k] / 96, site->reach[k], d.at % 96, d.at / 96);
}

/* Every second pixel, then all: aob_trial_draw looks at what is left of the surfaces. */
static void ask_many(struct aob_trial *trial, const struct site *site, float value)
{
    for (size_t step = 2; step > 0; step--) {
        for (size_t i = 0; i < aob_exhibit_pixels(site->shot.exhibit); i++)
            if ((i % 96 + i / 96) % step == 0)
                site->depth[i] = value;
        const float *image = aob_trial_draw(trial, &site->shot);
        aob_trial_take(trial, 0, &(struct aob_seen){&site->shot, image, site->clean}, "depth %g in %s",
                       (double)value, step == 2 ? "a checkerboard" : "all pixels");
        for (size_t i = 0; i < aob_exhibit_pixels(site->shot.exhibit); i++)
            site->depth[i] = site->kept[i];
    }
}

static void ask_values(struct aob_trial *trial, const float *values, size_t count)
{
    struct site site;
    if (!site_init(&site, trial))
        return;
    for (size_t v = 0; v < count; v++) {
        for (size_t k = 0; k < AOB_COUNT(places); k++)
            ask_pixel(trial, &site, k, values[v]);
        ask_many(trial, &site, values[v]);
    }
}

void aob_ask_filter_contains_nan(struct aob_trial *trial)
{
    struct site site;
    bool ok = site_init(&site, trial);
    for (size_t k = 0; ok && k < AOB_COUNT(places); k++)
        ask_pixel(trial, &site, k, NAN);
}

void aob_ask_nan_depth(struct aob_trial *trial)
{
    const float values[] = {NAN, -NAN};
    ask_values(trial, values, AOB_COUNT(values));
}

void aob_ask_infinite_depth(struct aob_trial *trial)
{
    const float values[] = {INFINITY, -INFINITY, 3e38f};
    ask_values(trial, values, AOB_COUNT(values));
}

void aob_ask_negative_depth(struct aob_trial *trial)
{
    const float values[] = {-1e-6f, -0.1f, -3, -1e9f, -3e38f};
    ask_values(trial, values, AOB_COUNT(values));
}

void aob_ask_zero_depth(struct aob_trial *trial)
{
    const float values[] = {0, -0.0f};
    ask_values(trial, values, AOB_COUNT(values));
}

void aob_ask_denormal_depth(struct aob_trial *trial)
{
    const float values[] = {1e-45f, 1e-39f, 1e-37f, -1e-39f, 1e-20f, 1e-12f};
    ask_values(trial, values, AOB_COUNT(values));
}
