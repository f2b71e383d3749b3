#include "lobe.h"
#include <math.h>
#include "base/memory.h"

enum { RINGS = 40, TURNS = 40 };
static const double pi = 3.14159265358979323846, smoothest = 0.35;

static double smith(double cosine, double alpha)
{
    return sqrt(cosine * cosine + alpha * alpha * (1 - cosine * cosine));
}

/* f cos over cos of the direction l, but for a factor; the view direction is (sine, 0, cosine). */
static double quotient(double sine, double cosine, double alpha, struct aob_vec3 l)
{
    struct aob_vec3 half = aob_vec_normalize(aob_vec(l.x + sine, l.y, l.z + cosine));
    double spread = half.z * half.z * (alpha * alpha - 1) + 1;
    return 1 / (spread * spread) / (l.z * smith(cosine, alpha) + cosine * smith(l.z, alpha));
}

/* A direction and its share of the cosine's hemisphere. Rings lie close at the horizon, turns close at the mirrored direction, where the lobe of
 * a grazing view is narrow; one half stands for both. */
static double direction_at(int ring, int turn, struct aob_vec3 *l)
{
    double r = (ring + 0.5) / RINGS, t = (turn + 0.5) / TURNS, z = r * r, s = sqrt(1 - z * z),
           away = pi * t * t * t;
    *l = aob_vec(-s * cos(away), s * sin(away), z);
    return 2 * z * 2 * r / RINGS * 3 * t * t / TURNS;
}

static double apart(double roughness, double cosine)
{
    double alpha = roughness * roughness, sine = sqrt(1 - cosine * cosine), sum = 0, whole = 0, away = 0,
           lobe[RINGS][TURNS], even[RINGS][TURNS];
    if (roughness < smoothest)
        return 1;
    for (int r = 0; r < RINGS; r++)
        for (int t = 0; t < TURNS; t++) {
            struct aob_vec3 l;
            whole += even[r][t] = direction_at(r, t, &l);
            sum += lobe[r][t] = even[r][t] * quotient(sine, cosine, alpha, l);
        }
    for (int r = 0; r < RINGS; r++)
        for (int t = 0; t < TURNS; t++)
            away += fabs(lobe[r][t] / sum - even[r][t] / whole) / 2;
    return away;
}

struct aob_lobe_table *aob_lobe_table_create(void)
{
    struct aob_lobe_table *table = AOB_NEW(struct aob_lobe_table);
    for (int s = 0; s < AOB_LOBE_SHAPES; s++)
        for (int c = 0; c < AOB_LOBE_COSINES; c++) {
            double roughness = s / (AOB_LOBE_SHAPES - 1.0), cosine = pow(c / (AOB_LOBE_COSINES - 1.0), 2);
            aob_composite_moments(roughness, cosine, table->moments[s][c]);
            table->apart[s][c] = (float)apart(roughness, cosine);
        }
    return table;
}

/* Where a surface lies between the entries. */
struct place {
    int row, column;
    double down, across;
};
static struct place place_of(double roughness, double cosine)
{
    double y = fmin(fmax(roughness, 0), 1) * (AOB_LOBE_SHAPES - 1),
           x = sqrt(fmin(fmax(cosine, 0), 1)) * (AOB_LOBE_COSINES - 1);
    struct place p = {(int)fmin(floor(y), AOB_LOBE_SHAPES - 2), (int)fmin(floor(x), AOB_LOBE_COSINES - 2), 0,
                      0};
    p.down = y - p.row;
    p.across = x - p.column;
    return p;
}

static void add(struct aob_composite_lobe *sum, const struct aob_composite_lobe *lobe, double share)
{
    sum->one += share * lobe->one;
    sum->z += share * lobe->z;
    sum->zz += share * lobe->zz;
    sum->x += share * lobe->x;
    sum->xz += share * lobe->xz;
    sum->xx_yy += share * lobe->xx_yy;
}

static void look_up(const struct aob_lobe_table *table, struct place p, struct aob_composite_lobe lobe[2])
{
    for (int f = 0; f < 2; f++) {
        lobe[f] = (struct aob_composite_lobe){0};
        for (int i = 0; i < 4; i++)
            add(&lobe[f], &table->moments[p.row + i / 2][p.column + i % 2][f],
                (i / 2 ? p.down : 1 - p.down) * (i % 2 ? p.across : 1 - p.across));
    }
}

/* A channel's light as the moments of a lobe meet it: its mean, its vector, and its form for two vectors. */
struct channel {
    const struct aob_light *light;
    int c;
};
static double band1(struct channel l, struct aob_vec3 d)
{
    return 0.48860251 * (d.y * l.light->sh[1][l.c] + d.z * l.light->sh[2][l.c] + d.x * l.light->sh[3][l.c]);
}

static double form(struct channel l, struct aob_vec3 a, struct aob_vec3 b)
{
    const double(*sh)[3] = l.light->sh;
    return 0.54627422 * ((a.x * b.y + a.y * b.x) * sh[4][l.c] + (a.y * b.z + a.z * b.y) * sh[5][l.c] +
                         (a.x * b.z + a.z * b.x) * sh[7][l.c] + (a.x * b.x - a.y * b.y) * sh[8][l.c]) +
           0.31539157 * (3 * a.z * b.z - aob_vec_dot(a, b)) * sh[6][l.c];
}

/* harness/technique/composite.glsl, mirrored(). */
static double meet(struct channel l, const struct aob_composite_lobe *lobe, struct aob_vec3 normal,
                   struct aob_vec3 across)
{
    double yy = 0.5 * (lobe->one - lobe->zz - lobe->xx_yy * aob_vec_dot(across, across));
    struct aob_vec3 mean = aob_vec_add(aob_vec_scale(across, lobe->x), aob_vec_scale(normal, lobe->z));
    return lobe->one * 0.28209479 * l.light->sh[0][l.c] + band1(l, mean) +
           (lobe->zz - yy) * form(l, normal, normal) + lobe->xx_yy * form(l, across, across) +
           2 * lobe->xz * form(l, normal, across);
}

void aob_lobe_mirror(const struct aob_lobe_table *table, const struct aob_lobe_surface *surface,
                     const struct aob_light *light, double open[3], double even[3])
{
    struct aob_composite_lobe lobe[2];
    double cosine = fmin(fmax(aob_vec_dot(surface->normal, surface->view), 0), 1);
    struct aob_vec3 across = aob_vec_sub(surface->view, aob_vec_scale(surface->normal, cosine));
    look_up(table, place_of(surface->roughness, cosine), lobe);
    for (int c = 0; c < 3; c++) {
        struct channel l = {light, c};
        double f0 = surface->f0[c];
        open[c] = fmax(f0 * meet(l, &lobe[0], surface->normal, across) +
                           (1 - f0) * meet(l, &lobe[1], surface->normal, across),
                       0);
        even[c] = f0 * lobe[0].one + (1 - f0) * lobe[1].one;
    }
}

/* The larger of the neighbours, since it is a bound. */
double aob_lobe_apart(const struct aob_lobe_table *table, double roughness, double cosine)
{
    struct place p = place_of(roughness, cosine);
    double most = 0;
    for (int i = 0; i < 4; i++)
        most = fmax(most, (double)table->apart[p.row + i / 2][p.column + i % 2]);
    return most;
}
