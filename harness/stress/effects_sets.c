#include <math.h>
#include <stdio.h>
#include "base/memory.h"
#include "effects.h"
#include "sets.h"

struct aob_light aob_effects_light(struct aob_chance *chance)
{
    const double mean = 2 * sqrt(M_PI);
    struct aob_light light = {{{0}}};
    for (int c = 0; c < 3; c++) {
        for (int i = 1; i < 9; i++)
            light.sh[i][c] = aob_chance_between(chance, -1, 1);
        double scale = -1 / aob_light_least(&light, c);
        for (int i = 1; i < 9; i++)
            light.sh[i][c] *= scale;
        light.sh[0][c] = mean;
    }
    return light;
}

static float number(struct aob_chance *chance)
{
    size_t which = aob_chance_below(chance, 3);
    return which < 2 ? (float)which : (float)aob_chance_unit(chance);
}

void aob_effects_paint(struct aob_gbuffer *gbuffer, struct aob_chance *chance)
{
    size_t count = (size_t)gbuffer->projection.width * (size_t)gbuffer->projection.height;
    if (!gbuffer->albedo) {
        gbuffer->albedo = AOB_NEW_ARRAY(float, 3 * count);
        gbuffer->shine = AOB_NEW_ARRAY(float, 2 * count);
    }
    for (size_t i = 0; i < 3 * count; i++)
        gbuffer->albedo[i] = number(chance);
    for (size_t i = 0; i < 2 * count; i++)
        gbuffer->shine[i] = number(chance);
}

void aob_effects_axial(struct aob_trial *trial, aob_effects_plane_fn *take, void *user)
{
    take(trial, aob_set_plane_beside(trial, aob_vec(0, 0, -1), 0), "a plane ahead", user);
    take(trial, aob_set_plane_beside(trial, aob_vec(0, 0, -1), 3), "a plane ahead, orthographic", user);
    take(trial, aob_set_plane_beside(trial, aob_vec(0, -1, 0), 0), "a floor", user);
    take(trial, aob_set_plane_beside(trial, aob_vec(0, 1, 0), 0), "a ceiling", user);
    take(trial, aob_set_plane_beside(trial, aob_vec(-1, 0, 0), 0), "a wall on the left", user);
    take(trial, aob_set_plane_beside(trial, aob_vec(1, 0, 0), 0), "a wall on the right", user);
}

void aob_effects_planes(struct aob_trial *trial, aob_effects_plane_fn *take, void *user)
{
    /* Guard bands keep the border of the image away from what is judged. */
    static const struct aob_plane_desc kinds[] = {
        {.fov_deg = 90, .guard = 16, .tilt_deg = 20},
        {.fov_deg = 90, .guard = 16, .tilt_deg = 40},
        {.ortho_height = 3, .guard = 16, .tilt_deg = 60},
        {.distance = 10, .fov_deg = 10, .guard = 32, .tilt_deg = 75},
        {.distance = 10, .fov_deg = 10, .guard = 32, .tilt_deg = 85},
    };
    aob_effects_axial(trial, take, user);
    for (size_t k = 0; k < AOB_COUNT(kinds); k++)
        for (int around = 0; around < 360; around += trial->quick ? 120 : 45) {
            struct aob_plane_desc plane = kinds[k];
            char text[80];
            plane.azimuth_deg = around;
            snprintf(text, sizeof text, "%s, tilt %g towards %d",
                     plane.ortho_height > 0 ? "orthographic" : "perspective", plane.tilt_deg, around);
            take(trial, aob_set_plane(trial, &plane), text, user);
        }
}

float *aob_effects_channel(struct aob_trial *trial, const struct aob_exhibit *exhibit, const float *pixels,
                           int channel, double unit)
{
    float *image = aob_trial_image(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        image[i] = (float)((double)pixels[3 * i + (size_t)channel] / unit);
    return image;
}

void aob_effects_take(struct aob_trial *trial, const struct aob_shot *shot, const float *image,
                      const float *wanted, const char *text)
{
    struct aob_difference d = aob_difference_of(shot->exhibit, image, wanted, NULL);
    aob_trial_take(trial, d.most, &(struct aob_seen){shot, image, wanted}, "%s: pixel (%zu, %zu)", text,
                   d.at % (size_t)shot->exhibit->width, d.at / (size_t)shot->exhibit->width);
}
