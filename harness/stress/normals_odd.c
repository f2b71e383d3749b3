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

static void ask_absent(struct aob_trial *trial, float factor)
{
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.3};
    const float *whole = aob_trial_draw(trial, &shot);
    shot.set = "normals=from_depth";
    const float *derived = aob_trial_draw(trial, &shot);
    shot.set = NULL;
    for (int s = 0; s < SHARES; s++) {
        shot.exhibit = make_odd(trial, (enum share)s, factor);
        const float *image = aob_trial_draw(trial, &shot);
        if (!image || !whole || !derived)
            return;
        const float *wanted = s == ALL ? derived : whole;
        const bool *mask = s == ONE ? beyond(trial, shot.exhibit) : NULL;
        struct aob_difference d = aob_difference_of(shot.exhibit, image, wanted, mask);
        double off = s == ONE ? d.most : s == ALL ? d.rmse : 0;
        aob_trial_take(trial, off, &(struct aob_seen){&shot, image, wanted}, "%s", share_names[s]);
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

/* The image of odd normals against that of the right ones. */
static void ask_same(struct aob_trial *trial, enum share share, float factor, const char *set)
{
    struct aob_shot right = {.exhibit = aob_set_default(trial), .radius = 0.8, .set = set},
                    odd = {.exhibit = make_odd(trial, share, factor), .radius = 0.8, .set = set};
    const float *wanted = aob_trial_draw(trial, &right), *image = aob_trial_draw(trial, &odd);
    if (!image || !wanted)
        return;
    struct aob_difference d = aob_difference_of(right.exhibit, image, wanted, NULL);
    aob_trial_take(trial, d.rmse, &(struct aob_seen){&odd, image, wanted},
                   "%s times %g: the mean is off by %.4f", share_names[share], (double)factor, d.mean);
}

void aob_ask_flipped_normal(struct aob_trial *trial)
{
    for (int s = 0; s < SHARES; s++)
        ask_same(trial, (enum share)s, -1, NULL);
}

void aob_ask_unnormalised_normal(struct aob_trial *trial)
{
    static const char *const sets[] = {NULL, "normal_encoding=rgba16f"};
    for (size_t i = 0; i < AOB_COUNT(sets); i++) {
        ask_same(trial, ALL, 0.9f, sets[i]);
        ask_same(trial, ALL, 2, sets[i]);
    }
}
