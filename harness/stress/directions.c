#include <math.h>
#include <stdio.h>
#include "base/memory.h"
#include "claim.h"
#include "groups.h"
#include "score/bent.h"
#include "sets.h"

enum { RAYS = 256 };

/* Takes the largest angle to the surface's own normal, which is the mean open direction of a plane. */
static void take_plane(struct aob_trial *trial, const struct aob_exhibit *exhibit, const char *text)
{
    struct aob_shot shot = {.exhibit = exhibit, .radius = 0.5, .set = "bent_normal=on"};
    struct aob_open open = aob_trial_draw_open(trial, &shot);
    float *angles = open.bent ? aob_trial_image(trial, exhibit) : NULL;
    size_t at = 0;
    for (size_t i = 0; angles && i < aob_exhibit_pixels(exhibit); i++) {
        const float *normal = exhibit->gbuffer.normal + 4 * aob_exhibit_place(exhibit, i);
        angles[i] = aob_exhibit_is_surface(exhibit, i) ? (float)aob_bent_angle(open.bent[i], normal) : 0;
        at = angles[i] > angles[at] ? i : at;
    }
    if (angles)
        aob_trial_take(trial, (double)angles[at], &(struct aob_seen){&shot, angles, NULL},
                       "%s, pixel (%d, %d)", text, (int)(at % (size_t)exhibit->width),
                       (int)(at / (size_t)exhibit->width));
}

static void take_tilted(struct aob_trial *trial, const struct aob_plane_desc *plane)
{
    char text[80];
    snprintf(text, sizeof text, "%g degrees wide, tilt %g towards %g", plane->fov_deg, plane->tilt_deg,
             plane->azimuth_deg);
    take_plane(trial, aob_set_plane(trial, plane), text);
}

/* In the corners of a wide view the slices are far from even in the image; a narrow one sees steep planes. */
static void ask_plane(struct aob_trial *trial)
{
    struct aob_plane_desc wide = {.fov_deg = 90, .guard = 16},
                          narrow = {.distance = 10, .fov_deg = 10, .tilt_deg = 75, .guard = 32};
    for (int around = 0; around < 8; around++) {
        wide.azimuth_deg = narrow.azimuth_deg = 45 * around;
        for (wide.tilt_deg = 0; wide.tilt_deg <= 40; wide.tilt_deg += 20)
            take_tilted(trial, &wide);
        take_tilted(trial, &narrow);
    }
}

/* Normals exactly along the axes of view space. */
static void ask_axial(struct aob_trial *trial)
{
    take_plane(trial, aob_set_plane_beside(trial, aob_vec(0, 0, -1), 0), "a plane ahead");
    take_plane(trial, aob_set_plane_beside(trial, aob_vec(0, 0, -1), 3), "a plane ahead, orthographic");
    take_plane(trial, aob_set_plane_beside(trial, aob_vec(0, -1, 0), 0), "a floor");
    take_plane(trial, aob_set_plane_beside(trial, aob_vec(0, 1, 0), 0), "a ceiling");
    take_plane(trial, aob_set_plane_beside(trial, aob_vec(-1, 0, 0), 0), "a wall on the left");
    take_plane(trial, aob_set_plane_beside(trial, aob_vec(1, 0, 0), 0), "a wall on the right");
}

/* Before a crease the mean open direction leans away from the wall. The plain normal is off by all of that lean, so that its angle
 * is the measure. */
static void ask_crease(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_set_corner(&mesh, 200);
    const struct aob_exhibit_desc desc = {.mesh = &mesh,
                                          .camera = {.eye = {0, M_SQRT2, M_SQRT2}, .fov_deg = 40},
                                          .width = 96,
                                          .height = 64,
                                          .guard = 48};
    struct aob_shot shot = {
        .exhibit = aob_trial_exhibit(trial, &desc), .radius = 0.5, .set = "bent_normal=on"};
    struct aob_open open = aob_trial_draw_open(trial, &shot),
                    claim = aob_claim_trace_open(trial, &shot, AOB_CLAIM_OF_SCENE, RAYS);
    if (!open.bent || !claim.bent)
        return;
    double missed = 0, whole = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(shot.exhibit); i++) {
        const float *normal = shot.exhibit->gbuffer.normal + 4 * aob_exhibit_place(shot.exhibit, i);
        if (!aob_exhibit_is_surface(shot.exhibit, i) || !(claim.visibility[i] < 0.98f))
            continue;
        missed += aob_bent_angle(open.bent[i], claim.bent[i]);
        whole += aob_bent_angle(normal, claim.bent[i]);
    }
    aob_trial_take(trial, missed / whole, &(struct aob_seen){&shot, open.visibility, claim.visibility},
                   "before a crease the directions are %.3g times as far off as the plain normals",
                   missed / whole);
}

