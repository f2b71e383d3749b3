#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "groups.h"
#include "sets.h"

static struct aob_exhibit *show(struct aob_trial *trial, struct aob_mesh *mesh,
                                const struct aob_camera *camera, int width, int height)
{
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){.mesh = mesh, .camera = *camera, .width = width, .height = height});
}

/* --- The image's border ------------------------------------------------------------------------------------- */

/* Makes the small exhibit show the top left part of what the large one shows, to the bit and at the same places, so that
 * the noise of its pixels is the same. */
static void crop(struct aob_exhibit *small, const struct aob_exhibit *large)
{
    struct aob_gbuffer *to = &small->gbuffer;
    const struct aob_gbuffer *from = &large->gbuffer;
    size_t width = (size_t)small->width;
    for (size_t y = 0; y < (size_t)small->height; y++) {
        size_t source = y * (size_t)large->width, target = y * width;
        memcpy(&to->depth[target], &from->depth[source], width * sizeof *to->depth);
        memcpy(&to->normal[4 * target], &from->normal[4 * source], 4 * width * sizeof *to->normal);
        memcpy(&to->shading[4 * target], &from->shading[4 * source], 4 * width * sizeof *to->shading);
    }
    to->projection = from->projection;
    to->projection.width = small->width;
    to->projection.height = small->height;
}

/* The camera looks past the still life, which stands in the top left part of the image: that is what is compared. */
static struct aob_exhibit *show_still_life(struct aob_trial *trial, int width, int height)
{
    struct aob_mesh mesh = {0};
    const struct aob_camera camera = {.eye = {1.2, 1.7, 3.6}, .target = {1.3, -0.3, 0}, .fov_deg = 50};
    aob_set_still_life(&mesh, 1, aob_vec(0, 0, 0));
    return show(trial, &mesh, &camera, width, height);
}

/* Pixels of the small image whose ball of that radius, and the widest filter's reach beside it, stay within the image. Two
 * passes of 13 taps at a quarter of the size reach 48 pixels. */
static bool *inner_pixels(struct aob_trial *trial, const struct aob_exhibit *small, double radius)
{
    bool *mask = aob_trial_mask(trial, small);
    double nearest = INFINITY, across = small->gbuffer.projection.sy;
    for (size_t i = 0; i < aob_exhibit_pixels(small); i++)
        nearest = fmin(nearest, (double)aob_exhibit_depth(small, i));
    /* Towards the image's corners a ball is up to a third longer in the image. */
    double reach = 1.3 * radius / ((nearest - radius) * across) + 48;
    for (int y = 0; y < small->height - reach; y++)
        for (int x = 0; x < small->width - reach; x++)
            mask[y * small->width + x] = true;
    return mask;
}

static void ask_crop(struct aob_trial *trial)
{
    struct aob_shot whole = {.exhibit = show_still_life(trial, 288, 216), .radius = 0.25}, part = whole;
    struct aob_exhibit *small = show_still_life(trial, 224, 180);
    if (!whole.exhibit || !small)
        return;
    crop(small, whole.exhibit);
    part.exhibit = small;
    const float *larger = aob_trial_draw(trial, &whole), *image = aob_trial_draw(trial, &part);
    if (!larger || !image)
        return;
    float *wanted = aob_trial_image(trial, small);
    for (int y = 0; y < small->height; y++)
        memcpy(&wanted[y * small->width], &larger[y * whole.exhibit->width],
               (size_t)small->width * sizeof *wanted);
    struct aob_difference d =
        aob_difference_of(small, image, wanted, inner_pixels(trial, small, whole.radius));
    aob_trial_take(trial, d.most, &(struct aob_seen){&part, image, wanted},
                   "pixel (%d, %d) of %dx%d, cut out of %dx%d", (int)d.at % small->width,
                   (int)d.at / small->width, small->width, small->height, whole.exhibit->width,
                   whole.exhibit->height);
}

/* Mean of the pixels x0..x1-1, y0..y1-1. */
static double mean_of_part(struct aob_trial *trial, const struct aob_exhibit *exhibit, const float *image,
                           const int part[4])
{
    bool *mask = aob_trial_mask(trial, exhibit);
    for (int y = part[1]; y < part[3]; y++)
        for (int x = part[0]; x < part[2]; x++)
            mask[y * exhibit->width + x] = true;
    return aob_mean_of(exhibit, image, mask);
}

