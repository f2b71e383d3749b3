#include <math.h>
#include "base/memory.h"
#include "resolution.h"
#include "sets.h"

struct aob_camera aob_resolution_camera(int height)
{
    double half = tan(30 * M_PI / 180) / 64 * height;
    return (struct aob_camera){.eye = {0, 0, 3}, .fov_deg = 2 * atan(half) * 180 / M_PI};
}

void aob_resolution_wall(struct aob_mesh *mesh)
{
    aob_mesh_add_quad(mesh, aob_vec(-500, -500, 0), aob_vec(1000, 0, 0), aob_vec(0, 1000, 0));
}

double aob_resolution_darkest(const struct aob_exhibit *exhibit, const float *image, const bool *mask)
{
    double least = INFINITY;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++)
        if (aob_exhibit_is_surface(exhibit, i) && (!mask || mask[i]))
            least = fmin(least, (double)image[i]);
    return isfinite(least) ? least : NAN;
}

/* A tilted plane, so that a read of another texel than the one that was meant shows. */
static float *draw_plane(struct aob_trial *trial, int width, int height, const char *set,
                         struct aob_shot *shot)
{
    struct aob_plane_desc plane = {.width = width,
                                   .height = height,
                                   .fov_deg = aob_resolution_camera(height).fov_deg,
                                   .tilt_deg = 30,
                                   .azimuth_deg = 30};
    *shot = (struct aob_shot){.exhibit = aob_set_plane(trial, &plane), .radius = 0.5, .set = set};
    return aob_trial_draw(trial, shot);
}

/* A filter gives a mean of what it reads. So no pixel of a small image, however few neighbours it has, is darker than the
 * darkest of a large one before the filters. Brighter it may be: what lies outside the image occludes nothing, and where
 * the open plane is less than 1 by definition, as of an obscurance of whole balls, an image of a pixel is white with reason. */
static double darkest_of_large(struct aob_trial *trial)
{
    struct aob_shot shot;
    const float *image = draw_plane(trial, 96, 96, "divisor=1 blur=0", &shot);
    return image ? aob_resolution_darkest(shot.exhibit, image, NULL) : NAN;
}

static void ask_size(struct aob_trial *trial, int width, int height, const char *set, double large)
{
    struct aob_shot shot;
    const float *image = draw_plane(trial, width, height, set, &shot);
    if (image) {
        double darkest = aob_resolution_darkest(shot.exhibit, image, NULL);
        aob_trial_take(trial, aob_over(large - darkest), &(struct aob_seen){&shot, image, NULL},
                       "%dx%d %s: darkest pixel %.4f, %.4f of a large image", width, height, set ? set : "",
                       darkest, large);
    }
    aob_trial_clear(trial);
}

void aob_ask_sizes_thin(struct aob_trial *trial)
{
    static const int narrow[] = {1, 7}, wide[] = {2, 64, 97};
    double large = darkest_of_large(trial);
    for (int a = 1; a <= 96; a += trial->quick ? 19 : 1) {
        for (size_t k = 0; k < AOB_COUNT(narrow); k++) {
            ask_size(trial, a, narrow[k], NULL, large);
            ask_size(trial, narrow[k], a, NULL, large);
        }
        for (size_t k = 0; k < AOB_COUNT(wide) && !trial->quick && a % 7 == 1; k++) {
            ask_size(trial, a, wide[k], NULL, large);
            ask_size(trial, wide[k], a, NULL, large);
        }
    }
}

/* Drivers in software compile a text again for sides of a power of two, so few sizes of a low image are such. */
void aob_ask_sizes_half(struct aob_trial *trial)
{
    enum { ACROSS = 11 };
    static const int sides[] = {1, 3, 5, 6, 9, 10, 11, 12, 17, 18, 19, 20, 33, 34, 35, 36, 65, 66, 67, 68};
    double large = darkest_of_large(trial);
    ask_size(trial, 1, 1, "divisor=4", large);
    for (size_t k = 0; k < AOB_COUNT(sides); k++) {
        bool low_power = sides[k] < 9;
        for (int s = low_power ? 1 : 0; s < 2; s++) {
            const char *set = s ? "divisor=4" : "divisor=2";
            ask_size(trial, sides[k], ACROSS, set, large);
            ask_size(trial, ACROSS, sides[k], set, large);
        }
    }
}

/* Two walls of a corner whose crease runs across the image (upright: from top to bottom), so that all lines which cross it
 * show the same. */