static void ask_same_visibility(struct aob_trial *trial)
{
    static const char *const sets[][2] = {{"", "bent_normal=on"}, {"divisor=2", "divisor=2 bent_normal=on"}};
    for (size_t s = 0; s < AOB_COUNT(sets); s++) {
        struct aob_exhibit *exhibit = aob_set_default(trial);
        struct aob_shot alone = {.exhibit = exhibit, .radius = 0.5, .set = sets[s][0]},
                        both = {.exhibit = exhibit, .radius = 0.5, .set = sets[s][1]};
        const float *wanted = aob_trial_draw(trial, &alone),
                    *image = aob_trial_draw_open(trial, &both).visibility;
        if (!wanted || !image)
            return;
        struct aob_difference d = aob_difference_of(exhibit, image, wanted, NULL);
        aob_trial_take(trial, d.most, &(struct aob_seen){&both, image, wanted}, "'%s': pixel %zu", sets[s][1],
                       d.at);
    }
}

/* What is no surface, and normals that are none, among good ones; aob_trial_draw_open looks at what is left. */
static void ask_hostile(struct aob_trial *trial)
{
    static const float values[] = {NAN, INFINITY, 0, -1, 1e-42f};
    for (size_t v = 0; v < AOB_COUNT(values); v++)
        for (int what = 0; what < 2; what++) {
            struct aob_exhibit *exhibit = aob_set_default(trial);
            for (size_t i = 0; exhibit && i < aob_exhibit_pixels(exhibit); i += 7) {
                if (what == 0)
                    exhibit->gbuffer.depth[aob_exhibit_place(exhibit, i)] = values[v];
                else
                    for (size_t c = 0; c < 3; c++)
                        exhibit->gbuffer.normal[4 * aob_exhibit_place(exhibit, i) + c] = values[v];
            }
            struct aob_shot shot = {.exhibit = exhibit, .radius = 0.5, .set = "bent_normal=on"};
            struct aob_open open = aob_trial_draw_open(trial, &shot);
            if (!open.bent)
                return;
            aob_trial_take(trial, 0, &(struct aob_seen){&shot, open.visibility, NULL},
                           "every seventh %s is %g", what == 0 ? "depth" : "normal", (double)values[v]);
        }
}

const struct aob_property aob_properties_directions[] = {
    {.name = "bent_on_plane",
     .sentence =
         "On an open plane the mean open direction is the normal, at every tilt and place of the image.",
     .measure = "largest angle of a pixel, in degrees",
     .source = "docs/stress.md#bent-normals",
     .group = AOB_GROUP_DIRECTIONS,
     .quick = true,
     .excuse = aob_excuse_no_bent_normal,
     .ask = ask_plane},
    {.name = "bent_axial",
     .sentence = "The same where the normal lies exactly along an axis of view space.",
     .measure = "largest angle of a pixel, in degrees",
     .source = "docs/stress.md#bent-normals",
     .group = AOB_GROUP_DIRECTIONS,
     .quick = true,
     .excuse = aob_excuse_no_bent_normal,
     .ask = ask_axial},
    {.name = "bent_in_crease",
     .sentence = "Before a crease the mean open direction leans away from the wall as the traced one does.",
     .measure = "its angle to the traced direction as a share of the plain normal's",
     .source = "docs/stress.md#bent-normals",
     .group = AOB_GROUP_DIRECTIONS,
     .excuse = aob_excuse_no_bent_normal,
     .ask = ask_crease},
    {.name = "bent_keeps_visibility",
     .sentence = "Whoever asks for the bent normal gets the same visibility as whoever does not.",
     .measure = "largest difference of a pixel",
     .source = "docs/stress.md#bent-normals",
     .group = AOB_GROUP_DIRECTIONS,
     .excuse = aob_excuse_no_bent_normal,
     .ask = ask_same_visibility},
    {.name = "bent_is_finite",
     .sentence = "Beside depths and normals that are none, the bent normals of surfaces are finite and no "
                 "longer than 1.",
     .measure = "0, or no number where one is not",
     .source = "docs/stress.md#bent-normals",
     .group = AOB_GROUP_DIRECTIONS,
     .quick = true,
     .excuse = aob_excuse_no_bent_normal,
     .ask = ask_hostile},
    {0},
};
