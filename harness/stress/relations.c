#include <math.h>
#include <stdio.h>
#include "base/memory.h"
#include "groups.h"
#include "match.h"
#include "sets.h"

/* The still life that others are compared with, 128 pixels a side, so that it may be turned, with a guard band that is wider
 * than the radius, so that no border shows. The radius is one for all: some techniques compile a program for each length. */
enum { SIDE = 128, GUARD = 32 };
static const double radius = 0.5; /* some 20 pixels */

struct moved {
    struct aob_camera own, camera; /* of the scene as it stands, and of the moved one */
    struct aob_motion motion;
    const char *set;
    int block; /* pixels a side of the blocks that are compared */
    const char *what;
};

static const float *draw_moved(struct aob_trial *trial, const struct moved *moved, bool moves,
                               struct aob_shot *shot)
{
    struct aob_mesh mesh = {0};
    aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
    aob_motion_apply(moves ? &moved->motion : &aob_motion_none, &mesh);
    const struct aob_exhibit_desc desc = {.mesh = &mesh,
                                          .camera = moves ? moved->camera : moved->own,
                                          .width = SIDE,
                                          .height = SIDE,
                                          .guard = GUARD};
    *shot =
        (struct aob_shot){.exhibit = aob_trial_exhibit(trial, &desc), .radius = radius, .set = moved->set};
    return aob_trial_draw(trial, shot);
}

/* Takes how far the image of the moved scene is from that of the scene as it stands. */
static void take_moved(struct aob_trial *trial, const struct moved *moved)
{
    struct aob_shot own, other;
    size_t at;
    const float *image = draw_moved(trial, moved, false, &own),
                *other_image = draw_moved(trial, moved, true, &other);
    if (!image || !other_image)
        return;
    float *wanted = aob_trial_image(trial, own.exhibit);
    bool *seen = aob_trial_mask(trial, own.exhibit);
    aob_match_fetch(&(struct aob_match){own.exhibit, other.exhibit, moved->motion}, other_image, wanted,
                    seen);
    double worst = aob_match_blocks(own.exhibit, image, wanted, seen, moved->block, &at);
    aob_trial_take(trial, worst, &(struct aob_seen){&own, image, wanted}, "%s, block at (%zu, %zu)",
                   moved->what, at % SIDE, at / SIDE);
}

/* With more samples than by default: a tile of noise is the same all over a wall, and no block is too large for it. */
static void take_turned(struct aob_trial *trial, const struct aob_motion *motion,
                        const struct aob_camera *camera, const char *what)
{
    const struct moved moved = {.own = aob_still_life_camera(1, aob_vec(0, 0, 0)),
                                .camera = *camera,
                                .motion = *motion,
                                .set = "samples=64",
                                .block = 32,
                                .what = what};
    take_moved(trial, &moved);
}

static void ask_mirrored(struct aob_trial *trial)
{
    struct aob_camera camera = aob_still_life_camera(1, aob_vec(0, 0, 0));
    struct aob_motion mirror = aob_motion_mirror();
    camera.eye = aob_motion_of(&mirror, camera.eye);
    camera.target = aob_motion_of(&mirror, camera.target);
    take_turned(trial, &mirror, &camera, "mirrored at x = 0");
}

/* A camera has no roll of its own; the scene is turned about its axis in place of it. */
static void take_rolled(struct aob_trial *trial, double deg)
{
    char what[32];
    struct aob_camera camera = aob_still_life_camera(1, aob_vec(0, 0, 0));
    struct aob_motion roll = aob_motion_turn(camera.eye, aob_camera_axes(&camera).back, deg);
    snprintf(what, sizeof what, "turned by %g degrees", deg);
    take_turned(trial, &roll, &camera, what);
}

static void ask_quarter_turn(struct aob_trial *trial)
{
    for (int quarters = 1; quarters <= 3; quarters++)
        take_rolled(trial, 90 * quarters);
}

static void ask_camera_roll(struct aob_trial *trial)
{
    take_rolled(trial, 20);
    take_rolled(trial, 45);
}

