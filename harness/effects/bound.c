#include "bound.h"
#include <math.h>
#include "base/memory.h"
#include "lobe.h"
#include "score/effect.h"

/* A mean of ENOUGH rays is off by .04 at most. */
enum { ROWS = 24, COLUMNS = 48, RINGS = 8, TURNS = 16, ENOUGH = 128 };
static const double pi = 3.14159265358979323846;

/* Of the light: its brightest radiance, and its deviation over the hemisphere about each of some normals. */
struct shape {
    double brightest[3];
    float deviation[ROWS + 1][COLUMNS][3];
};

static struct aob_vec3 direction(double down, double turn)
{
    return aob_vec(sin(down) * cos(turn), cos(down), sin(down) * sin(turn));
}

/* The least of what is negated is the largest. */
static void find_brightest(const struct aob_light *light, double brightest[3])
{
    struct aob_light dark = *light;
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            dark.sh[i][c] = -light->sh[i][c];
    for (int c = 0; c < 3; c++)
        brightest[c] = fmax(-aob_light_least(&dark, c), 0);
}

/* Directions of equal shares of the cosine's hemisphere about n. */
static void find_deviation(const struct aob_light *light, struct aob_vec3 n, float deviation[3])
{
    struct aob_vec3 other = fabs(n.x) < 0.7 ? aob_vec(1, 0, 0) : aob_vec(0, 1, 0),
                    x = aob_vec_normalize(aob_vec_cross(other, n)), y = aob_vec_cross(n, x);
    double sum[3] = {0}, squares[3] = {0};
    for (int r = 0; r < RINGS; r++)
        for (int t = 0; t < TURNS; t++) {
            double s = sqrt((r + 0.5) / RINGS), turn = 2 * pi * (t + 0.5) / TURNS, rgb[3];
            struct aob_vec3 flat =
                aob_vec_add(aob_vec_scale(x, s * cos(turn)), aob_vec_scale(y, s * sin(turn)));
            aob_light_radiance(light, aob_vec_add(flat, aob_vec_scale(n, sqrt(1 - s * s))), rgb);
            for (int c = 0; c < 3; c++) {
                sum[c] += rgb[c] / (RINGS * TURNS);
                squares[c] += rgb[c] * rgb[c] / (RINGS * TURNS);
            }
        }
    for (int c = 0; c < 3; c++)
        deviation[c] = (float)sqrt(fmax(squares[c] - sum[c] * sum[c], 0));
}

static struct shape *find_shape(const struct aob_light *light)
{
    struct shape *shape = AOB_NEW(struct shape);
    find_brightest(light, shape->brightest);
    for (int i = 0; i <= ROWS; i++)
        for (int k = 0; k < COLUMNS; k++)
            find_deviation(light, direction(pi * i / ROWS, 2 * pi * k / COLUMNS), shape->deviation[i][k]);
    return shape;
}

/* The largest of the normals about it. */
static double deviation_at(const struct shape *shape, const float normal[3], int c)
{
    double down = acos(fmin(fmax((double)normal[1], -1), 1)) / pi * ROWS,
           turn = atan2((double)normal[2], (double)normal[0]) / (2 * pi) * COLUMNS, most = 0;
    int row = (int)fmin(floor(down), ROWS - 1), column = (int)floor(turn);
    for (int i = 0; i < 4; i++)
        most = fmax(most, (double)shape->deviation[row + i / 2][(column + i % 2 + COLUMNS) % COLUMNS][c]);
    return most;
}

/* The squares of what each effect may change in a channel of a surface whose visibility is v. Bounced light stands in for what is
 * closed of the lobe: 1 - v, or as much more as the lobe lies apart. */
static void find_channel(const struct shape *shape, const struct aob_seen_surface *s, int c, double v,
                         double squares[AOB_EFFECT_COUNT])
{
    double diffuse = (double)s->diffuse[c], even = (double)s->even[c], apart = (double)s->apart,
           bounced = aob_effect_bounced(v, diffuse), gained = shape->brightest[c] * fmax(bounced - v, 0),
           closed = fmax(1 - v, 1.0 / 256), gain = fmax(bounced / fmax(v, 1.0 / 1024), 1),
           stands_in = even * fmin(closed + apart, 1) / closed,
           turned = (diffuse * gain + stands_in * (gain - 1)) * sqrt(v * (1 - v)) *
                    deviation_at(shape, s->normal, c),
           bounces = (diffuse + stands_in) * gained,
           lobe = v < 1 ? apart * fmax((double)s->mirror[c], even * gained / closed) : 0;
    squares[AOB_EFFECT_MULTI_BOUNCE] = bounces * bounces;
    squares[AOB_EFFECT_DIRECTIONAL] = turned * turned;
    squares[AOB_EFFECT_SPECULAR] = lobe * lobe;
}

