#include <math.h>
#include <stdlib.h>
#include <string.h>
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

/* Draws with another normal in one pixel. */
static const float *draw_turned(struct aob_trial *trial, const struct aob_shot *shot, size_t place,
                                const float *turned)
{
    float *normal = &shot->exhibit->gbuffer.normal[4 * place], kept[3];
    memcpy(kept, normal, sizeof kept);
    memcpy(normal, turned, sizeof kept);
    const float *image = aob_trial_draw(trial, shot);
    memcpy(normal, kept, sizeof kept);
    return image;
}

/* Which pixels are farther from the place than all that any of six other normals changes there. */
static bool *out_of_reach(struct aob_trial *trial, const struct aob_shot *shot, const float *clean,
                          size_t place)
{
    static const float turned[][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    int reach = 0;
    for (size_t k = 0; k < AOB_COUNT(turned); k++) {
        const float *image = draw_turned(trial, shot, place, turned[k]);
        for (size_t i = 0; image && i < aob_exhibit_pixels(shot->exhibit); i++)
            if (image[i] != clean[i] && away(i, place) > reach)
                reach = away(i, place);
    }
    bool *far = aob_trial_mask(trial, shot->exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(shot->exhibit); i++)
        far[i] = away(i, place) > reach;
    return far;
}

/* A depth of NaN is sky, so that no filter gets a NaN from it; what a technique makes of a normal is its own. One pass, so
 * that the image is larger than what the filter reaches. */
void aob_ask_filter_contains_nan(struct aob_trial *trial)
{
    static const float none[3] = {NAN, NAN, NAN};
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.3, .set = "blur=33 blur_passes=1"};
    const float *clean = aob_trial_draw(trial, &shot);
    for (size_t k = 0; clean && k < AOB_COUNT(places); k++) {
        const bool *far = out_of_reach(trial, &shot, clean, places[k]);
        const float *image = draw_turned(trial, &shot, places[k], none);
        if (!image)
            return;
        struct aob_difference d = aob_difference_of(shot.exhibit, image, clean, far);
        aob_trial_take(trial, d.most, &(struct aob_seen){&shot, image, clean},
                       "a normal of NaN in pixel (%zu, %zu), at (%zu, %zu)", places[k] % 96, places[k] / 96,
                       d.at % 96, d.at / 96);
    }
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
