#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "resolution.h"
#include "sets.h"

/* The boxes' middles lie at each place of a tile of 4 x 4 pixels, so that noise which repeats cancels. */
static const float *draw_place(struct aob_trial *trial, int place, const char *set, struct aob_shot *shot)
{
    *shot = (struct aob_shot){.exhibit = aob_resolution_box(trial, 66 + 2 * (place % 4), 66 + 2 * (place / 4)),
                              .radius = 0.5,
                              .set = set};
    return aob_trial_draw(trial, shot);
}

void aob_ask_impulse_centred(struct aob_trial *trial)
{
    static const char *const sets[] = {NULL, "blur=0"};
    struct aob_shot shot;
    const float *image = NULL;
    double x = 0, y = 0;
    for (int k = 0; k < 32; k++) {
        image = draw_place(trial, k / 2, sets[k % 2], &shot);
        if (!image)
            return;
        struct aob_resolution_middle m = aob_resolution_middle_of(&shot, image);
        if (!(m.dark >= 1))
            aob_trial_excuse(trial, "nothing is dark beside a box");
        x += (k % 2 ? -m.x : m.x) / 16;
        y += (k % 2 ? -m.y : m.y) / 16;
    }
    aob_trial_take(trial, fmax(fabs(x), fabs(y)), &(struct aob_seen){&shot, image, NULL},
                   "filters move it by (%.3f, %.3f) pixels on average", x, y);
}

enum { WINDOW = 40, HALF = WINDOW / 2 };
struct window {
    float mean[WINDOW][WINDOW]; /* of 16 images, the box in the middle */
    bool counts[WINDOW][WINDOW]; /* the wall, where it is dark */
};

static void add_place(const struct aob_shot *shot, const float *image, struct window *window)
{
    int width = shot->exhibit->width, height = shot->exhibit->height;
    for (int y = 0; y < WINDOW; y++)
        for (int x = 0; x < WINDOW; x++) {
            size_t i = (size_t)((y + height / 2 - HALF) * width + x + width / 2 - HALF);
            struct aob_vec3 p = aob_exhibit_position(shot->exhibit, i);
            window->mean[y][x] += image[i] / 16;
            window->counts[y][x] = p.z < 0.01 && fmax(fabs(p.x), fabs(p.y)) < 0.25 + 0.9 * shot->radius;
        }
}

/* RMSE between the window and its transpose. */
static double unlike_transpose(const struct window *window)
{
    double square = 0, count = 0;
    for (int y = 0; y < WINDOW; y++)
        for (int x = 0; x < WINDOW; x++) {
            double d = (double)window->mean[y][x] - (double)window->mean[x][y];
            square += window->counts[y][x] ? d * d : 0;
            count += window->counts[y][x];
        }
    return sqrt(square / count);
}

/* Each filter is as wide as it gets, so that one which works along one axis only shows. */
void aob_ask_impulse_transposed(struct aob_trial *trial)
{
    struct window *window = AOB_NEW(struct window);
    struct aob_shot shot;
    const float *image = NULL;
    bool ok = true;
    for (int place = 0; ok && place < 16; place++) {
        image = draw_place(trial, place, "blur=33 blur_passes=4 composite=on", &shot);
        ok = image;
        if (ok)
            add_place(&shot, image, window);
    }
    if (ok)
        aob_trial_take(trial, unlike_transpose(window), &(struct aob_seen){&shot, image, NULL},
                       "the mean of 16 images against its transpose");
    free(window);
}

/* How far an image leaves the range of another one's values. */
static double beyond(const struct aob_exhibit *exhibit, const float *image, const float *raw)
{
    double low = INFINITY, high = 0, most = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
        low = fmin(low, (double)raw[i]);
        high = fmax(high, (double)raw[i]);
    }
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        most = fmax(most, fmax(low - (double)image[i], (double)image[i] - high));
    return most;
}

/* The mean of what lies so far from the border that no filter has less to read there. */
static double inner_mean(struct aob_trial *trial, const struct aob_exhibit *exhibit, const float *image)
{
    enum { BORDER = 24 };
    bool *inner = aob_trial_mask(trial, exhibit);
    for (int y = BORDER; y < exhibit->height - BORDER; y++)
        for (int x = BORDER; x < exhibit->width - BORDER; x++)
            inner[y * exhibit->width + x] = true;
    return aob_mean_of(exhibit, image, inner);
}

void aob_ask_constant_kept(struct aob_trial *trial)
{
    static const char *const sets[] = {"blur=33 blur_passes=4 composite=on",
                                       "blur=33 blur_passes=4 composite=on divisor=4"};
    size_t set_count = aob_subject_has(trial->subject, "divisor") ? 2 : 1;
    struct aob_plane_desc plane = {.width = 96, .height = 80};
    struct aob_shot open = {.exhibit = aob_set_plane(trial, &plane), .radius = 0.5, .set = "blur=0 divisor=1"};
    const float *raw = aob_trial_draw(trial, &open);
    for (size_t s = 0; raw && s < set_count; s++) {
        struct aob_shot shot = {.exhibit = open.exhibit, .radius = 0.5, .set = sets[s]};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double out = beyond(open.exhibit, image, raw),
               change = fabs(inner_mean(trial, open.exhibit, image) - inner_mean(trial, open.exhibit, raw));
        aob_trial_take(trial, fmax(out, change), &(struct aob_seen){&shot, image, raw},
                       "%s: %.5f beyond the unfiltered values, mean off by %.5f", sets[s], out, change);
    }
}