static double own_of(const struct aob_seen_surface *s)
{
    return fmin(fmax((double)s->visible, 0), 1);
}

/* The larger of what the surface's own rays and what those about it say. */
static void add_surface(const struct shape *shape, const struct aob_seen_surface *s, double about,
                        double sums[AOB_EFFECT_COUNT])
{
    for (int c = 0; c < 3; c++) {
        double one[AOB_EFFECT_COUNT] = {0}, other[AOB_EFFECT_COUNT] = {0};
        find_channel(shape, s, c, own_of(s), one);
        find_channel(shape, s, c, about, other);
        for (int id = 0; id < AOB_EFFECT_COUNT; id++)
            sums[id] += fmax(one[id], other[id]);
    }
}

static size_t block_of(const struct aob_seen *seen, size_t i, size_t side)
{
    size_t width = (size_t)seen->width, x = seen->pixel[i] % width / side, y = seen->pixel[i] / width / side;
    return y * (width / side + 1) + x;
}

/* Sets, for each surface, the mean of a block of pixels that together have enough rays. */
static void find_means(const struct aob_seen *seen, size_t side, double *about)
{
    size_t blocks = ((size_t)seen->width / side + 1) * ((size_t)seen->height / side + 1);
    double *sums = AOB_NEW_ARRAY(double, 2 * blocks);
    for (size_t i = 0; i < seen->count; i++) {
        size_t b = block_of(seen, i, side);
        sums[2 * b] += own_of(&seen->surfaces[i]);
        sums[2 * b + 1]++;
    }
    for (size_t i = 0; i < seen->count; i++) {
        size_t b = block_of(seen, i, side);
        about[i] = sums[2 * b] / sums[2 * b + 1];
    }
    free(sums);
}

/* The visibility about each surface; free() it. The few rays of one pixel call much open or closed that is neither, and of v (1 - v)
 * n rays give a share of 1 - 1/n. */
static double *find_about(const struct aob_seen *seen)
{
    double *about = AOB_NEW_ARRAY(double, seen->count + 1);
    int side = seen->spp ? (int)ceil(sqrt((double)ENOUGH / seen->spp)) : 1;
    for (size_t i = 0; i < seen->count; i++)
        about[i] = own_of(&seen->surfaces[i]);
    if (side > 1)
        find_means(seen, (size_t)side, about);
    return about;
}

void aob_effect_bounds_find(const struct aob_seen *seen, struct aob_effect_bounds *bounds)
{
    struct shape *shape = find_shape(&seen->light);
    double sums[AOB_EFFECT_COUNT] = {0}, *about = find_about(seen);
    for (size_t i = 0; i < seen->count; i++)
        add_surface(shape, &seen->surfaces[i], about[i], sums);
    sums[AOB_EFFECT_BENT_NORMAL] = sums[AOB_EFFECT_DIRECTIONAL];
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        bounds->most[id] = sqrt(sums[id] / (3 * (double)seen->count)) / seen->mean_light;
    bounds->most[AOB_EFFECT_VISIBILITY] = bounds->most[AOB_EFFECT_TEMPORAL] =
        bounds->most[AOB_EFFECT_HALF_SIZE] = INFINITY;
    free(about);
    free(shape);
}

/* Takes the least out, one after another; returns what is left of the share. */
static double take_out(const struct aob_effect_bounds *bounds, double left, unsigned *open)
{
    static const enum aob_effect_id judged[] = {AOB_EFFECT_MULTI_BOUNCE, AOB_EFFECT_DIRECTIONAL,
                                                AOB_EFFECT_SPECULAR};
    for (size_t round = 0; round < AOB_COUNT(judged); round++) {
        int least = -1;
        for (size_t i = 0; i < AOB_COUNT(judged); i++)
            if (aob_effect_has(*open, judged[i]) &&
                (least < 0 || bounds->most[judged[i]] < bounds->most[least]))
                least = (int)judged[i];
        if (least < 0 || !(bounds->most[least] <= left))
            break;
        left -= bounds->most[least];
        *open &= ~AOB_EFFECT_BIT(least);
        if (least == AOB_EFFECT_DIRECTIONAL)
            *open &= ~AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL);
    }
    return left;
}

unsigned aob_effect_bounds_open(const struct aob_effect_bounds *bounds, double tolerance)
{
    unsigned open = AOB_EFFECT_ALL;
    take_out(bounds, AOB_EFFECT_RULED * tolerance, &open);
    return open;
}

double aob_effect_bounds_left(const struct aob_effect_bounds *bounds, double tolerance)
{
    unsigned open = AOB_EFFECT_ALL;
    return take_out(bounds, AOB_EFFECT_RULED * tolerance, &open);
}
