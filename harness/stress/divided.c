#include <math.h>
#include "base/memory.h"
#include "resolution.h"
#include "sets.h"

/* The corner of two walls, as wide as 256 pixels; a radius of 0.5 covers some 49 of them, 12 at quarter size. The band is
 * what lies nearer to the other wall than nine tenths of the radius. A filter of 13 taps would be as wide as the band there,
 * and one-sided at the crease: it is off. */
static double draw_band(struct aob_trial *trial, const char *set, struct aob_shot *shot, float **image)
{
    struct aob_mesh mesh = {0};
    aob_set_corner(&mesh, 20);
    const struct aob_exhibit_desc desc = {
        .mesh = &mesh,
        .camera = {.eye = {0, 1.5, 1.5}, .target = {0, 0.2, 0.2}, .fov_deg = 50},
        .width = 256,
        .height = 192};
    *shot = (struct aob_shot){.exhibit = aob_trial_exhibit(trial, &desc), .radius = 0.5, .set = set};
    *image = aob_trial_draw(trial, shot);
    if (!*image)
        return NAN;
    bool *band = aob_trial_mask(trial, shot->exhibit);
    for (size_t i = 0; i < aob_exhibit_pixels(shot->exhibit); i++) {
        struct aob_vec3 p = aob_exhibit_position(shot->exhibit, i);
        band[i] = fmax(p.y, p.z) < 0.9 * shot->radius;
    }
    return aob_mean_of(shot->exhibit, *image, band);
}

static void ask_divided_mean(struct aob_trial *trial, const char *set)
{
    struct aob_shot full, low;
    float *wanted, *image;
    double wanted_mean = draw_band(trial, "divisor=1 blur=0", &full, &wanted);
    double mean = draw_band(trial, set, &low, &image);
    if (image)
        aob_trial_take(trial, fabs(mean / wanted_mean - 1), &(struct aob_seen){&low, image, wanted},
                       "%s: mean %.4f, %.4f at full size", set, mean, wanted_mean);
}

void aob_ask_half_size_mean(struct aob_trial *trial)
{
    ask_divided_mean(trial, "divisor=2 blur=0");
}

void aob_ask_quarter_size_mean(struct aob_trial *trial)
{
    ask_divided_mean(trial, "divisor=4 blur=0");
}

struct aob_exhibit *aob_resolution_box(struct aob_trial *trial, int width, int height)
{
    struct aob_mesh mesh = {0};
    aob_resolution_wall(&mesh);
    aob_mesh_add_box(&mesh, aob_vec(-0.25, -0.25, 0), aob_vec(0.25, 0.25, 0.25), 0);
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){
                   .mesh = &mesh, .camera = aob_resolution_camera(height), .width = width, .height = height});
}

struct aob_resolution_middle aob_resolution_middle_of(const struct aob_shot *shot, const float *image)
{
    const struct aob_exhibit *exhibit = shot->exhibit;
    struct aob_resolution_middle m = {0, 0, 0};
    double open = 0, count = 0;
    for (int round = 0; round < 2; round++)
        for (size_t i = 0; i < aob_exhibit_pixels(exhibit); i++) {
            struct aob_vec3 p = aob_exhibit_position(exhibit, i);
            double away = (fmax(fabs(p.x), fabs(p.y)) - 0.25) / shot->radius;
            if (p.z > 0.01 || away > 1.4)
                continue;
            bool is_open = away > 1.2;
            open += round == 0 && is_open ? (double)image[i] : 0;
            count += round == 0 && is_open;
            double dark = round == 1 && !is_open ? open / count - (double)image[i] : 0;
            m.dark += dark;
            m.x += dark * ((double)(i % (size_t)exhibit->width) + 0.5 - 0.5 * exhibit->width);
            m.y += dark * ((double)(i / (size_t)exhibit->width) + 0.5 - 0.5 * exhibit->height);
        }
    m.x /= m.dark;
    m.y /= m.dark;
    return m;
}

