#include <math.h>
#include <stdio.h>
#include "base/memory.h"
#include "numbers.h"
#include "sets.h"

/* Takes the largest difference of a pixel between two images of one exhibit. */
static void take_same(struct aob_trial *trial, const struct aob_shot *shot, const float *image,
                      const float *wanted, const char *how)
{
    if (!image || !wanted)
        return;
    struct aob_difference d = aob_difference_of(shot->exhibit, image, wanted, NULL);
    aob_trial_take(trial, d.most, &(struct aob_seen){shot, image, wanted}, "%s", how);
}

static struct aob_exhibit *make_scaled(struct aob_trial *trial, double scale)
{
    return aob_set_still_life_at(trial, scale, aob_vec(0, 0, 0), 96, 64);
}

/* Half floats end at 65504: squares of lengths of 256 and depths of 1e5 lie beyond. The scale is a power of two, so that the
 * image is the same to the bit where every number has its place. */
void aob_ask_half_overflow(struct aob_trial *trial)
{
    static const int exponents[] = {9, 15, 17}; /* a radius of 410; depths of 1.4e5 and of 5.6e5 */
    static const char *const sets[] = {NULL, "depth_divisor=2", "depth_divisor=4", "divisor=2"};
    struct aob_shot one = {.exhibit = make_scaled(trial, 1), .radius = 0.8};
    struct aob_shot other = {0};
    for (size_t i = 0; i < AOB_COUNT(exponents) * (trial->quick ? 1 : AOB_COUNT(sets)); i++) {
        int exponent = exponents[i % AOB_COUNT(exponents)];
        char how[80];
        one.set = other.set = sets[i / AOB_COUNT(exponents)];
        snprintf(how, sizeof how, "%s, scene times 2^%d", one.set ? one.set : "as it is", exponent);
        other.exhibit = make_scaled(trial, ldexp(1, exponent));
        other.radius = ldexp(0.8, exponent);
        const float *wanted = aob_trial_draw(trial, &one), *image = aob_trial_draw(trial, &other);
        take_same(trial, &other, image, wanted, how);
    }
}

/* Every frame is a new one, on memory that the one before it gave back; and one is drawn over itself. */
void aob_ask_repeats_itself(struct aob_trial *trial)
{
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.8},
                    plane = {.exhibit = aob_set_plane(
                                 trial, &(struct aob_plane_desc){.tilt_deg = 60, .width = 96, .height = 64}),
                             .radius = 2};
    const float *wanted = aob_trial_draw(trial, &shot);
    take_same(trial, &shot, aob_trial_draw(trial, &shot), wanted, "drawn twice");
    aob_trial_draw(trial, &plane);
    take_same(trial, &shot, aob_trial_draw(trial, &shot), wanted, "drawn after a tilted plane");
    shot.runs = 3;
    take_same(trial, &shot, aob_trial_draw(trial, &shot), wanted, "one frame run three times");
}

void aob_ask_after_other_sizes(struct aob_trial *trial)
{
    static const int sizes[][2] = {{33, 17}, {200, 120}, {1, 1}, {64, 96}};
    static const char *const sets[] = {NULL, "divisor=2", "blur=0", "guard_band=0"};
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.8};
    const float *wanted = aob_trial_draw(trial, &shot);
    for (size_t i = 0; i < AOB_COUNT(sizes); i++) {
        struct aob_plane_desc plane = {.tilt_deg = 45, .width = sizes[i][0], .height = sizes[i][1]};
        const struct aob_shot other = {.exhibit = aob_set_plane(trial, &plane), .radius = 1, .set = sets[i]};
        char how[80];
        aob_trial_draw(trial, &other);
        snprintf(how, sizeof how, "after %dx%d%s%s", sizes[i][0], sizes[i][1], sets[i] ? ", " : "",
                 sets[i] ? sets[i] : "");
        take_same(trial, &shot, aob_trial_draw(trial, &shot), wanted, how);
    }
}

