#include <math.h>
#include <stdio.h>
#include "base/memory.h"
#include "effects.h"
#include "sets.h"

static const float matt[2] = {1, 0}, metal[2] = {0.3f, 1};

static struct aob_shot shot_of(const struct aob_exhibit *exhibit)
{
    return (struct aob_shot){.exhibit = exhibit, .radius = 0.5, .set = "visibility_rgb=on"};
}

static void take_plane(struct aob_trial *trial, struct aob_exhibit *exhibit, const char *text, void *user)
{
    struct aob_shot shot = shot_of(exhibit);
    if (exhibit)
        aob_effects_paint(&exhibit->gbuffer, user);
    struct aob_reading reading = aob_trial_read(trial, &shot);
    const float *bounced = reading.of[AOB_OUT_VISIBILITY_RGB];
    if (!bounced)
        return;
    float *open = aob_trial_image(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        open[i] = 1;
    for (int c = 0; c < 3; c++)
        aob_effects_take(trial, &shot, aob_effects_channel(trial, exhibit, bounced, c, 1), open, text);
}

void aob_ask_bounced_on_plane(struct aob_trial *trial)
{
    struct aob_chance chance = aob_chance_of("bounced_on_plane");
    aob_effects_planes(trial, take_plane, &chance);
}

/* Whatever a surface is made of, what comes back adds to what is open, and no more light arrives than from an open sky. */
void aob_ask_bounced_within(struct aob_trial *trial)
{
    struct aob_chance chance = aob_chance_of("bounced_within");
    for (int n = 0; n < 3; n++) {
        struct aob_exhibit *exhibit = aob_set_default(trial);
        struct aob_shot shot = shot_of(exhibit);
        if (exhibit)
            aob_effects_paint(&exhibit->gbuffer, &chance);
        struct aob_reading reading = aob_trial_read(trial, &shot);
        const float *open = reading.of[AOB_OUT_VISIBILITY], *bounced = reading.of[AOB_OUT_VISIBILITY_RGB];
        if (!bounced)
            return;
        double most = 0;
        size_t at = 0;
        for (size_t i = 0; i < 3 * aob_exhibit_pixels(exhibit); i++) {
            double b = (double)bounced[i], over = fmax((double)open[i / 3] - b, b - 1);
            if (aob_exhibit_is_surface(exhibit, i / 3) && over > most) {
                most = over;
                at = i;
            }
        }
        aob_trial_take(trial, most, &(struct aob_seen){&shot, open, NULL},
                       "pixel %zu is %g at a visibility of %g", at / 3, (double)bounced[at],
                       (double)open[at / 3]);
    }
}

/* A draw of an exhibit in one material. */
static const float *draw_painted(struct aob_trial *trial, struct aob_exhibit *exhibit, const float albedo[3],
                                 const float shine[2], const float **open)
{
    const struct aob_shot shot = shot_of(exhibit);
    if (exhibit)
        aob_exhibit_paint(exhibit, albedo, shine);
    struct aob_reading reading = aob_trial_read(trial, &shot);
    if (open)
        *open = reading.of[AOB_OUT_VISIBILITY];
    return reading.of[AOB_OUT_VISIBILITY_RGB];
}

void aob_ask_bounced_rises(struct aob_trial *trial)
{
    static const float greys[] = {0, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 1};
    struct aob_exhibit *exhibit = aob_set_default(trial);
    const struct aob_shot shot = shot_of(exhibit);
    const float *before = NULL, *now;
    for (size_t g = 0; g < AOB_COUNT(greys); g++, before = now) {
        now = draw_painted(trial, exhibit, (const float[3]){greys[g], greys[g], greys[g]}, matt, NULL);
        if (!now)
            return;
        double fall = 0;
        for (size_t i = 0; before && i < 3 * aob_exhibit_pixels(shot.exhibit); i++)
            if (aob_exhibit_is_surface(shot.exhibit, i / 3))
                fall = fmax(fall, (double)before[i] - (double)now[i]);
        aob_trial_take(trial, fall, &(struct aob_seen){&shot, NULL, NULL}, "an albedo of %g",
                       (double)greys[g]);
    }
}

static void take_nothing_comes_back(struct aob_trial *trial, const float albedo[3], const float shine[2])
{
    struct aob_exhibit *exhibit = aob_set_default(trial);
    const struct aob_shot shot = shot_of(exhibit);
    const float *open = NULL, *bounced = draw_painted(trial, exhibit, albedo, shine, &open);
    char text[80];
    snprintf(text, sizeof text, "albedo (%g, %g, %g), metalness %g", (double)albedo[0], (double)albedo[1],
             (double)albedo[2], (double)shine[1]);
    for (int c = 0; bounced && c < 3; c++)
        aob_effects_take(trial, &shot, aob_effects_channel(trial, shot.exhibit, bounced, c, 1), open, text);
}

void aob_ask_bounced_black(struct aob_trial *trial)
{
    take_nothing_comes_back(trial, (const float[3]){0, 0, 0}, matt);
    take_nothing_comes_back(trial, (const float[3]){0, 0, 0}, (const float[2]){0, 0.5f});
}

void aob_ask_bounced_metal(struct aob_trial *trial)
{
    take_nothing_comes_back(trial, (const float[3]){1, 1, 1}, metal);
    take_nothing_comes_back(trial, (const float[3]){0.9f, 0.6f, 0.2f}, metal);
}

/* Each channel is that of a grey surface which has its albedo throughout. */
void aob_ask_bounced_channels(struct aob_trial *trial)
{
    static const float levels[3] = {0.1f, 0.5f, 0.9f};
    static const int orders[][3] = {{0, 1, 2}, {1, 2, 0}, {2, 1, 0}};
    struct aob_exhibit *exhibit = aob_set_default(trial);
    const struct aob_shot shot = shot_of(exhibit);
    const float *greys[3];
    for (int g = 0; g < 3; g++)
        greys[g] =
            draw_painted(trial, exhibit, (const float[3]){levels[g], levels[g], levels[g]}, matt, NULL);
    for (size_t k = 0; k < AOB_COUNT(orders); k++) {
        const int *o = orders[k];
        const float albedo[3] = {levels[o[0]], levels[o[1]], levels[o[2]]};
        const float *bounced = draw_painted(trial, exhibit, albedo, matt, NULL);
        char text[80];
        if (!bounced || !greys[0] || !greys[1] || !greys[2])
            return;
        for (int c = 0; c < 3; c++) {
            snprintf(text, sizeof text, "channel %d of albedo (%g, %g, %g)", c, (double)albedo[0],
                     (double)albedo[1], (double)albedo[2]);
            aob_effects_take(trial, &shot, aob_effects_channel(trial, shot.exhibit, bounced, c, 1),
                             aob_effects_channel(trial, shot.exhibit, greys[o[c]], c, 1), text);
        }
    }
}