/* A strip is four pixels wide: the tile of noise of every technique, or of a part of it. */
static void take_borders(struct aob_trial *trial, const struct aob_shot *shot, const float *image,
                         const char *which)
{
    static const char *const names[] = {"left", "right", "top", "bottom"};
    const struct aob_exhibit *e = shot->exhibit;
    int w = e->width, h = e->height;
    const int strips[][4] = {{0, 0, 4, h}, {w - 4, 0, w, h}, {0, 0, w, 4}, {0, h - 4, w, h}};
    double inside = mean_of_part(trial, e, image, (const int[]){w / 4, h / 4, w - w / 4, h - h / 4});
    for (size_t i = 0; i < AOB_COUNT(strips); i++) {
        double strip = mean_of_part(trial, e, image, strips[i]);
        aob_trial_take(trial, fabs(strip - inside), &(struct aob_seen){shot, image, NULL},
                       "plane %s: mean of the four %smost rows or columns %.4f, inside %.4f", which, names[i],
                       strip, inside);
    }
}

static void ask_border(struct aob_trial *trial)
{
    static const struct {
        const char *which;
        double tilt, azimuth;
    } planes[] = {{"facing", 0, 0},
                  {"tilted right", 40, 0},
                  {"tilted up", 40, 90},
                  {"tilted left", 40, 180},
                  {"tilted down", 40, 270}};
    for (size_t i = 0; i < AOB_COUNT(planes); i++) {
        const struct aob_plane_desc plane = {
            .tilt_deg = planes[i].tilt, .azimuth_deg = planes[i].azimuth, .width = 64, .height = 64};
        struct aob_shot shot = {.exhibit = aob_set_plane(trial, &plane), .radius = 0.5};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        take_borders(trial, &shot, image, planes[i].which);
    }
}

/* --- The sky ------------------------------------------------------------------------------------------------ */

/* Floor, box and ball before the sky, from a child's height. */
static struct aob_exhibit *show_horizon(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-20, 0, 20), aob_vec(40, 0, 0), aob_vec(0, 0, -40));
    aob_mesh_add_box(&mesh, aob_vec(-1.2, 0, -0.5), aob_vec(-0.3, 1.5, 0.4), 25);
    aob_mesh_add_sphere(&mesh, aob_vec(0.8, 1.1, 0.2), 0.5, 32);
    const struct aob_camera camera = {.eye = {0, 0.9, 3.6}, .target = {0, 0.9, 0}, .fov_deg = 50};
    return show(trial, &mesh, &camera, 96, 64);
}

static void take_sky(struct aob_trial *trial, const struct aob_shot *shot, const float *image)
{
    const struct aob_exhibit *e = shot->exhibit;
    size_t at = 0;
    double most = NAN;
    for (size_t i = 0; i < aob_exhibit_pixels(e); i++) {
        double off = fabs(1 - (double)image[i]);
        if (aob_exhibit_is_surface(e, i) || off <= most)
            continue;
        most = off;
        at = i;
    }
    aob_trial_take(trial, most, &(struct aob_seen){shot, image, NULL},
                   "radius %g, sky in pixel (%d, %d) is %g", shot->radius, (int)at % e->width,
                   (int)at / e->width, (double)image[at]);
}

static void ask_sky(struct aob_trial *trial)
{
    static const double radii[] = {0.1, 0.5, 2, 50};
    static const char *const sets[] = {NULL, "divisor=2"};
    struct aob_exhibit *horizon = show_horizon(trial);
    for (size_t s = 0; s < (trial->quick ? 1 : AOB_COUNT(sets)); s++)
        for (size_t i = 0; i < AOB_COUNT(radii); i++) {
            struct aob_shot shot = {.exhibit = horizon, .radius = radii[i], .set = sets[s]};
            const float *image = aob_trial_draw(trial, &shot);
            if (!image)
                return;
            take_sky(trial, &shot, image);
        }
}

