#include <math.h>
#include "base/memory.h"
#include "depths.h"
#include "groups.h"
#include "sets.h"
#include "views.h"

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
    *shot = (struct aob_shot){.exhibit = aob_set_still_life_at(trial, scale, aob_vec(0, 0, 0), 96, 64),
                              .radius = 0.5 * scale};
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

/* The depth's and the taps' roundings differ, so that a tap may fall on the next texel. */
static void ask_scaled_by_ten(struct aob_trial *trial)
{
    static const double scales[] = {1e-4, 1e-2, 10, 1e4};
    struct aob_shot one, other;
    const float *wanted = draw_scaled(trial, 1, &one);
    for (size_t i = 0; i < AOB_COUNT(scales); i++) {
        const float *image = draw_scaled(trial, scales[i], &other);
        if (!image || !wanted)
            return;
        struct aob_difference d = aob_difference_of(one.exhibit, image, wanted, NULL);
        aob_trial_take(trial, d.rmse, &(struct aob_seen){&other, image, wanted}, "scene times %g", scales[i]);
    }
}

/* From 10 units away a view of 10 degrees sees a plane up to 85 degrees, and a guard band keeps its border away: the radius
 * covers 23 pixels at the nearest place. */
static void ask_tilted(struct aob_trial *trial)
{
    static const double tilts[] = {15, 30, 45, 60, 75, 85};
    struct aob_shot shot = {.radius = 0.5};
    double open = NAN;
    for (int azimuth = -1; azimuth < 8 * (int)AOB_COUNT(tilts); azimuth++) {
        double tilt = azimuth < 0 ? 0 : tilts[azimuth / 8], around = azimuth % 8 * 45.0;
        const struct aob_plane_desc plane = {
            .distance = 10, .fov_deg = 10, .tilt_deg = tilt, .azimuth_deg = around, .guard = 32};
        shot.exhibit = aob_set_plane(trial, &plane);
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        double mean = aob_mean_of(shot.exhibit, image, NULL);
        open = azimuth < 0 ? mean : open;
        aob_trial_take(trial, fabs(mean - open), &(struct aob_seen){&shot, image, NULL},
                       "tilt %g, azimuth %g degrees: mean %.4f, %.4f without", tilt, around, mean, open);
    }
}

