#include <stdio.h>
#include "base/memory.h"
#include "effects.h"
#include "sets.h"

struct asking {
    struct aob_chance chance;
    const char *set;
    bool open; /* the plane must be 1 */
};

static void take_plane(struct aob_trial *trial, struct aob_exhibit *exhibit, const char *text, void *user)
{
    struct asking *asking = user;
    struct aob_shot shot = {.exhibit = exhibit, .radius = 0.5, .set = asking->set};
    if (exhibit)
        aob_effects_paint(&exhibit->gbuffer, &asking->chance);
    struct aob_reading reading = aob_trial_read(trial, &shot);
    const float *specular = reading.of[AOB_OUT_SPECULAR];
    if (!specular)
        return;
    float *open = aob_trial_image(trial, exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        open[i] = asking->open ? 1 : specular[i];
    aob_effects_take(trial, &shot, specular, open, text);
}

/* Roughnesses by lot, a third of them 0 and a third 1. */
void aob_ask_specular_on_plane(struct aob_trial *trial)
{
    struct asking asking = {aob_chance_of("specular_on_plane"), "specular=on", true};
    aob_effects_planes(trial, take_plane, &asking);
}

/* Where a lobe lies half below its surface, and where normals are not quite those of the depth. What is asked is whether
 * aob_trial_read finds anything. */
void aob_ask_specular_is_share(struct aob_trial *trial)
{
    static const double tilts[] = {85, 88, 89, 89.5, 89.9};
    static const char *const sets[] = {"specular=on", "specular=on normals=from_depth",
                                       "specular=on normal_encoding=rgba8",
                                       "specular=on normal_encoding=oct_rg8"};
    for (size_t s = 0; s < AOB_COUNT(sets); s++) {
        struct asking asking = {aob_chance_of("specular_is_share"), sets[s], false};
        aob_effects_axial(trial, take_plane, &asking);
        take_plane(trial, aob_set_default(trial), "the still life", &asking);
        for (size_t t = 0; t < AOB_COUNT(tilts); t++) {
            struct aob_plane_desc plane = {
                .distance = 10, .fov_deg = 10, .tilt_deg = tilts[t], .azimuth_deg = 70.0 * (double)t};
            char text[80];
            snprintf(text, sizeof text, "tilt %g, %s", tilts[t], sets[s]);
            take_plane(trial, aob_set_plane(trial, &plane), text, &asking);
        }
    }
}
