#include "normals.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "sets.h"

/* Which normals of the image are made odd: one, a block of 8 x 8 in four, or all. */
enum share { ONE, BLOCKS, ALL, SHARES };
static const char *const share_names[SHARES] = {"one normal", "a quarter of the normals", "all normals"};
enum { ONE_X = 28, ONE_Y = 40 }; /* on the floor before the box */

static bool is_odd(enum share share, size_t x, size_t y)
{
    return share == ALL || (share == ONE ? x == ONE_X && y == ONE_Y : (x / 8) % 2 == 0 && (y / 8) % 2 == 0);
}

/* Multiplies them; by NAN they become none. */
static struct aob_exhibit *make_odd(struct aob_trial *trial, enum share share, float factor)
{
    struct aob_exhibit *exhibit = aob_set_default(trial);
    for (size_t i = 0; exhibit && i < aob_exhibit_pixels(exhibit); i++)
        for (size_t c = 0; c < 3; c++)
            if (is_odd(share, i % (size_t)exhibit->width, i / (size_t)exhibit->width))
                exhibit->gbuffer.normal[4 * aob_exhibit_place(exhibit, i) + c] *= factor;
    return exhibit;
}

/* Pixels that neither the radius nor a filter reaches from the odd one: a radius of 0.3 covers 8 pixels there, and filters
 * of half and quarter size some 8 more each. */
static const bool *beyond(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    bool *mask = aob_trial_mask(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        mask[i] = hypot((double)(i % (size_t)exhibit->width) - ONE_X,
                        (double)(i / (size_t)exhibit->width) - ONE_Y) > 24;
    return mask;
}

/* What the odd pixel lacks of half the least of the 5 x 5 about it. Unfiltered it may be a sample's noise darker than they
 * are; a black speck has lost all. */
static double speck(const struct aob_exhibit *exhibit, const float *image)
{
    double least = 1;
    for (int y = ONE_Y - 2; y <= ONE_Y + 2; y++)
        for (int x = ONE_X - 2; x <= ONE_X + 2; x++)
            if (x != ONE_X || y != ONE_Y)
                least = fmin(least, (double)image[y * exhibit->width + x]);
    return aob_over(least / 2 - (double)image[ONE_Y * exhibit->width + ONE_X]);
}

/* One odd normal: what lies beyond keeps its bits, and its own pixel is no black speck. */
static void ask_one(struct aob_trial *trial, float factor)
{
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.3};
    const float *wanted = aob_trial_draw(trial, &shot);
    shot.exhibit = make_odd(trial, ONE, factor);
    const float *image = aob_trial_draw(trial, &shot);
    if (!image || !wanted)
        return;
    struct aob_difference d = aob_difference_of(shot.exhibit, image, wanted, beyond(trial, shot.exhibit));
    double lost = speck(shot.exhibit, image);
    aob_trial_take(trial, d.most > 0 ? 1 : lost, &(struct aob_seen){&shot, image, wanted},
                   "one normal times %g: %g is changed beyond, the pixel lacks %.4f", (double)factor, d.most,
                   lost);
}

/* Without directions: aob_trial_draw holds all images within 0..1, and one of all such normals is not black either. */
static void ask_absent(struct aob_trial *trial, float factor)
{
    ask_one(trial, factor);
    for (int s = BLOCKS; s < SHARES; s++) {
        struct aob_shot shot = {.exhibit = make_odd(trial, (enum share)s, factor), .radius = 0.3};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        bool black = !(aob_mean_of(shot.exhibit, image, NULL) > 0);
        aob_trial_take(trial, black, &(struct aob_seen){&shot, image, NULL}, "%s times %g", share_names[s],
                       (double)factor);
    }
}

void aob_ask_zero_normal(struct aob_trial *trial)
{
    ask_absent(trial, 0);
}

void aob_ask_nan_normal(struct aob_trial *trial)
{
    ask_absent(trial, NAN);
    ask_absent(trial, INFINITY);
}

/* All but the pixels whose surface is seen within 3 degrees from the side: in 8 bits a good normal there may point away by as
 * much, so none can be told from a turned one. */
static const bool *told(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    bool *mask = aob_trial_mask(trial, exhibit);
    const struct aob_projection *view = &exhibit->gbuffer.projection;
    for (int y = 0; y < exhibit->height; y++)
        for (int x = 0; x < exhibit->width; x++) {
            int i = y * exhibit->width + x;
            const float *n = exhibit->hits.normal[i];
            struct aob_vec3 to_camera = aob_vec_normalize(
                aob_vec((view->cx - x - 0.5) * view->sx, (y + 0.5 - view->cy) * view->sy, 1));
            mask[i] = aob_vec_dot(aob_vec((double)n[0], (double)n[1], (double)n[2]), to_camera) > 0.0524;
        }
    return mask;
}

/* The image of odd normals against that of the right ones. */
static void ask_same(struct aob_trial *trial, float factor, const char *set)
{
    struct aob_shot right = {.exhibit = aob_set_default(trial), .radius = 0.8, .set = set},
                    odd = {.exhibit = make_odd(trial, ALL, factor), .radius = 0.8, .set = set};
    const float *wanted = aob_trial_draw(trial, &right), *image = aob_trial_draw(trial, &odd);
    if (!image || !wanted)
        return;
    struct aob_difference d = aob_difference_of(right.exhibit, image, wanted, told(trial, right.exhibit));
    aob_trial_take(trial, d.rmse, &(struct aob_seen){&odd, image, wanted},
                   "all normals times %g: the mean is off by %.4f", (double)factor, d.mean);
}

void aob_ask_flipped_normal(struct aob_trial *trial)
{
    ask_one(trial, -1);
    ask_same(trial, -1, NULL);
}

void aob_ask_unnormalised_normal(struct aob_trial *trial)
{
    static const char *const sets[] = {NULL, "normal_encoding=rgba16f"};
    ask_one(trial, 100);
    for (size_t i = 0; i < AOB_COUNT(sets); i++) {
        ask_same(trial, 0.9f, sets[i]);
        ask_same(trial, 2, sets[i]);
    }
}
