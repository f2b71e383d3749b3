#include "depths.h"
#include <math.h>
#include "base/memory.h"
#include "sets.h"

static const double radius = 0.5, far_radius = 4096;

/* Compares the exhibit in each of the encodings with it as linear floats. */
static void take_encodings(struct aob_trial *trial, const struct aob_exhibit *exhibit,
                           const char *const *sets, size_t count)
{
    struct aob_shot shot = {.exhibit = exhibit, .radius = radius};
    const float *wanted = aob_trial_draw(trial, &shot);
    for (size_t i = 0; i < count; i++) {
        shot.set = sets[i];
        const float *image = aob_trial_draw(trial, &shot);
        if (!image || !wanted)
            return;
        double rmse = aob_difference_of(exhibit, image, wanted, NULL).rmse;
        aob_trial_take(trial, rmse, &(struct aob_seen){&shot, image, wanted}, "%s", sets[i]);
    }
}

/* The planes are those of a renderer that knows its scene: 2 is before the nearest surface, 16 behind the farthest. */
static const char *const reversed_sets[] = {"depth_encoding=device32 near=2 far=16",
                                            "depth_encoding=device32_reversed near=2 far=16"};

void aob_depths_ask_reversed(struct aob_trial *trial)
{
    take_encodings(trial, aob_set_default(trial), reversed_sets, AOB_COUNT(reversed_sets));
}

void aob_depths_ask_reversed_ortho(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = aob_still_life_camera(2, aob_vec(0, 0, 0));
    camera.ortho_height = 3;
    aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
    const struct aob_exhibit_desc desc = {.mesh = &mesh, .camera = camera, .width = 96, .height = 64};
    take_encodings(trial, aob_trial_exhibit(trial, &desc), reversed_sets, AOB_COUNT(reversed_sets));
}

/* A table on which a ball and a box stand, before the sky. */
static struct aob_exhibit *table(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_box(&mesh, aob_vec(-1.5, -0.2, -1), aob_vec(1.5, 0, 1), 0);
    aob_mesh_add_box(&mesh, aob_vec(-1, 0, -0.6), aob_vec(-0.3, 0.9, 0.1), 20);
    aob_mesh_add_sphere(&mesh, aob_vec(0.5, 0.4, 0), 0.4, 32);
    return aob_trial_exhibit(
        trial,
        &(struct aob_exhibit_desc){
            .mesh = &mesh, .camera = aob_still_life_camera(1, aob_vec(0, 0, 0)), .width = 96, .height = 64});
}

static double sky_of(const struct aob_exhibit *exhibit, const float *image)
{
    double most = 0;
    size_t count = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        if (!aob_exhibit_is_surface(exhibit, i)) {
            most = aob_worse(most, fabs(1 - (double)image[i]));
            count++;
        }
    return count ? most : NAN;
}

void aob_depths_ask_infinite_far(struct aob_trial *trial)
{
    static const char *const sets[] = {"depth_encoding=device32_infinite near=0.5"};
    struct aob_shot shot = {.exhibit = table(trial), .radius = radius, .set = sets[0]};
    const float *image = aob_trial_draw(trial, &shot);
    if (!image)
        return;
    aob_trial_take(trial, sky_of(shot.exhibit, image), &(struct aob_seen){&shot, image, NULL}, "the sky");
    take_encodings(trial, shot.exhibit, sets, 1);
}

/* The still life, and 8192 times as large: there it ends at 61000, below the largest half, and halves round alike. */
static void take_half_scaled(struct aob_trial *trial)
{
    struct aob_shot shots[2];
    float *images[2];
    for (int i = 0; i < 2; i++) {
        double scale = i ? 8192 : 1;
        shots[i] = (struct aob_shot){.exhibit = aob_set_still_life_at(trial, scale, aob_vec(0, 0, 0), 96, 64),
                                     .radius = radius * scale,
                                     .set = "depth_encoding=r16f"};
        images[i] = aob_trial_draw(trial, &shots[i]);
    }
    if (images[0] && images[1])
        aob_trial_take(trial, aob_difference_of(shots[0].exhibit, images[1], images[0], NULL).most,
                       &(struct aob_seen){&shots[1], images[1], images[0]}, "the still life times 8192");
}

