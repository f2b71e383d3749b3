#include "normals.h"
#include <math.h>
#include "base/memory.h"
#include "base/text.h"
#include "sets.h"

/* The greatest angle between a normal and what is read of it, degrees. tests/gbuffer/test_encoding.c has these in closed
 * form; packed8 has no greatest one, and the one here is that of normals up to LEAN from +Z. */
static const struct {
    const char *set;
    double degrees;
} encodings[] = {
    {"normal_encoding=rgba16f", 0.0243},   {"normal_encoding=sphere_rg16f", 0.056},
    {"normal_encoding=oct_rg16f", 0.0594}, {"normal_encoding=rgb10", 0.0971},
    {"normal_encoding=rgba8", 0.3892},     {"normal_encoding=oct_rg8", 0.9533},
    {"normal_encoding=packed8", 1.263},
};
static const double lean_deg = 75;

/* What an angle can do to a visibility. The cosine-weighted one moves by at most half of it (the integral of the direction's
 * part along the turn over a quarter of the sphere is pi/2, over pi), the evenly weighted one by 1/pi of it (the lune of the
 * directions that the hemisphere wins or loses), an obscurance of intensity 1 by 4/pi: twice the mean of r/s over the disc,
 * which is 2, times the mean of the positive part of a cosine. */
static double effect_of(double degrees)
{
    return 4 / M_PI * degrees * M_PI / 180;
}

void aob_ask_encodings_plane(struct aob_trial *trial)
{
    static const double tilts[] = {0, 40, 75};
    for (size_t t = 0; t < AOB_COUNT(tilts); t++) {
        const struct aob_plane_desc plane = {.tilt_deg = tilts[t], .azimuth_deg = 30};
        struct aob_shot shot = {.exhibit = aob_set_plane(trial, &plane), .radius = 0.5};
        const float *wanted = aob_trial_draw(trial, &shot);
        for (size_t e = 0; e < AOB_COUNT(encodings); e++) {
            shot.set = encodings[e].set;
            const float *image = aob_trial_draw(trial, &shot);
            if (!image || !wanted)
                return;
            double off = fabs(aob_difference_of(shot.exhibit, image, wanted, NULL).mean);
            aob_trial_take(trial, aob_over(off - effect_of(encodings[e].degrees)),
                           &(struct aob_seen){&shot, image, wanted},
                           "%s, tilt %g degrees: the mean is off by %.4f", shot.set, tilts[t], off);
        }
    }
}

/* Surfaces whose normals lean no more than that. */
static const bool *upright(struct aob_trial *trial, const struct aob_exhibit *exhibit)
{
    bool *mask = aob_trial_mask(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        mask[i] = (double)exhibit->gbuffer.normal[4 * aob_exhibit_place(exhibit, i) + 2] >
                  cos(lean_deg * M_PI / 180);
    return mask;
}

void aob_ask_encodings_image(struct aob_trial *trial)
{
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.8};
    const float *wanted = aob_trial_draw(trial, &shot);
    const bool *mask = wanted ? upright(trial, shot.exhibit) : NULL;
    for (size_t e = 0; e < AOB_COUNT(encodings); e++) {
        shot.set = encodings[e].set;
        const float *image = aob_trial_draw(trial, &shot);
        if (!image || !wanted)
            return;
        double rmse = aob_difference_of(shot.exhibit, image, wanted, mask).rmse;
        aob_trial_take(trial, aob_over(rmse - effect_of(encodings[e].degrees)),
                       &(struct aob_seen){&shot, image, wanted}, "%s: RMSE %.4f", shot.set, rmse);
    }
}
