#include <math.h>
#include "base/memory.h"
#include "claim.h"
#include "groups.h"
#include "sets.h"

enum { WIDTH = 96, HEIGHT = 64, RAYS = 64 };

static struct aob_exhibit *show(struct aob_trial *trial, struct aob_mesh *mesh,
                                const struct aob_camera *camera)
{
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){.mesh = mesh, .camera = *camera, .width = WIDTH, .height = HEIGHT});
}

/* An endless crease in the middle of the image, as far away as asked, always at the same angle. */
static struct aob_exhibit *show_crease(struct aob_trial *trial, double distance, double fov_deg)
{
    struct aob_mesh mesh = {0};
    aob_set_corner(&mesh, 200);
    return show(
        trial, &mesh,
        &(struct aob_camera){.eye = {0, distance * M_SQRT1_2, distance * M_SQRT1_2}, .fov_deg = fov_deg});
}

/* How much of the occlusion that the image shows is lost: 0 to 1 of it, where it is a tenth at least. */
static double lost(double mean, double shown, double open)
{
    return aob_over(mean - shown) / aob_worse(open - shown, 0.1);
}

static void ask_approach(struct aob_trial *trial)
{
    static const double distances[] = {10, 3, 1, 0.3, 0.1, 0.02};
    for (size_t i = 0; i < AOB_COUNT(distances); i++) {
        struct aob_shot shot = {.exhibit = show_crease(trial, distances[i], 60), .radius = 0.5};
        const float *image = aob_trial_draw(trial, &shot),
                    *scene = aob_claim_trace(trial, &shot, AOB_CLAIM_OF_SCENE, RAYS),
                    *shown = aob_claim_trace(trial, &shot, AOB_CLAIM_OF_IMAGE, RAYS);
        if (!image || !scene || !shown)
            return;
        double mean = aob_mean_of(shot.exhibit, image, NULL), least = aob_mean_of(shot.exhibit, scene, NULL),
               most = aob_mean_of(shot.exhibit, shown, NULL), open = aob_claim_open(trial, &shot);
        double closed = aob_over(least - mean) / aob_worse(least, 0.1);
        aob_trial_take(trial, aob_worse(lost(mean, most, open), closed),
                       &(struct aob_seen){&shot, image, shown},
                       "crease %g away: mean %.4f, of the scene %.4f, of what the image shows %.4f",
                       distances[i], mean, least, most);
    }
}

/* Takes how much of the occlusion that the image shows is lost. */
static void take_lost(struct aob_trial *trial, const struct aob_shot *shot, const char *what)
{
    const float *image = aob_trial_draw(trial, shot),
                *shown = aob_claim_trace(trial, shot, AOB_CLAIM_OF_IMAGE, RAYS);
    if (!image || !shown)
        return;
    double mean = aob_mean_of(shot->exhibit, image, NULL), most = aob_mean_of(shot->exhibit, shown, NULL);
    aob_trial_take(trial, lost(mean, most, aob_claim_open(trial, shot)),
                   &(struct aob_seen){shot, image, shown},
                   "%s, radius %g: mean %.4f, of what the image shows %.4f", what, shot->radius, mean, most);
}

static struct aob_exhibit *show_gallery(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-0.3, 0, 2), aob_vec(0.6, 0, 0), aob_vec(0, 0, -8));
    aob_mesh_add_quad(&mesh, aob_vec(-0.3, 0.8, -6), aob_vec(0.6, 0, 0), aob_vec(0, 0, 8));
    aob_mesh_add_quad(&mesh, aob_vec(-0.3, 0, 2), aob_vec(0, 0, -8), aob_vec(0, 0.8, 0));
    aob_mesh_add_quad(&mesh, aob_vec(0.3, 0, -6), aob_vec(0, 0, 8), aob_vec(0, 0.8, 0));
    return show(trial, &mesh,
                &(struct aob_camera){.eye = {0, 0.45, 1}, .target = {0.1, 0.4, 0}, .fov_deg = 80});
}