/* 64 pixels are a whole number of all tiles of noise that anybody uses. */
static void ask_shifted_by_tile(struct aob_trial *trial)
{
    static const int shifts[][2] = {{64, 0}, {0, 64}};
    struct moved moved = {
        .own = aob_still_life_camera(1, aob_vec(0, 0, 0)), .motion = aob_motion_none, .block = 64};
    moved.own.ortho_height = 3.5;
    const struct aob_frame_axes axes = aob_camera_axes(&moved.own);
    for (size_t i = 0; i < AOB_COUNT(shifts); i++) {
        char what[32];
        double pixel = moved.own.ortho_height / SIDE;
        struct aob_vec3 by = aob_vec_add(aob_vec_scale(axes.right, shifts[i][0] * pixel),
                                         aob_vec_scale(axes.up, shifts[i][1] * pixel));
        moved.camera = moved.own;
        moved.camera.eye = aob_vec_add(moved.own.eye, by);
        moved.camera.target = aob_vec_add(moved.own.target, by);
        snprintf(what, sizeof what, "moved by (%d, %d) pixels", shifts[i][0], shifts[i][1]);
        moved.what = what;
        take_moved(trial, &moved);
    }
}

/* The still life so large that the radius has a share of it, with a guard band as wide as the largest radius, so that no
 * occluder leaves the image as the radius grows. */
static void ask_more_radius(struct aob_trial *trial)
{
    static const double radii[] = {0.05, 0.1, 0.2, 0.4, 0.8};
    double before = NAN;
    for (size_t i = 0; i < AOB_COUNT(radii); i++) {
        double scale = radius / radii[i];
        struct aob_mesh mesh = {0};
        aob_set_still_life(&mesh, scale, aob_vec(0, 0, 0));
        const struct aob_exhibit_desc desc = {.mesh = &mesh,
                                              .camera = aob_still_life_camera(scale, aob_vec(0, 0, 0)),
                                              .width = 96,
                                              .height = 64,
                                              .guard = GUARD};
        const struct aob_shot shot = {.exhibit = aob_trial_exhibit(trial, &desc), .radius = radius};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_mean_of(shot.exhibit, image, NULL);
        if (i > 0)
            aob_trial_take(trial, aob_over(mean - before), &(struct aob_seen){&shot, image, NULL},
                           "radius %g: mean %.5f, %.5f at half of it", radii[i], mean, before);
        before = mean;
    }
}

/* Whether a pixel shows the same in both. */
static void find_unchanged(const struct aob_exhibit *a, const struct aob_exhibit *b, bool *unchanged)
{
    for (size_t i = 0; i < aob_exhibit_pixels(a); i++) {
        const float *n = &a->gbuffer.normal[4 * aob_exhibit_place(a, i)],
                    *m = &b->gbuffer.normal[4 * aob_exhibit_place(b, i)];
        unchanged[i] = aob_exhibit_depth(a, i) == aob_exhibit_depth(b, i) && n[0] == m[0] && n[1] == m[1];
    }
}

static void ask_more_occluders(struct aob_trial *trial)
{
    static const double boxes[][3] = {{0.2, 1.2, 0.5}, {-1.2, 1.0, 0.3}, {0.7, 0.9, 1.2}}; /* x, z, height */
    struct aob_shot before = {.exhibit = aob_set_default(trial), .radius = radius};
    const float *wanted = aob_trial_draw(trial, &before);
    for (size_t i = 0; wanted && i < AOB_COUNT(boxes); i++) {
        const double *b = boxes[i];
        struct aob_mesh mesh = {0};
        aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
        aob_mesh_add_box(&mesh, aob_vec(b[0], 0, b[1]), aob_vec(b[0] + 0.4, b[2], b[1] + 0.3), 10);
        const struct aob_exhibit_desc desc = {
            .mesh = &mesh, .camera = aob_still_life_camera(1, aob_vec(0, 0, 0)), .width = 96, .height = 64};
        struct aob_shot shot = {.exhibit = aob_trial_exhibit(trial, &desc), .radius = radius};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        bool *unchanged = aob_trial_mask(trial, shot.exhibit);
        find_unchanged(shot.exhibit, before.exhibit, unchanged);
        struct aob_difference d = aob_difference_of(shot.exhibit, image, wanted, unchanged);
        aob_trial_take(trial, aob_over(d.mean), &(struct aob_seen){&shot, image, wanted},
                       "box at (%g, %g): mean %+.5f", b[0], b[1], d.mean);
    }
}

