#include <stdio.h>
#include "base/memory.h"
#include "groups.h"
#include "sets.h"
#include "technique/clearance.h"

static const char *excuse_spends(const struct aob_subject *subject)
{
    return subject->technique->clearance ? NULL : "it leaves nothing out";
}

/* Open ground, what stands on it, and a ramp that hardly rises, seen from near and from far. */
static struct aob_exhibit *make_set(struct aob_trial *trial, size_t k)
{
    static const struct aob_plane_desc planes[] = {{.tilt_deg = 70, .width = 96, .height = 64},
                                                   {.tilt_deg = 88, .width = 96, .height = 64}};
    struct aob_mesh mesh = {0};
    struct aob_exhibit_desc desc = {.mesh = &mesh, .width = 96, .height = 64};
    if (k < AOB_COUNT(planes))
        return aob_set_plane(trial, &planes[k]);
    if (k == AOB_COUNT(planes))
        return aob_set_default(trial);
    if (k > AOB_COUNT(planes) + 2)
        return NULL;
    aob_mesh_add_quad(&mesh, aob_vec(-40, 0, 40), aob_vec(80, 0, 0), aob_vec(0, 0, -80));
    aob_mesh_add_quad(&mesh, aob_vec(-40, 0, 0), aob_vec(80, 0, 0), aob_vec(0, 1.4, -40)); /* by 3.5 % */
    aob_mesh_add_box(&mesh, aob_vec(0.2, 0, 0.3), aob_vec(0.5, 0.2, 0.6), 20);
    desc.camera = (struct aob_camera){.eye = {0, 1.5, k % 2 ? 2 : 9}, .target = {0, 0, -1}, .fov_deg = 60};
    return aob_trial_exhibit(trial, &desc);
}

/* Whether the technique leaves anything out in a shot. */
static bool takes_part(struct aob_trial *trial, const struct aob_shot *shot)
{
    unsigned char values[4 * AOB_MAX_PARAM];
    struct aob_options options;
    return aob_subject_values(trial->subject, shot, values, &options, &trial->error) &&
           aob_clearance_of(trial->subject->technique, values).sine > 0;
}

/* Radii from what is hardly a pixel to what covers most of the image; what makes a technique dark; and both ways to take a sphere. */
static void ask_thrift_hides_nothing(struct aob_trial *trial)
{
    static const double radii[] = {0.02, 0.3, 2};
    static const char *const sets[][2] = {
        {"thrift=off hemisphere=on", "thrift=on hemisphere=on"},
        {"thrift=off intensity=5 contrast=3 attenuation=0 hemisphere=off resolutions=one",
         "thrift=on intensity=5 contrast=3 attenuation=0 hemisphere=off resolutions=one"},
        {"thrift=off divisor=2", "thrift=on divisor=2"}};
    struct aob_exhibit *exhibit;
    bool asked = false;
    for (size_t k = 0; (exhibit = make_set(trial, k)); k++)
        for (size_t i = 0; i < AOB_COUNT(radii) * (trial->quick ? 2 : AOB_COUNT(sets)); i++) {
            struct aob_shot whole = {.exhibit = exhibit, .radius = radii[i % AOB_COUNT(radii)]},
                            spared = whole;
            whole.set = sets[i / AOB_COUNT(radii)][0];
            spared.set = sets[i / AOB_COUNT(radii)][1];
            if (!takes_part(trial, &spared))
                continue;
            asked = true;
            const float *wanted = aob_trial_draw(trial, &whole), *image = aob_trial_draw(trial, &spared);
            if (image && wanted)
                aob_trial_take(trial, aob_difference_of(exhibit, image, wanted, NULL).most,
                               &(struct aob_seen){&spared, image, wanted}, "set %zu, radius %g, %s", k,
                               spared.radius, spared.set);
        }
    if (!asked)
        aob_trial_excuse(trial, "it leaves nothing out");
}

const struct aob_property aob_properties_thrift[] = {{.name = "thrift_hides_nothing",
                                                      .sentence = "What thrift leaves out shows nowhere.",
                                                      .measure = "largest difference of a pixel",
                                                      .source = "docs/decisions/0045-thrift.md",
                                                      .group = AOB_GROUP_RELATIONS,
                                                      .quick = true,
                                                      .excuse = excuse_spends,
                                                      .ask = ask_thrift_hides_nothing},
                                                     {0}};