void aob_resolution_hold(struct aob_trial *trial, const struct aob_shot *shot, const float *image,
                         const struct aob_resolution_middle *middle, bool first)
{
    if (first && middle->dark < 1)
        aob_trial_excuse(trial, "nothing is dark beside a box");
    if (!(middle->dark >= 1))
        aob_trial_take(trial, NAN, &(struct aob_seen){shot, image, NULL},
                       "%dx%d %s: nothing is dark beside the box", shot->exhibit->width,
                       shot->exhibit->height, shot->set ? shot->set : "");
}

/* The box's middle has 16 places in a tile of 16 x 16 pixels: each row and column of it once, and each of the 4 x 4 places
 * in a block of pixels, in a tile of low pixels, and in one of low pixels at half size. So its edges lie in each way about
 * the low pixels, and noise that repeats every four pixels cancels. Widths are odd, heights even. */
static struct aob_exhibit *box_at(struct aob_trial *trial, int place)
{
    return aob_resolution_box(trial, 65 + 2 * place, 66 + 2 * (4 * (place % 4) + place / 4));
}

/* A low pixel stands for the first pixel of its block; taking it for the block's middle is half a pixel of drift at half
 * size, one and a half at quarter size. */
void aob_ask_half_size_drift(struct aob_trial *trial)
{
    static const char *const sets[] = {"divisor=1", "divisor=2", "divisor=4"};
    struct aob_resolution_middle sums[AOB_COUNT(sets)] = {{0, 0, 0}};
    struct aob_shot shot;
    const float *image = NULL;
    for (int k = 0; k < 16; k++) {
        const struct aob_exhibit *box = box_at(trial, k);
        for (size_t s = 0; s < AOB_COUNT(sets); s++) {
            shot = (struct aob_shot){.exhibit = box, .radius = 0.5, .set = sets[s]};
            image = aob_trial_draw(trial, &shot);
            if (!image)
                return;
            struct aob_resolution_middle m = aob_resolution_middle_of(&shot, image);
            aob_resolution_hold(trial, &shot, image, &m, k == 0 && s == 0);
            sums[s].x += m.x / 16;
            sums[s].y += m.y / 16;
        }
    }
    for (size_t s = 1; s < AOB_COUNT(sets); s++) {
        double x = sums[s].x - sums[0].x, y = sums[s].y - sums[0].y, wrong = s == 1 ? 0.5 : 1.5;
        aob_trial_take(trial, aob_worse(fabs(x), fabs(y)) / wrong, &(struct aob_seen){&shot, image, NULL},
                       "%s: by (%.3f, %.3f) pixels on average", sets[s], x, y);
    }
}

/* Plates stand so far before a wall that neither occludes the other, but that a surface half way between them would. They
 * are eleven pixels wide and no whole number of pixels apart, so that their edges lie in each way about the low pixels. These
 * edges are upright or level: else a pixel at a rim has no low pixel of its own surface about it. */
static struct aob_exhibit *plates(struct aob_trial *trial, double gap)
{
    struct aob_mesh mesh = {0};
    aob_resolution_wall(&mesh);
    for (int k = 0; k < 8; k++)
        aob_mesh_add_quad(&mesh, aob_vec(-1.6 + 0.85 * (k % 4), k / 4 ? -0.73 : 0.21, gap),
                          aob_vec(0.45, 0, 0), aob_vec(0, 0.45, 0));
    return aob_trial_exhibit(
        trial, &(struct aob_exhibit_desc){
                   .mesh = &mesh, .camera = aob_resolution_camera(66), .width = 98, .height = 66});
}

/* Where the noise is such that a surface has no one value, a filter's mean is still no darker than the darkest of what it
 * reads: so at full size nothing is filtered. */