/* A wall that stands where halves end, on a floor that ends there too; and the same buffer with depths beyond. */
static void take_half_wall(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    struct aob_shot shot = {.radius = far_radius, .set = "depth_encoding=r16f"};
    aob_set_corner(&mesh, 65504);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh,
        .camera = {.eye = {0, 9000, 65504}, .target = {0, 9000, 0}, .fov_deg = 40},
        .width = 64,
        .height = 48};
    struct aob_exhibit *exhibit = aob_trial_exhibit(trial, &desc);
    shot.exhibit = exhibit;
    const float *wanted = aob_trial_draw(trial, &shot);
    if (!wanted)
        return;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        if (exhibit->gbuffer.depth[i] > 65500)
            exhibit->gbuffer.depth[i] = 1e5f;
    const float *image = aob_trial_draw(trial, &shot);
    if (image)
        aob_trial_take(trial, aob_difference_of(exhibit, image, wanted, NULL).most,
                       &(struct aob_seen){&shot, image, wanted}, "a wall at 1e5 in place of 65504");
}

void aob_depths_ask_half_far(struct aob_trial *trial)
{
    static const double places[] = {3, 60000, 65504, 65505, 1e5};
    double open = NAN;
    for (size_t i = 0; i < AOB_COUNT(places); i++) {
        struct aob_plane_desc plane = {.distance = places[i], .fov_deg = 30};
        struct aob_shot shot = {.exhibit = aob_set_plane(trial, &plane),
                                .radius = i ? far_radius : radius,
                                .set = "depth_encoding=r16f"};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_mean_of(shot.exhibit, image, NULL);
        open = i == 0 ? mean : open;
        aob_trial_take(trial, fabs(mean - open), &(struct aob_seen){&shot, image, NULL},
                       "a plane at %g: mean %.4f, %.4f at 3", places[i], mean, open);
    }
    take_half_scaled(trial);
    take_half_wall(trial);
}

void aob_depths_ask_far_plane(struct aob_trial *trial)
{
    static const char *const sets[] = {
        "depth_encoding=device32 near=2 far=100",          "depth_encoding=device32 near=2 far=1e3",
        "depth_encoding=device32 near=2 far=1e4",          "depth_encoding=device32 near=2 far=1e5",
        "depth_encoding=device32_reversed near=2 far=100", "depth_encoding=device32_reversed near=2 far=1e3",
        "depth_encoding=device32_reversed near=2 far=1e4", "depth_encoding=device32_reversed near=2 far=1e5",
    };
    take_encodings(trial, aob_set_default(trial), sets, AOB_COUNT(sets));
}

/* A thousandth of the nearest depth. These two are as exact as ever. */
void aob_depths_ask_tiny_near(struct aob_trial *trial)
{
    static const char *const sets[] = {"depth_encoding=device32_reversed near=0.002 far=16",
                                       "depth_encoding=device32_infinite near=0.002"};
    take_encodings(trial, aob_set_default(trial), sets, AOB_COUNT(sets));
}

/* A step is z^2 / near / 2^24 = 1.5e-4 z, a hundredth of a pixel, and so the slope from one pixel to the next is off by .01 at
 * most, by .005 on average. */
void aob_depths_ask_tiny_near_forward(struct aob_trial *trial)
{
    static const char *const sets[] = {"depth_encoding=device32 near=0.002 far=16",
                                       "depth_encoding=device24 near=0.002 far=16"};
    take_encodings(trial, aob_set_default(trial), sets, AOB_COUNT(sets));
}

void aob_depths_ask_24_bits(struct aob_trial *trial)
{
    static const char *const sets[] = {"depth_encoding=device24 near=2 far=16"};
    take_encodings(trial, aob_set_default(trial), sets, AOB_COUNT(sets));
}