const struct aob_property aob_properties_projection[] = {
    {.name = "plane_is_open",
     .sentence = "An open plane that faces the camera is 1.",
     .measure = "distance of the mean from 1",
     .source = "docs/stress.md#o1",
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
    {.name = "scaled_by_ten",
     .sentence = "A scene times a power of ten, 1e-4 to 1e4, has the same image up to rounding.",
     .measure = "root mean square difference",
     .source = "https://github.com/Yellow-Dog-Man/Resonite-Issues/issues/6462",
     .group = AOB_GROUP_PROJECTION,
     .excuse = aob_excuse_no_radius,
     .ask = ask_scaled_by_ten},
    {.name = "moved_far",
     .sentence = "A scene and its camera a million units from the origin have the same image.",
     .measure = "root mean square difference",
     .source = "docs/stress.md#far-from-the-origin",
     .group = AOB_GROUP_PROJECTION,
     .quick = true,
     .ask = aob_views_ask_moved_far},
    {.name = "tilted_plane",
     .sentence = "An open plane is as open at every tilt up to 85 degrees, towards 8 azimuths, as one that "
                 "faces the camera.",
     .measure = "difference of the means",
     .source = "https://github.com/GameTechDev/XeGTAO, its note on very slant angles",
     .group = AOB_GROUP_PROJECTION,
     .ask = ask_tilted},
    {.name = "rotated_to_corner",
     .sentence =
         "A camera that turns leaves every surface as open as before, wherever in the image it comes to lie.",
     .measure = "largest difference of the means of a block of 32 x 32 pixels",
     .source = "https://github.com/bevyengine/bevy, its slice axis is not normalised off-centre",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_views_ask_rotated_to_corner},
    {.name = "crease_to_corner",
     .sentence = "A crease is as dark 60 degrees off the axis as on it, in whatever direction it runs there.",
     .measure = "difference of the means of what both images show",
     .source = "https://github.com/GameTechDev/XeGTAO, slices even about the view vector",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_views_ask_crease_to_corner},
    {.name = "off_centre",
     .sentence = "A shifted frustum shows a crop of the larger symmetric one.",
     .measure = "root mean square difference, what lies in reach of the cut excepted",
     .source = "https://github.com/godotengine/godot/pull/116424",
     .group = AOB_GROUP_PROJECTION,
     .quick = true,
     .ask = aob_views_ask_off_centre},
    {.name = "ortho_like_far",
     .sentence =
         "An orthographic view is that of a perspective camera 1000 units away with a tiny field of view.",
     .measure = "root mean square difference of the pixels that show the same",
     .source = "https://github.com/CueMol/cuemol2/pull/406",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_views_ask_ortho_like_far},
    {.name = "ortho_slides",
     .sentence = "An orthographic camera that slides along its axis, 8 to 512 units away, keeps its image.",
     .measure = "root mean square difference",
     .source = "https://github.com/bevyengine/bevy/issues/13838",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_views_ask_ortho_slides},
    {.name = "reversed_depth",
     .sentence = "A depth buffer, forward or reversed, gives the image of linear floats.",
     .measure = "root mean square difference",
     .source = "https://github.com/godotengine/godot/issues/94139",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_depths_ask_reversed},
    {.name = "reversed_depth_ortho",
     .sentence =
         "A depth buffer of an orthographic view, forward or reversed, gives the image of linear floats.",
     .measure = "root mean square difference",
     .source = "https://github.com/mrdoob/three.js/pull/32799",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_depths_ask_reversed_ortho},
    {.name = "infinite_far",
     .sentence =
         "With the far plane at infinity the sky is 1, and surfaces before it are as with linear floats.",
     .measure = "largest distance of the sky from 1, or the surfaces' root mean square difference",
     .source = "https://github.com/google/filament/issues/6216",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_depths_ask_infinite_far},
    {.name = "half_depth_far",
     .sentence = "Depths in halves serve up to their end, and what lies beyond it is a surface at the end.",
     .measure = "difference of a plane's means, or of a pixel of the still life",
     .source = "https://github.com/GameTechDev/XeGTAO/commit/bc01bd4",
     .group = AOB_GROUP_PROJECTION,
     .excuse = aob_excuse_no_radius,
     .ask = aob_depths_ask_half_far},
    {.name = "far_plane",
     .sentence = "The far plane of a depth buffer, 100 to 1e5, leaves the image.",
     .measure = "root mean square difference from linear floats",
     .source = "https://github.com/turanszkij/WickedEngine/issues/31",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_depths_ask_far_plane},
    {.name = "tiny_near",
     .sentence = "A near plane at a thousandth of the nearest depth leaves the image of a reversed buffer.",
     .measure = "root mean square difference from linear floats",
     .source = "https://github.com/mrdoob/three.js/issues/17865",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_depths_ask_tiny_near},
    {.name = "tiny_near_forward",
     .sentence = "A near plane at a thousandth of the nearest depth makes no stripes, though the buffer runs "
                 "forward.",
     .measure = "root mean square difference from linear floats",
     .source = "https://github.com/mrdoob/three.js/issues/17865",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_depths_ask_tiny_near_forward},
    {.name = "depth_24_bits",
     .sentence =
         "A depth buffer of 24 bits with planes close about the scene gives the image of linear floats.",
     .measure = "root mean square difference",
     .source = "https://github.com/godotengine/godot/pull/53784",
     .group = AOB_GROUP_PROJECTION,
     .ask = aob_depths_ask_24_bits},
    {0},
};