void aob_ask_same_by_storage(struct aob_trial *trial)
{
    struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.8}, stored = shot;
    stored.set = "fetch=storage";
    const float *wanted = aob_trial_draw(trial, &shot);
    take_same(trial, &stored, aob_trial_draw(trial, &stored), wanted, "fetch=storage");
}

/* The slope of the line through the image over the truth: 0 of an image that is black, white, or the same all over; 1 of
 * the truth. */
void aob_ask_drawn_at_all(struct aob_trial *trial)
{
    const struct aob_shot shot = {.exhibit = aob_set_default(trial), .radius = 0.8};
    const float *image = aob_trial_draw(trial, &shot), *truth = aob_trial_trace(trial, shot.exhibit, 0.8, 64);
    if (!image || !truth)
        return;
    double mean = aob_mean_of(shot.exhibit, image, NULL), open = aob_mean_of(shot.exhibit, truth, NULL);
    double both = 0, square = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(shot.exhibit); i++)
        if (aob_exhibit_is_surface(shot.exhibit, i)) {
            double v = (double)truth[i] - open;
            both += v * ((double)image[i] - mean);
            square += v * v;
        }
    aob_trial_take(trial, aob_over(1 - both / square), &(struct aob_seen){&shot, image, truth},
                   "%.0f %% of the truth's contrast; its mean is %.4f, the truth's %.4f", 100 * both / square,
                   mean, open);
}

/* In the crease of a corner, close before a wall, alone under the sky, and in images of one pixel and of one row. */
static struct aob_exhibit *make_set(struct aob_trial *trial, size_t k)
{
    static const struct aob_plane_desc planes[] = {{.tilt_deg = 0},
                                                   {.tilt_deg = 60},
                                                   {.tilt_deg = 85, .azimuth_deg = 90},
                                                   {.distance = 0.01},
                                                   {.distance = 1e4},
                                                   {.width = 1, .height = 1},
                                                   {.width = 37, .height = 1},
                                                   {.width = 2, .height = 53},
                                                   {.fov_deg = 150},
                                                   {.fov_deg = 1}};
    struct aob_mesh mesh = {0};
    struct aob_exhibit_desc desc = {.mesh = &mesh, .width = 96, .height = 64};
    if (k < AOB_COUNT(planes))
        return aob_set_plane(trial, &planes[k]);
    switch (k - AOB_COUNT(planes)) {
    case 0:
        return aob_set_default(trial);
    case 1: /* so near that no pixel is of the wall alone */
        aob_set_corner(&mesh, 20);
        desc.camera = (struct aob_camera){.eye = {0, 0.02, 0.02}, .target = {0, 0.005, 0}, .fov_deg = 90};
        return aob_trial_exhibit(trial, &desc);
    case 2:
        aob_mesh_add_sphere(&mesh, aob_vec(0, 0, 0), 0.5, 16);
        desc.camera = (struct aob_camera){.eye = {0, 0.3, 4}, .fov_deg = 40};
        return aob_trial_exhibit(trial, &desc);
    case 3:
        aob_set_corner(&mesh, 20);
        desc.camera = (struct aob_camera){.eye = {0, 4, 4}, .fov_deg = 20};
        return aob_trial_exhibit(trial, &desc);
    default:
        return NULL;
    }
}

void aob_ask_finite_everywhere(struct aob_trial *trial)
{
    static const double radii[] = {0.01, 0.5, 5};
    static const char *const sets[] = {NULL, "blur=0"};
    struct aob_shot shot = {0};
    for (size_t k = 0; (shot.exhibit = make_set(trial, k)); k++)
        for (size_t i = 0; i < AOB_COUNT(radii) * AOB_COUNT(sets); i++) {
            shot.radius = radii[i / 2];
            shot.set = sets[i % 2];
            const float *image = aob_trial_draw(trial, &shot);
            aob_trial_take(trial, 0, &(struct aob_seen){&shot, image, NULL}, "set %zu, radius %g%s", k,
                           shot.radius, shot.set ? ", without blur" : "");
        }
}
