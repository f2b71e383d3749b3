#include "bound.h"
#include <math.h>
#include "base/memory.h"
#include "lobe.h"
#include "score/effect.h"

enum { ROWS = 24, COLUMNS = 48, RINGS = 8, TURNS = 16, BRIGHT = 64 };
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

static void find_brightest(const struct aob_light *light, double brightest[3])
{
    for (int i = 0; i <= BRIGHT; i++)
        for (int k = 0; k < 2 * BRIGHT; k++) {
            double rgb[3];
            aob_light_radiance(light, direction(pi * i / BRIGHT, pi * k / BRIGHT), rgb);
            for (int c = 0; c < 3; c++)
                brightest[c] = fmax(brightest[c], rgb[c]);
        }
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

/* What each effect may change in a channel of a surface. */
static void add_channel(const struct shape *shape, const struct aob_seen_surface *s, int c,
                        double sums[AOB_EFFECT_COUNT])
{
    double v = fmin(fmax((double)s->visible, 0), 1), diffuse = (double)s->diffuse[c],
           even = (double)s->even[c], gained = shape->brightest[c] * (aob_effect_bounced(v, diffuse) - v),
           turned = diffuse * sqrt(v * (1 - v)) * deviation_at(shape, s->normal, c),
           lobe = v < 1 ? (double)s->apart * fmax((double)s->mirror[c], even * gained / (1 - v)) : 0;
    sums[AOB_EFFECT_MULTI_BOUNCE] += pow((diffuse + even) * gained, 2);
    sums[AOB_EFFECT_DIRECTIONAL] += turned * turned;
    sums[AOB_EFFECT_SPECULAR] += lobe * lobe;
}

void aob_effect_bounds_find(const struct aob_seen *seen, struct aob_effect_bounds *bounds)
{
    struct shape *shape = find_shape(&seen->light);
    double sums[AOB_EFFECT_COUNT] = {0};
    for (size_t i = 0; i < seen->count; i++)
        for (int c = 0; c < 3; c++)
            add_channel(shape, &seen->surfaces[i], c, sums);
    sums[AOB_EFFECT_BENT_NORMAL] = sums[AOB_EFFECT_DIRECTIONAL];
    for (int id = 0; id < AOB_EFFECT_COUNT; id++)
        bounds->most[id] = sqrt(sums[id] / (3 * (double)seen->count)) / seen->mean_light;
    bounds->most[AOB_EFFECT_VISIBILITY] = bounds->most[AOB_EFFECT_HALF_SIZE] = INFINITY;
    free(shape);
}

unsigned aob_effect_bounds_open(const struct aob_effect_bounds *bounds, double tolerance)
{
    static const enum aob_effect_id judged[] = {AOB_EFFECT_MULTI_BOUNCE, AOB_EFFECT_DIRECTIONAL,
                                                AOB_EFFECT_SPECULAR};
    unsigned open = AOB_EFFECT_ALL;
    double left = tolerance;
    for (size_t round = 0; round < AOB_COUNT(judged); round++) {
        int least = -1;
        for (size_t i = 0; i < AOB_COUNT(judged); i++)
            if (aob_effect_has(open, judged[i]) &&
                (least < 0 || bounds->most[judged[i]] < bounds->most[least]))
                least = (int)judged[i];
        if (least < 0 || !(bounds->most[least] <= left))
            break;
        left -= bounds->most[least];
        open &= ~AOB_EFFECT_BIT(least);
        if (least == AOB_EFFECT_DIRECTIONAL)
            open &= ~AOB_EFFECT_BIT(AOB_EFFECT_BENT_NORMAL);
    }
    return open;
}