static struct aob_exhibit *corner_of(struct aob_trial *trial, int width, int height, bool upright)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, upright ? aob_vec(0, -20, 0) : aob_vec(-20, 0, 0),
                      upright ? aob_vec(20, 0, 0) : aob_vec(40, 0, 0),
                      upright ? aob_vec(0, 40, 0) : aob_vec(0, 20, 0));
    aob_mesh_add_quad(&mesh, upright ? aob_vec(0, -20, 20) : aob_vec(-20, 0, 20),
                      upright ? aob_vec(0, 0, -20) : aob_vec(40, 0, 0),
                      upright ? aob_vec(0, 40, 0) : aob_vec(0, 0, -20));
    const struct aob_vec3 eye = upright ? aob_vec(2, 0, 2) : aob_vec(0, 2, 2),
                          target = upright ? aob_vec(0.3, 0, 0.3) : aob_vec(0, 0.3, 0.3);
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){
                   .mesh = &mesh,
                   .camera = {.eye = eye, .target = target, .fov_deg = aob_resolution_camera(height).fov_deg},
                   .width = width,
                   .height = height});
}

/* Mean of the image's column k, or of its row. */
static double line_mean(const struct aob_exhibit *exhibit, const float *image, bool column, int k)
{
    double sum = 0;
    int count = column ? exhibit->height : exhibit->width;
    for (int i = 0; i < count; i++)
        sum += (double)image[column ? i * exhibit->width + k : k * exhibit->width + i];
    return sum / count;
}

/* How far the lines in the middle stand out from those a tile of noise beside them, beyond half as much again as any line
 * elsewhere: of noise alone, three in the middle hardly ever do that. */
static double stands_out(const struct aob_exhibit *exhibit, const float *image, bool column)
{
    enum { TILE = 4, BORDER = 14 };
    int lines = column ? exhibit->width : exhibit->height;
    double middle = 0, elsewhere = 0;
    for (int k = BORDER; k < lines - BORDER; k++) {
        double away = fabs(k + 0.5 - 0.5 * lines);
        double out =
            fabs(line_mean(exhibit, image, column, k) - 0.5 * (line_mean(exhibit, image, column, k - TILE) +
                                                               line_mean(exhibit, image, column, k + TILE)));
        middle = away <= 1 ? aob_worse(middle, out) : middle;
        elsewhere = away > TILE + 1 ? aob_worse(elsewhere, out) : elsewhere;
    }
    return aob_over(middle - 1.5 * elsewhere);
}

void aob_ask_centre_line(struct aob_trial *trial)
{
    static const int sizes[][2] = {{66, 66}, {67, 66}, {68, 69}, {71, 71}};
    for (size_t s = 0; s < AOB_COUNT(sizes); s++)
        for (int k = 0; k < 4; k++) {
            bool upright = k % 2;
            struct aob_shot shot = {.exhibit = corner_of(trial, sizes[s][0], sizes[s][1], upright),
                                    .radius = 0.5,
                                    .set = k < 2 ? "blur=0" : "divisor=2 blur=0"};
            const float *image = aob_trial_draw(trial, &shot);
            if (!image)
                return;
            aob_trial_take(trial, stands_out(shot.exhibit, image, !upright),
                           &(struct aob_seen){&shot, image, NULL}, "%dx%d %s: %s in the middle", sizes[s][0],
                           sizes[s][1], shot.set, upright ? "rows" : "columns");
        }
}

static struct aob_exhibit *still_life(struct aob_trial *trial, int width, int height)
{
    return aob_set_still_life_at(trial, 1, aob_vec(0, 0, 0), width, height);
}

/* Both sides grow by a pixel, so that the frustum stays. */
void aob_ask_size_continuous(struct aob_trial *trial)
{
    static const char *const sets[] = {NULL, "divisor=2"};
    size_t set_count = aob_subject_has(trial->subject, "divisor") ? 2 : 1;
    for (size_t s = 0; s < set_count; s++) {
        double before = NAN;
        for (int n = 65; n <= 74; n++) {
            struct aob_shot shot = {.exhibit = still_life(trial, n, n), .radius = 0.5, .set = sets[s]};
            const float *image = aob_trial_draw(trial, &shot);
            if (!image)
                return;
            double mean = aob_mean_of(shot.exhibit, image, NULL);
            if (n > 65)
                aob_trial_take(trial, fabs(mean - before), &(struct aob_seen){&shot, image, NULL},
                               "%dx%d %s: mean %.4f, %.4f a pixel smaller", n, n, sets[s] ? sets[s] : "",
                               mean, before);
            before = mean;
        }
    }
}

enum { SMALL_WIDTH = 96, SMALL_HEIGHT = 64 };

