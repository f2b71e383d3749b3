#include <math.h>
#include "base/memory.h"
#include "groups.h"
#include "sets.h"

/* What a technique gives where nothing occludes: 1 by most definitions, another constant by some. So planes are compared with
 * one that faces the camera; `plane_is_open` holds that one to 1. */
static double draw_plane(struct aob_trial *trial, const struct aob_plane_desc *plane, struct aob_shot *shot,
                         float **image)
{
    *shot = (struct aob_shot){.exhibit = aob_set_plane(trial, plane), .radius = 0.5};
    *image = aob_trial_draw(trial, shot);
    return *image ? aob_mean_of(shot->exhibit, *image, NULL) : NAN;
}

static void ask_open(struct aob_trial *trial)
{
    struct aob_shot shot;
    float *image;
    double open = draw_plane(trial, &(struct aob_plane_desc){0}, &shot, &image);
    aob_trial_take(trial, fabs(1 - open), &(struct aob_seen){&shot, image, NULL}, "its mean is %.4f", open);
}

static void ask_any_fov(struct aob_trial *trial)
{
    static const double fovs[] = {5, 20, 90, 120, 150};
    struct aob_shot shot;
    float *image;
    double open = draw_plane(trial, &(struct aob_plane_desc){0}, &shot, &image);
    for (size_t i = 0; i < AOB_COUNT(fovs); i++) {
        double mean = draw_plane(trial, &(struct aob_plane_desc){.fov_deg = fovs[i]}, &shot, &image);
        aob_trial_take(trial, fabs(mean - open), &(struct aob_seen){&shot, image, NULL},
                       "field of view %g degrees: mean %.4f, %.4f at 60", fovs[i], mean, open);
    }
}

/* The still life at another scale, seen by a camera that was scaled with it; lengths of the technique as well. */
static const float *draw_scaled(struct aob_trial *trial, double scale, struct aob_shot *shot)
{
    struct aob_mesh mesh = {0};
    aob_set_still_life(&mesh, scale, aob_vec(0, 0, 0));
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh, .camera = aob_still_life_camera(scale, aob_vec(0, 0, 0)), .width = 96, .height = 64};
    *shot = (struct aob_shot){.exhibit = aob_trial_exhibit(trial, &desc), .radius = 0.8 * scale};
    return aob_trial_draw(trial, shot);
}

/* Powers of two leave every bit of a float's mantissa alone, so that only a length of its own can show. */
static void ask_scaled_by_two(struct aob_trial *trial)
{
    static const int exponents[] = {-13, -6, 6, 13}; /* 1.2e-4 .. 8192 */
    struct aob_shot one, other;
    const float *wanted = draw_scaled(trial, 1, &one);
    for (size_t i = 0; i < AOB_COUNT(exponents); i++) {
        const float *image = draw_scaled(trial, ldexp(1, exponents[i]), &other);
        if (!image || !wanted)
            return;
        struct aob_difference d = aob_difference_of(one.exhibit, image, wanted, NULL);
        aob_trial_take(trial, d.most, &(struct aob_seen){&other, image, wanted}, "scene times 2^%d",
                       exponents[i]);
    }
}

const struct aob_property aob_properties_projection[] = {
    {.name = "plane_is_open",
     .sentence = "An open plane that faces the camera is 1.",
     .measure = "distance of the mean from 1",
     .source = "docs/stress.md, oracle 1",
     .group = AOB_GROUP_PROJECTION,
     .quick = true,
     .ask = ask_open},
    {.name = "plane_any_fov",
     .sentence = "An open plane is as open at every field of view from 5 to 150 degrees as at 60.",
     .measure = "difference of the means",
     .source = "https://github.com/hzqst/MetaHookSv/issues/42",
     .group = AOB_GROUP_PROJECTION,
     .quick = true,
     .ask = ask_any_fov},
    {.name = "scaled_by_two",
     .sentence = "A scene times a power of two, lengths of the technique too, has the same image.",
     .measure = "largest difference of a pixel",
     .source = "https://github.com/Yellow-Dog-Man/Resonite-Issues/issues/6462",
     .group = AOB_GROUP_PROJECTION,
     .quick = true,
     .excuse = aob_excuse_no_radius,
     .ask = ask_scaled_by_two},
    {0},
};