void aob_ask_phantom_depth(struct aob_trial *trial)
{
    static const char *const sets[] = {"divisor=2 depth_divisor=2", "divisor=4 depth_divisor=4"};
    struct aob_shot full = {.exhibit = plates(trial, 0.75), .radius = 0.5, .set = "divisor=1 blur=0"};
    const float *wanted = aob_trial_draw(trial, &full);
    for (size_t s = 0; wanted && s < AOB_COUNT(sets); s++) {
        struct aob_shot low = {.exhibit = full.exhibit, .radius = 0.5, .set = sets[s]};
        const float *image = aob_trial_draw(trial, &low);
        bool *mask = aob_trial_mask(trial, full.exhibit);
        for (int side = 0; image && side < 2; side++) {
            for (size_t i = 0; i < aob_exhibit_pixels(full.exhibit); i++)
                mask[i] = (aob_exhibit_position(full.exhibit, i).z > 0.3) == (side == 1);
            double darkest = aob_resolution_darkest(full.exhibit, image, mask),
                   at_full = aob_resolution_darkest(full.exhibit, wanted, mask);
            aob_trial_take(trial, aob_over(at_full - darkest), &(struct aob_seen){&low, image, wanted},
                           "%s: darkest pixel of the %s %.4f, %.4f at full size", sets[s],
                           side ? "plates" : "wall", darkest, at_full);
        }
    }
}

/* Bars five pixels wide stand eight apart on a wall. At quarter size a low pixel lies in each gap, though the bars hide up to
 * two pixels of it. */
enum { BARS_WIDTH = 98, BARS_HEIGHT = 66 };
static const double bars_pixel = 0.03, bars_distance = 6;

static struct aob_exhibit *bars(struct aob_trial *trial)
{
    struct aob_mesh mesh = {0};
    double high = 8 * bars_pixel, half = 0.5 * BARS_HEIGHT * bars_pixel / bars_distance;
    aob_resolution_wall(&mesh);
    for (int k = -5; k <= 5; k++) {
        double x = (13 * k - 0.25) * bars_pixel;
        aob_mesh_add_box(&mesh, aob_vec(x, -5, 0), aob_vec(x + 5 * bars_pixel, 5, high), 0);
    }
    return aob_trial_exhibit(trial,
                             &(struct aob_exhibit_desc){.mesh = &mesh,
                                                        .camera = {.eye = {0, 0, bars_distance},
                                                                   .fov_deg = 2 * atan(half) * 180 / M_PI},
                                                        .width = BARS_WIDTH,
                                                        .height = BARS_HEIGHT});
}

/* Means of the columns, which all rows share. */
static void column_means(const float *image, double *means)
{
    for (int x = 0; x < BARS_WIDTH; x++) {
        means[x] = 0;
        for (int y = 0; y < BARS_HEIGHT; y++)
            means[x] += (double)image[y * BARS_WIDTH + x] / BARS_HEIGHT;
    }
}

/* How much brighter the two outermost columns of the gaps are than the brightest one of their gap at full size, on average.
 * A gap that the image cuts does not count. */
static double white_edge(const struct aob_exhibit *exhibit, const float *image, const float *full)
{
    double low[BARS_WIDTH], wanted[BARS_WIDTH], excess = 0, count = 0;
    column_means(image, low);
    column_means(full, wanted);
    for (int x = 0, first = -1; x < BARS_WIDTH; x++) {
        bool wall = aob_exhibit_position(exhibit, (size_t)x).z < 0.01;
        first = wall && first < 0 ? x : first;
        if (wall || first < 0)
            continue;
        double brightest = 0;
        for (int k = first; k < x; k++)
            brightest = fmax(brightest, wanted[k]);
        excess += first > 0 ? low[first] + low[x - 1] - 2 * brightest : 0;
        count += first > 0 ? 2 : 0;
        first = -1;
    }
    return excess / count;
}

/* Filters are off: to them the gaps are one surface, and they would mix those. */
void aob_ask_upsampled_edge(struct aob_trial *trial)
{
    static const char *const sets[] = {"divisor=2 blur=0", "divisor=4 blur=0"};
    struct aob_shot full = {.exhibit = bars(trial), .radius = 0.4, .set = "divisor=1 blur=0"};
    const float *wanted = aob_trial_draw(trial, &full);
    for (size_t s = 0; wanted && s < AOB_COUNT(sets); s++) {
        struct aob_shot low = {.exhibit = full.exhibit, .radius = 0.4, .set = sets[s]};
        const float *image = aob_trial_draw(trial, &low);
        if (!image)
            return;
        double excess = white_edge(full.exhibit, image, wanted);
        aob_trial_take(trial, aob_over(excess), &(struct aob_seen){&low, image, wanted},
                       "%s: beside the bars %.4f brighter than the gaps' brightest at full size", sets[s],
                       excess);
    }
}