/* The mesh lies behind the camera. */
static void ask_sky_only(struct aob_trial *trial)
{
    static const int widths[] = {48, 49};
    const struct aob_camera camera = {.eye = {0, 0, 4}, .target = {0, 0, 8}, .fov_deg = 60};
    for (size_t i = 0; i < AOB_COUNT(widths); i++) {
        struct aob_mesh mesh = {0};
        aob_mesh_add_box(&mesh, aob_vec(-1, -1, -1), aob_vec(1, 1, 1), 0);
        struct aob_shot shot = {.exhibit = show(trial, &mesh, &camera, widths[i], 32), .radius = 0.5};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        take_sky(trial, &shot, image);
    }
}

/* A plate of that size about the origin, turned from facing the camera about the y axis. */
static struct aob_exhibit *show_plate(struct aob_trial *trial, double size, double turn_deg)
{
    double t = turn_deg * M_PI / 180;
    struct aob_vec3 u = aob_vec_scale(aob_vec(cos(t), 0, -sin(t)), size), v = aob_vec(0, size, 0);
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec_scale(aob_vec_add(u, v), -0.5), u, v);
    return show(trial, &mesh, &(struct aob_camera){.eye = {0, 0, 3}, .fov_deg = 60}, 64, 48);
}

/* How much a pixel of a mask is darker than wanted, at most. */
static void take_darker(struct aob_trial *trial, const struct aob_shot *shot, const float *image,
                        const float *wanted, double turn_deg)
{
    const struct aob_exhibit *e = shot->exhibit;
    double most = NAN;
    size_t at = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(e); i++) {
        double darker = (double)wanted[i] - (double)image[i];
        if (!aob_exhibit_is_surface(e, i) || darker <= most)
            continue;
        most = darker;
        at = i;
    }
    aob_trial_take(trial, most < 0 ? 0 : most, &(struct aob_seen){shot, image, wanted},
                   "plate turned by %g degrees: pixel (%d, %d) is %.4f, amid the plane %.4f", turn_deg,
                   (int)at % e->width, (int)at / e->width, (double)image[at], (double)wanted[at]);
}

static void ask_rim(struct aob_trial *trial)
{
    static const double turns[] = {0, 30, 55};
    for (size_t i = 0; i < AOB_COUNT(turns); i++) {
        struct aob_shot plate = {.exhibit = show_plate(trial, 1.5, turns[i]), .radius = 0.5},
                        plane = {.exhibit = show_plate(trial, 400, turns[i]), .radius = 0.5};
        const float *image = aob_trial_draw(trial, &plate), *wanted = aob_trial_draw(trial, &plane);
        if (!image || !wanted)
            return;
        take_darker(trial, &plate, image, wanted, turns[i]);
    }
}

const struct aob_property aob_properties_edges[] = {
    {.name = "guard_crop",
     .sentence = "What is farther than the radius and the filters from the image's border does not depend on "
                 "what lies beyond it.",
     .measure = "largest difference of a pixel",
     .source = "https://github.com/keijiro/MiniEngineAO/issues/6",
     .group = AOB_GROUP_EDGES,
     .excuse = aob_excuse_no_radius,
     .ask = ask_crop},
    {.name = "border_is_open",
     .sentence = "Border rows and columns of an open plane, tilted too, are as open as its middle.",
     .measure = "difference of the means of a strip and of the middle",
     .source = "https://github.com/godotengine/godot/issues/9678",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .ask = ask_border},
    {.name = "sky_is_open",
     .sentence = "The sky is 1, whatever stands before it.",
     .measure = "largest distance of a sky pixel from 1",
     .source = "https://github.com/N8python/n8ao/issues/51",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .ask = ask_sky},
    {.name = "sky_only",
     .sentence = "An image of sky alone is 1.",
     .measure = "largest distance of a pixel from 1",
     .source = "https://github.com/google/filament/issues/6216",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .ask = ask_sky_only},
    {.name = "sky_rim",
     .sentence = "A plate before the sky is nowhere darker than the same pixels of a plane.",
     .measure = "largest darkening of a pixel",
     .source = "https://github.com/OurMachinery/themachinery-public/issues/1008",
     .group = AOB_GROUP_EDGES,
     .quick = true,
     .ask = ask_rim},
    {0},
};