/* The image averaged down to the small size. `mask` loses the pixels whose block holds a depth edge. */
static void average_down(const struct aob_exhibit *big, const float *image, int times, float *small,
                         bool *mask)
{
    for (int p = 0; p < SMALL_WIDTH * SMALL_HEIGHT; p++) {
        double sum = 0, nearest = INFINITY, farthest = 0;
        for (int k = 0; k < times * times; k++) {
            size_t x = (size_t)(p % SMALL_WIDTH * times + k % times),
                   y = (size_t)(p / SMALL_WIDTH * times + k / times), i = y * (size_t)big->width + x;
            double depth = (double)aob_exhibit_depth(big, i);
            sum += (double)image[i];
            nearest = fmin(nearest, depth);
            farthest = fmax(farthest, depth);
        }
        small[p] = (float)(sum / (times * times));
        mask[p] = mask[p] && farthest < 1.1 * nearest;
    }
}

/* Means may differ by 0.01, as much as half a pixel along all rims makes, and pixels by the noise that filters leave: its root
 * mean square is 0.05 where it was 0.25, twice. */
void aob_ask_resolution_invariant(struct aob_trial *trial)
{
    struct aob_shot one = {.exhibit = still_life(trial, SMALL_WIDTH, SMALL_HEIGHT), .radius = 0.8};
    const float *wanted = aob_trial_draw(trial, &one);
    for (int times = 2; wanted && times <= 4; times *= 2) {
        struct aob_shot big = {.exhibit = still_life(trial, SMALL_WIDTH * times, SMALL_HEIGHT * times),
                               .radius = 0.8};
        const float *image = aob_trial_draw(trial, &big);
        if (!image)
            return;
        float *down = aob_trial_image(trial, one.exhibit);
        bool *mask = aob_trial_mask(trial, one.exhibit);
        for (size_t i = 0; i < aob_exhibit_pixels(one.exhibit); i++)
            mask[i] = true;
        average_down(big.exhibit, image, times, down, mask);
        struct aob_difference d = aob_difference_of(one.exhibit, down, wanted, mask);
        aob_trial_take(
            trial, aob_worse(fabs(d.mean) / 0.01, d.rmse / 0.1), &(struct aob_seen){&one, down, wanted},
            "%d times the size, averaged down: mean differs by %.4f, RMSE %.4f", times, d.mean, d.rmse);
    }
}

/* A slab lies on the left half of a wall. How far its darkness reaches over the wall: the mean distance from the edge of
 * all that is darker than the open wall. Scene units; NAN where nothing is dark. */
static double reach_of(const struct aob_shot *shot, const float *image)
{
    const struct aob_exhibit *exhibit = shot->exhibit;
    double open = 0, open_count = 0, dark = 0, moment = 0;
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
        double d = aob_exhibit_position(exhibit, i).x / shot->radius;
        open += d > 1.1 && d < 1.3 ? (double)image[i] : 0;
        open_count += d > 1.1 && d < 1.3;
    }
    for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
        double d = aob_exhibit_position(exhibit, i).x / shot->radius;
        double darker = d > 0 && d < 1.3 ? open / open_count - (double)image[i] : 0;
        dark += darker;
        moment += darker * d;
    }
    return dark > 1e-3 * (double)aob_exhibit_pixels(exhibit) ? shot->radius * moment / dark : NAN;
}

void aob_ask_taps_follow_radius(struct aob_trial *trial)
{
    static const struct {
        int width, height;
        double half; /* tangent of half the field of view */
    } views[] = {{96, 64, 0.45}, {192, 128, 0.45}, {96, 64, 0.3}};
    double reaches[AOB_COUNT(views)];
    for (size_t k = 0; k < AOB_COUNT(views); k++) {
        struct aob_mesh mesh = {0};
        aob_resolution_wall(&mesh);
        aob_mesh_add_box(&mesh, aob_vec(-50, -50, 0), aob_vec(0, 50, 0.48), 0);
        const struct aob_exhibit_desc desc = {
            .mesh = &mesh,
            .camera = {.eye = {0, 0, 4}, .fov_deg = 2 * atan(views[k].half) * 180 / M_PI},
            .width = views[k].width,
            .height = views[k].height};
        struct aob_shot shot = {.exhibit = aob_trial_exhibit(trial, &desc), .radius = 1.2};
        const float *image = aob_trial_draw(trial, &shot);
        if (!image)
            return;
        reaches[k] = reach_of(&shot, image);
        if (k == 0 && isnan(reaches[k]) && !trial->broken)
            aob_trial_excuse(trial, "nothing is dark beside a slab");
        aob_trial_take(trial, fabs(reaches[k] / reaches[0] - 1), &(struct aob_seen){&shot, image, NULL},
                       "%dx%d, field of view %.1f degrees: darkness reaches %.4f units, not %.4f",
                       views[k].width, views[k].height, desc.camera.fov_deg, reaches[k], reaches[0]);
    }
}
