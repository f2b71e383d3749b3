#include "views.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "match.h"
#include "sets.h"

static const double radius = 0.5;

/* The still life, moved, before a camera. */
static struct aob_exhibit *still_life(struct aob_trial *trial, struct aob_vec3 move,
                                      const struct aob_camera *camera)
{
    struct aob_mesh mesh = {0};
    aob_set_still_life(&mesh, 1, move);
    const struct aob_exhibit_desc desc = {.mesh = &mesh, .camera = *camera, .width = 96, .height = 64};
    return aob_trial_exhibit(trial, &desc);
}

static const float *draw_still_life(struct aob_trial *trial, struct aob_vec3 move,
                                    const struct aob_camera *camera, struct aob_shot *shot)
{
    *shot = (struct aob_shot){.exhibit = still_life(trial, move, camera), .radius = radius};
    return aob_trial_draw(trial, shot);
}

void aob_views_ask_moved_far(struct aob_trial *trial)
{
    static const struct aob_vec3 moves[] = {{1e6, 0, 0}, {-1e6, 3e5, 1e6}};
    struct aob_camera camera = aob_still_life_camera(1, aob_vec(0, 0, 0));
    struct aob_shot shot, own;
    const float *wanted = draw_still_life(trial, aob_vec(0, 0, 0), &camera, &own);
    for (size_t i = 0; i < AOB_COUNT(moves); i++) {
        camera = aob_still_life_camera(1, moves[i]);
        const float *image = draw_still_life(trial, moves[i], &camera, &shot);
        if (!image || !wanted)
            return;
        aob_trial_take(trial, aob_difference_of(own.exhibit, image, wanted, NULL).rmse,
                       &(struct aob_seen){&shot, image, wanted}, "moved by (%g, %g, %g)", moves[i].x,
                       moves[i].y, moves[i].z);
    }
}

/* The still life's camera, so far from what it looks at, and orthographic with 3 units of height. */
static struct aob_camera far_camera(double distance, bool perspective)
{
    struct aob_camera camera = aob_still_life_camera(1, aob_vec(0, 0, 0));
    camera.eye = aob_vec_add(camera.target, aob_vec_scale(aob_camera_axes(&camera).back, distance));
    camera.ortho_height = perspective ? 0 : 3;
    camera.fov_deg = 2 * atan(1.5 / distance) * 180 / M_PI;
    return camera;
}

/* From 1000 units what lies 5 before the target is 1/200 larger: at the image's corner, 58 pixels out, a third of one. */
void aob_views_ask_ortho_like_far(struct aob_trial *trial)
{
    struct aob_camera perspective = far_camera(1000, true), ortho = far_camera(1000, false);
    struct aob_shot shot, own;
    const float *far = draw_still_life(trial, aob_vec(0, 0, 0), &perspective, &own);
    const float *image = draw_still_life(trial, aob_vec(0, 0, 0), &ortho, &shot);
    if (!far || !image)
        return;
    float *wanted = aob_trial_image(trial, shot.exhibit);
    bool *seen = aob_trial_mask(trial, shot.exhibit);
    aob_match_fetch(&(struct aob_match){shot.exhibit, own.exhibit, aob_motion_none}, far, wanted, seen);
    struct aob_difference d = aob_difference_of(shot.exhibit, image, wanted, seen);
    aob_trial_take(trial, 2 * d.count > aob_exhibit_pixels(shot.exhibit) ? d.rmse : NAN,
                   &(struct aob_seen){&shot, image, wanted}, "%zu pixels, mean %+.4f", d.count, d.mean);
}

/* Gives an exhibit what another shows, `by` units farther away. Rays from elsewhere are rounded otherwise, and a pixel of an
 * outline that meets another surface would be all that is seen. */
static void slide(struct aob_exhibit *exhibit, const struct aob_exhibit *from, double by)
{
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        exhibit->gbuffer.depth[i] = (float)((double)from->gbuffer.depth[i] + by);
    memcpy(exhibit->gbuffer.normal, from->gbuffer.normal, 4 * sizeof(float) * aob_exhibit_pixels(exhibit));
}

