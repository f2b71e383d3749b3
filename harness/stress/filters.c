#include <math.h>
#include "base/memory.h"
#include "resolution.h"
#include "sets.h"

/* The boxes' middles lie at each place of a tile of 4 x 4 pixels, so that noise which repeats cancels. */
static const float *draw_place(struct aob_trial *trial, int place, const char *set, struct aob_shot *shot)
{
    *shot =
        (struct aob_shot){.exhibit = aob_resolution_box(trial, 66 + 2 * (place % 4), 66 + 2 * (place / 4)),
                          .radius = 0.5,
                          .set = set};
    return aob_trial_draw(trial, shot);
}

void aob_ask_impulse_centred(struct aob_trial *trial)
{
    static const char *const sets[] = {"blur=0", NULL};
    struct aob_shot shot;
    const float *image = NULL;
    double x = 0, y = 0;
    for (int k = 0; k < 32; k++) {
        image = draw_place(trial, k / 2, sets[k % 2], &shot);
        if (!image)
            return;
        struct aob_resolution_middle m = aob_resolution_middle_of(&shot, image);
        aob_resolution_hold(trial, &shot, image, &m, k == 0);
        x += (k % 2 ? m.x : -m.x) / 16;
        y += (k % 2 ? m.y : -m.y) / 16;
    }
    aob_trial_take(trial, aob_worse(fabs(x), fabs(y)), &(struct aob_seen){&shot, image, NULL},
                   "filters move it by (%.3f, %.3f) pixels on average", x, y);
}

/* Adds the squares of the steps from each pixel of the wall to the next one, along the rows and along the columns. */
static void add_steps(const struct aob_exhibit *exhibit, const float *image, double steps[2])
{
    int width = exhibit->width;
    for (int i = 0; i < (exhibit->height - 1) * width; i++)
        for (int k = 0; k < 2 && i % width < width - 1; k++) {
            int next = i + (k ? width : 1);
            double d = (double)image[next] - (double)image[i];
            bool wall = aob_exhibit_position(exhibit, (size_t)i).z < 0.01 &&
                        aob_exhibit_position(exhibit, (size_t)next).z < 0.01;
            steps[k] += wall ? d * d : 0;
        }
}

/* About a square box, what is dark falls off as steeply along the rows as along the columns, and noise is as rough. Each
 * filter is as wide as it gets, so that one which works along one axis only shows. */
void aob_ask_impulse_transposed(struct aob_trial *trial)
{
    struct aob_shot shot;
    const float *image = NULL;
    double steps[2] = {0, 0};
    const float *plain = draw_place(trial, 0, "blur=0", &shot);
    if (!plain)
        return;
    const struct aob_resolution_middle m = aob_resolution_middle_of(&shot, plain);
    aob_resolution_hold(trial, &shot, plain, &m, true);
    for (int place = 0; place < 16; place += 5) {
        image = draw_place(trial, place, "blur=33 blur_passes=4 composite=on", &shot);
        if (!image)
            return;
        add_steps(shot.exhibit, image, steps);
    }
    aob_trial_take(trial, aob_worse(steps[0] / steps[1], steps[1] / steps[0]) - 1,
                   &(struct aob_seen){&shot, image, NULL},
                   "squares of steps: %.4f along rows, %.4f along columns", steps[0], steps[1]);
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
        most = aob_worse(most, aob_worse(low - (double)image[i], (double)image[i] - high));
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
    struct aob_shot open = {
        .exhibit = aob_set_plane(trial, &plane), .radius = 0.5, .set = "blur=0 divisor=1"};
    const float *raw = aob_trial_draw(trial, &open);
    for (size_t s = 0; raw && s < set_count; s++) {
        struct aob_shot shot = {.exhibit = open.exhibit, .radius = 0.5, .set = sets[s]};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double out = beyond(open.exhibit, image, raw),
               change = fabs(inner_mean(trial, open.exhibit, image) - inner_mean(trial, open.exhibit, raw));
        aob_trial_take(trial, aob_worse(out, change), &(struct aob_seen){&shot, image, raw},
                       "%s: %.5f beyond the unfiltered values, mean off by %.5f", sets[s], out, change);
    }
}