/* Balls before the sky. */
static void ask_convex_sphere(struct aob_trial *trial)
{
    static const double balls[] = {0.25, 1, 3};
    struct aob_shot shot = {.exhibit = aob_set_plane(trial, &(struct aob_plane_desc){0}), .radius = radius};
    const float *plane = aob_trial_draw(trial, &shot);
    double open = plane ? aob_mean_of(shot.exhibit, plane, NULL) : NAN;
    for (size_t i = 0; i < AOB_COUNT(balls); i++) {
        struct aob_mesh mesh = {0};
        aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), balls[i], 64);
        const struct aob_exhibit_desc desc = {.mesh = &mesh,
                                              .camera = {.eye = {0, balls[i], 4.4 * balls[i]}, .fov_deg = 40},
                                              .width = 64,
                                              .height = 64};
        shot.exhibit = aob_trial_exhibit(trial, &desc);
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_mean_of(shot.exhibit, image, NULL);
        aob_trial_take(trial, aob_over(open - mean), &(struct aob_seen){&shot, image, NULL},
                       "a ball of %g radii: mean %.4f, a plane's %.4f", balls[i] / radius, mean, open);
    }
}

static const char *excuse_no_noise(const struct aob_subject *subject)
{
    bool has = aob_subject_has(subject, "seed") || aob_subject_has(subject, "noise_index");
    return has ? NULL : "it has no seed";
}

static void ask_seed(struct aob_trial *trial)
{
    static const char *const sets[] = {"seed=0 noise_index=0", "seed=1 noise_index=1", "seed=2 noise_index=9",
                                       "seed=3 noise_index=20"};
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = radius};
    double first = NAN;
    for (size_t i = 0; i < AOB_COUNT(sets); i++) {
        shot.set = sets[i];
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_mean_of(shot.exhibit, image, NULL);
        if (i > 0)
            aob_trial_take(trial, fabs(mean - first), &(struct aob_seen){&shot, image, NULL},
                           "%s: mean %.5f, %.5f before", sets[i], mean, first);
        else
            first = mean;
    }
}

const struct aob_property aob_properties_relations[] = {
    {.name = "mirrored",
     .sentence = "A mirrored scene has the mirrored image, apart from noise.",
     .measure = "largest difference of the means of a block of 32 x 32 pixels",
     .source = "https://github.com/o3de/sig-graphics-audio/issues/124",
     .group = AOB_GROUP_RELATIONS,
     .ask = ask_mirrored},
    {.name = "quarter_turn",
     .sentence = "A scene that is turned by 90, 180 and 270 degrees has the turned image, apart from noise.",
     .measure = "largest difference of the means of a block of 32 x 32 pixels",
     .source = "https://github.com/bevyengine/bevy/pull/25334",
     .group = AOB_GROUP_RELATIONS,
     .ask = ask_quarter_turn},
    {.name = "camera_roll",
     .sentence = "A camera that rolls sees each surface as open as before, apart from noise.",
     .measure = "largest difference of the means of a block of 32 x 32 pixels",
     .source = "https://github.com/mrdoob/three.js/pull/33632",
     .group = AOB_GROUP_RELATIONS,
     .ask = ask_camera_roll},
    {.name = "more_radius_darkens",
     .sentence = "A radius twice as large never brightens the mean.",
     .measure = "rise of the mean",
     .source = "https://github.com/playcanvas/engine/pull/9112",
     .group = AOB_GROUP_RELATIONS,
     .quick = true,
     .excuse = aob_excuse_no_radius,
     .ask = ask_more_radius},
    {.name = "more_occluders_darken",
     .sentence = "A box that is put on the floor does not brighten the mean of the pixels that show the same "
                 "as before.",
     .measure = "rise of the mean",
     .source = "docs/stress.md#an-occluder-more",
     .group = AOB_GROUP_RELATIONS,
     .quick = true,
     .ask = ask_more_occluders},
    {.name = "convex_sphere",
     .sentence = "A ball alone is no darker than a plane: nothing of it rises above a tangent plane of it.",
     .measure = "how much darker its mean is",
     .source = "https://github.com/mrdoob/three.js/pull/33632",
     .group = AOB_GROUP_RELATIONS,
     .quick = true,
     .ask = ask_convex_sphere},
    {.name = "shifted_by_tile",
     .sentence = "An orthographic camera that moves by 64 pixels moves the image, apart from noise.",
     .measure = "largest difference of the means of a block of 64 x 64 pixels",
     .source = "https://github.com/playcanvas/engine/pull/4360",
     .group = AOB_GROUP_RELATIONS,
     .ask = ask_shifted_by_tile},
    {.name = "seed_does_not_shift_mean",
     .sentence = "Another seed of the noise leaves the mean of the image.",
     .measure = "difference of the means",
     .source = "docs/stress.md#the-seed",
     .group = AOB_GROUP_RELATIONS,
     .excuse = excuse_no_noise,
     .ask = ask_seed},
    {0},
};