void aob_views_ask_ortho_slides(struct aob_trial *trial)
{
    static const double distances[] = {8, 10, 16, 64, 512};
    struct aob_exhibit *first = NULL;
    const float *wanted = NULL;
    for (size_t i = 0; i < AOB_COUNT(distances); i++) {
        struct aob_camera camera = far_camera(distances[i], false);
        struct aob_exhibit *exhibit = still_life(trial, aob_vec(0, 0, 0), &camera);
        if (exhibit && first)
            slide(exhibit, first, distances[i] - distances[0]);
        const struct aob_shot shot = {.exhibit = exhibit, .radius = radius};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        first = first ? first : exhibit;
        wanted = wanted ? wanted : image;
        aob_trial_take(trial, aob_difference_of(first, image, wanted, NULL).rmse,
                       &(struct aob_seen){&shot, image, wanted}, "seen from %g units in place of 8",
                       distances[i]);
    }
}

/* A symmetric image of 192 x 128 pixels and its upper left 128 x 96, whose axis lies at the same pixel. What is more than 40
 * pixels from the right and the lower border sees nothing of what was cut off. */
enum { WIDE = 192, HIGH = 128, CUT_WIDE = 128, CUT_HIGH = 96, REACH = 40 };

static struct aob_camera cropped(const struct aob_camera *whole)
{
    struct aob_camera crop = *whole;
    double slope = tan(whole->fov_deg * M_PI / 360) * CUT_HIGH / HIGH;
    crop.fov_deg = 2 * atan(slope) * 180 / M_PI;
    crop.shift[0] = (CUT_WIDE - WIDE) / (2.0 * CUT_HIGH);
    crop.shift[1] = (HIGH - CUT_HIGH) / (2.0 * CUT_HIGH);
    return crop;
}

void aob_views_ask_off_centre(struct aob_trial *trial)
{
    struct aob_camera whole = aob_still_life_camera(1, aob_vec(0, 0, 0)), crop = cropped(&whole);
    struct aob_mesh mesh = {0}, again = {0};
    aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
    aob_set_still_life(&again, 1, aob_vec(0, 0, 0));
    const struct aob_exhibit_desc wide = {.mesh = &mesh, .camera = whole, .width = WIDE, .height = HIGH},
                                  cut = {
                                      .mesh = &again, .camera = crop, .width = CUT_WIDE, .height = CUT_HIGH};
    struct aob_shot own = {.exhibit = aob_trial_exhibit(trial, &wide), .radius = radius},
                    shot = {.exhibit = aob_trial_exhibit(trial, &cut), .radius = radius};
    const float *larger = aob_trial_draw(trial, &own), *image = aob_trial_draw(trial, &shot);
    if (!larger || !image)
        return;
    float *wanted = aob_trial_image(trial, shot.exhibit);
    bool *inner = aob_trial_mask(trial, shot.exhibit);
    for (size_t y = 0; y < CUT_HIGH; y++)
        for (size_t x = 0; x < CUT_WIDE; x++) {
            wanted[y * CUT_WIDE + x] = larger[y * WIDE + x];
            inner[y * CUT_WIDE + x] = x + REACH < CUT_WIDE && y + REACH < CUT_HIGH;
        }
    struct aob_difference d = aob_difference_of(shot.exhibit, image, wanted, inner);
    aob_trial_take(trial, d.rmse, &(struct aob_seen){&shot, image, wanted}, "pixel (%zu, %zu) is off by %.4f",
                   d.at % CUT_WIDE, d.at / CUT_WIDE, d.most);
}

/* The camera looks past the still life, which so moves from the middle towards a corner of the image. */
static struct aob_camera looking_past(double right, double up)
{
    struct aob_camera camera = aob_still_life_camera(1, aob_vec(0, 0, 0));
    struct aob_frame_axes axes = aob_camera_axes(&camera);
    double distance = aob_vec_length(aob_vec_sub(camera.target, camera.eye));
    camera.target = aob_vec_add(camera.target, aob_vec_add(aob_vec_scale(axes.right, right * distance),
                                                           aob_vec_scale(axes.up, up * distance)));
    camera.fov_deg = 75;
    return camera;
}