/* Blades stand around the eye, thin prisms so that they are closed. */
static struct aob_exhibit *show_blades(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-40, 0, 40), aob_vec(80, 0, 0), aob_vec(0, 0, -80));
    for (int i = 0; i < 120; i++) {
        double x = 0.05 * (i % 12 - 5.5) + 0.013 * (i * 7 % 5), z = -0.06 - 0.05 * (i / 12.0);
        aob_mesh_add_box(&mesh, aob_vec(x, 0, z), aob_vec(x + 0.012, 0.18 + 0.02 * (i % 4), z + 0.004),
                         37 * i);
    }
    return show(trial, &mesh,
                &(struct aob_camera){.eye = {0, 0.12, 0}, .target = {0, 0.08, -0.2}, .fov_deg = 60});
}

static void ask_closer(struct aob_trial *trial)
{
    take_lost(trial, &(struct aob_shot){.exhibit = show_crease(trial, 0.25, 80), .radius = 1},
              "before a crease");
    take_lost(trial, &(struct aob_shot){.exhibit = show_gallery(trial), .radius = 1}, "in a gallery");
    take_lost(trial, &(struct aob_shot){.exhibit = show_blades(trial), .radius = 0.5}, "amid blades");
}

/* The last radius is asked for numbers that are none only: hardly a sample of it projects into the image. */
static void ask_behind(struct aob_trial *trial)
{
    static const double radii[] = {0.9, 1.2, 2, 1000};
    struct aob_exhibit *crease = show_crease(trial, 1, 110);
    double before = NAN;
    for (size_t i = 0; i < AOB_COUNT(radii); i++) {
        struct aob_shot shot = {.exhibit = crease, .radius = radii[i]};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_mean_of(crease, image, NULL);
        before = i == 0 ? mean : before;
        if (i < AOB_COUNT(radii) - 1)
            aob_trial_take(trial, lost(mean, before, aob_claim_open(trial, &shot)),
                           &(struct aob_seen){&shot, image, NULL},
                           "crease 1 away, radius %g: mean %.4f, %.4f with radius %g", radii[i], mean, before,
                           radii[0]);
    }
}

static void ask_box(struct aob_trial *trial)
{
    static const double radii[] = {4, 30};
    struct aob_mesh mesh = {0};
    aob_mesh_add_box(&mesh, aob_vec(-1, -0.8, -1.3), aob_vec(1, 0.8, 1.3), 0);
    aob_set_turn_faces(&mesh);
    const struct aob_camera camera = {.eye = {0.2, 0.1, 0.9}, .target = {-0.1, -0.2, -1}, .fov_deg = 90};
    struct aob_exhibit *inside = show(trial, &mesh, &camera);
    for (size_t i = 0; i < AOB_COUNT(radii); i++)
        take_lost(trial, &(struct aob_shot){.exhibit = inside, .radius = radii[i]}, "in a box");
}

const struct aob_property aob_properties_near[] = {
    {.name = "approach_crease",
     .sentence =
         "A crease that the camera approaches from 10 to 0.02 stays as dark as what the image shows of it, "
         "and no darker than it is.",
     .measure = "share of the occlusion, or of the openness, that the mean has lost against the traced claim",
     .source = "https://github.com/godotengine/godot/issues/48503",
     .group = AOB_GROUP_NEAR,
     .excuse = aob_excuse_no_radius,
     .ask = ask_approach},
    {.name = "closer_than_radius",
     .sentence =
         "Surfaces nearer to the eye than the radius are as dark as what the image shows makes them: before "
         "a crease, in a gallery, amid blades.",
     .measure =
         "share of the occlusion that the mean has lost against the traced claim of what the image shows",
     .source = "https://github.com/DiligentGraphics/DiligentFX/issues/118",
     .group = AOB_GROUP_NEAR,
     .excuse = aob_excuse_no_radius,
     .ask = ask_closer},
    {.name = "behind_camera",
     .sentence =
         "A radius that reaches behind the camera gives numbers, and darkens as much as one that does not.",
     .measure = "share of the occlusion that the mean has lost",
     .source = "docs/stress.md#behind-the-camera",
     .group = AOB_GROUP_NEAR,
     .quick = true,
     .excuse = aob_excuse_no_radius,
     .ask = ask_behind},
    {.name = "inside_box",
     .sentence =
         "Inside a closed box, with a radius far larger than it, all is as dark as the image can tell.",
     .measure =
         "share of the occlusion that the mean has lost against the traced claim of what the image shows",
     .source = "docs/stress.md#o6",
     .group = AOB_GROUP_NEAR,
     .excuse = aob_excuse_no_radius,
     .ask = ask_box},
    {0},
};