/* Tangents of the angles by which it looks past; the image reaches 1.15 and .77 from its middle. */
void aob_views_ask_rotated_to_corner(struct aob_trial *trial)
{
    static const double past[][2] = {{0.5, 0.3}, {-0.5, 0.3}, {0.5, -0.3}, {-0.5, -0.3}};
    enum { WIDTH = 192, HEIGHT = 128, GUARD = 32, BLOCK = 32 };
    struct aob_shot shots[2];
    const float *images[2];
    for (size_t i = 0; i < AOB_COUNT(past); i++) {
        for (int k = 0; k < 2; k++) {
            struct aob_mesh mesh = {0};
            aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
            const struct aob_exhibit_desc desc = {.mesh = &mesh,
                                                  .camera = looking_past(k * past[i][0], k * past[i][1]),
                                                  .width = WIDTH,
                                                  .height = HEIGHT,
                                                  .guard = GUARD};
            shots[k] = (struct aob_shot){
                .exhibit = aob_trial_exhibit(trial, &desc), .radius = radius, .set = "samples=64"};
            images[k] = aob_trial_draw(trial, &shots[k]);
        }
        if (!images[0] || !images[1])
            return;
        size_t at;
        float *wanted = aob_trial_image(trial, shots[0].exhibit);
        bool *seen = aob_trial_mask(trial, shots[0].exhibit);
        aob_match_fetch(&(struct aob_match){shots[0].exhibit, shots[1].exhibit, aob_motion_none}, images[1],
                        wanted, seen);
        double worst = aob_match_blocks(shots[0].exhibit, images[0], wanted, seen, BLOCK, &at);
        aob_trial_take(trial, worst, &(struct aob_seen){&shots[0], images[0], wanted},
                       "looking past it by (%g, %g), block at (%zu, %zu)", past[i][0], past[i][1], at % WIDTH,
                       at / WIDTH);
    }
}

/* An endless crease between floor and wall, 2 units before the eye. The camera looks past it by these tangents, and its frustum
 * is shifted so that the image shows the same of the crease wherever its axis lies. */
static struct aob_exhibit *crease_beside_axis(struct aob_trial *trial, const double past[2], double fov_deg)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, M_SQRT2, M_SQRT2}, .fov_deg = fov_deg};
    struct aob_frame_axes axes = aob_camera_axes(&camera);
    camera.target = aob_vec_add(aob_vec_scale(axes.right, 2 * past[0]), aob_vec_scale(axes.up, 2 * past[1]));
    axes = aob_camera_axes(&camera);
    double height = 2 * tan(fov_deg * M_PI / 360) * aob_vec_dot(camera.eye, axes.back);
    camera.shift[0] = -aob_vec_dot(camera.eye, axes.right) / height;
    camera.shift[1] = -aob_vec_dot(camera.eye, axes.up) / height;
    aob_set_corner(&mesh, 200);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh, .camera = camera, .width = 96, .height = 64, .guard = 32};
    return aob_trial_exhibit(trial, &desc);
}

/* The tangent of 60 degrees, towards four sides. On the axis the radius covers 27 pixels; there, where an image is as wide for
 * twice the tangent, 25 to 50. */
void aob_views_ask_crease_to_corner(struct aob_trial *trial)
{
    static const double none[2] = {0, 0}, past[][2] = {{1.73, 0}, {0, 1.73}, {1.22, 1.22}, {-1.22, 1.22}};
    struct aob_shot own = {
        .exhibit = crease_beside_axis(trial, none, 33), .radius = radius, .set = "samples=64"};
    const float *drawn = aob_trial_draw(trial, &own);
    for (size_t i = 0; i < AOB_COUNT(past); i++) {
        struct aob_shot shot = own;
        shot.exhibit = crease_beside_axis(trial, past[i], 66);
        const float *image = aob_trial_draw(trial, &shot);
        if (!drawn || !image)
            return;
        float *wanted = aob_trial_image(trial, shot.exhibit);
        bool *seen = aob_trial_mask(trial, shot.exhibit);
        aob_match_fetch(&(struct aob_match){shot.exhibit, own.exhibit, aob_motion_none}, drawn, wanted, seen);
        struct aob_difference d = aob_difference_of(shot.exhibit, image, wanted, seen);
        aob_trial_take(trial, 2 * d.count > aob_exhibit_pixels(shot.exhibit) ? fabs(d.mean) : NAN,
                       &(struct aob_seen){&shot, image, wanted},
                       "looking past it by (%g, %g): %zu pixels, mean %+.4f", past[i][0], past[i][1], d.count,
                       d.mean);
    }
}
