#include "direct_flip.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RADIUS = 10, SIDE = 2 * RADIUS + 1 };
struct filter2 {
    double w[SIDE][SIDE];
};
struct matrix {
    double m[3][3];
};

static const double ppd = 67.0206432765823;

static double determinant(const struct matrix *a)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += a->m[0][i] *
               (a->m[1][(i + 1) % 3] * a->m[2][(i + 2) % 3] - a->m[1][(i + 2) % 3] * a->m[2][(i + 1) % 3]);
    return sum;
}

/* Cramer's rule. */
static struct direct_colour solve(const struct matrix *a, struct direct_colour right)
{
    struct direct_colour result;
    for (int column = 0; column < 3; column++) {
        struct matrix replaced = *a;
        for (int i = 0; i < 3; i++)
            replaced.m[i][column] = right.c[i];
        result.c[column] = determinant(&replaced) / determinant(a);
    }
    return result;
}

static struct direct_colour multiply(const struct matrix *a, struct direct_colour b)
{
    struct direct_colour result;
    for (int i = 0; i < 3; i++)
        result.c[i] = a->m[i][0] * b.c[0] + a->m[i][1] * b.c[1] + a->m[i][2] * b.c[2];
    return result;
}

/* XYZ of a chromaticity, at luminance 1. */
static struct direct_colour xyz_of_chromaticity(double x, double y)
{
    return (struct direct_colour){{x / y, 1, (1 - x - y) / y}};
}

/* The primaries' luminances are what makes their sum white. The digits of D65 are those that the paper's matrix has. */
static struct matrix to_xyz(void)
{
    static const double xy[3][2] = {{0.64, 0.33}, {0.3, 0.6}, {0.15, 0.06}};
    struct matrix result;
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++)
            result.m[i][j] = xyz_of_chromaticity(xy[j][0], xy[j][1]).c[i];
    struct direct_colour luminance = solve(&result, xyz_of_chromaticity(0.31271, 0.32902));
    for (int j = 0; j < 3; j++)
        for (int i = 0; i < 3; i++)
            result.m[i][j] *= luminance.c[j];
    return result;
}

/* XYZ relative to that of white. */
static struct direct_colour relative_xyz(struct direct_colour rgb)
{
    struct matrix m = to_xyz();
    struct direct_colour out = multiply(&m, rgb), white = multiply(&m, (struct direct_colour){{1, 1, 1}});
    for (int i = 0; i < 3; i++)
        out.c[i] /= white.c[i];
    return out;
}

static struct direct_colour opponents(struct direct_colour t)
{
    return (struct direct_colour){{116 * t.c[1] - 16, 500 * (t.c[0] - t.c[1]), 200 * (t.c[1] - t.c[2])}};
}

static struct direct_colour rgb_of_opponents(struct direct_colour o)
{
    struct matrix m = to_xyz();
    double y = (o.c[0] + 16) / 116;
    struct direct_colour xyz = {{y + o.c[1] / 500, y, y - o.c[2] / 200}},
                         white = multiply(&m, (struct direct_colour){{1, 1, 1}});
    for (int i = 0; i < 3; i++)
        xyz.c[i] *= white.c[i];
    return solve(&m, xyz);
}

static struct direct_colour hunt_lab(struct direct_colour rgb)
{
    struct direct_colour t = relative_xyz(rgb);
    for (int i = 0; i < 3; i++)
        t.c[i] = t.c[i] > 216.0 / 24389 ? pow(t.c[i], 1.0 / 3) : (24389.0 / 27 * t.c[i] + 16) / 116;
    struct direct_colour lab = opponents(t);
    lab.c[1] *= 0.01 * lab.c[0];
    lab.c[2] *= 0.01 * lab.c[0];
    return lab;
}

static double hyab(struct direct_colour a, struct direct_colour b)
{
    double da = a.c[1] - b.c[1], db = a.c[2] - b.c[2];
    return fabs(a.c[0] - b.c[0]) + sqrt(da * da + db * db);
}

static double colour_difference(struct direct_colour a, struct direct_colour b)
{
    const struct direct_colour green = {{0, 1, 0}}, blue = {{0, 0, 1}};
    double cmax = pow(hyab(hunt_lab(green), hunt_lab(blue)), 0.7);
    double e = pow(hyab(a, b), 0.7), pccmax = 0.4 * cmax;
    return e < pccmax ? 0.95 / pccmax * e : 0.95 + (e - pccmax) / (cmax - pccmax) * (1 - 0.95);
}

/* The paper's table of contrast sensitivities: a1, b1, a2, b2 of each channel; b2 is of no account where a2 is 0. */
static void make_sensitivity(struct filter2 *f, int channel)
{
    static const double table[3][4] = {{1, 0.0047, 0, 1}, {1, 0.0053, 0, 1}, {34.1, 0.04, 13.5, 0.025}};
    const double pi = acos(-1), *t = table[channel];
    double sum = 0;
    for (int v = 0; v < SIDE; v++)
        for (int u = 0; u < SIDE; u++) {
            double d2 = ((u - RADIUS) * (u - RADIUS) + (v - RADIUS) * (v - RADIUS)) / (ppd * ppd);
            f->w[v][u] = t[0] * sqrt(pi / t[1]) * exp(-pi * pi * d2 / t[1]) +
                         t[2] * sqrt(pi / t[3]) * exp(-pi * pi * d2 / t[3]);
            sum += f->w[v][u];
        }
    for (int i = 0; i < SIDE * SIDE; i++)
        f->w[i / SIDE][i % SIDE] /= sum;
}

/* First (edges) or second (points) derivative of a Gaussian across or down; nine pixels are three sigma, rounded up. */
static void make_feature(struct filter2 *f, int order, int down)
{
    double s = 0.082 * ppd / 2, sums[2] = {0, 0};
    memset(f, 0, sizeof *f);
    for (int v = -9; v <= 9; v++)
        for (int u = -9; u <= 9; u++) {
            double t = down ? v : u, g = exp(-(u * u + v * v) / (2 * s * s));
            double w = order == 1 ? -t * g : (t * t / (s * s) - 1) * g;
            f->w[RADIUS + v][RADIUS + u] = w;
            sums[w > 0] += fabs(w);
        }
    for (int i = 0; i < SIDE * SIDE; i++)
        f->w[i / SIDE][i % SIDE] /= sums[f->w[i / SIDE][i % SIDE] > 0];
}

struct filters {
    struct filter2 sensitivity[3], edge[2], point[2];
};

static void make_filters(struct filters *f)
{
    for (int i = 0; i < 3; i++)
        make_sensitivity(&f->sensitivity[i], i);
    for (int i = 0; i < 2; i++) {
        make_feature(&f->edge[i], 1, i);
        make_feature(&f->point[i], 2, i);
    }
}

struct looks {
    struct direct_colour lab;
    double edge, point;
};

static int clamp(int value, int high)
{
    return value < 0 ? 0 : value > high ? high : value;
}

/* `opponent` is the whole image in opponents; cx, cy the pixel that is looked at. */
static struct looks look_at(const struct direct_pair *pair, const struct filters *f,
                            const struct direct_colour *opponent, int cx, int cy)
{
    struct direct_colour seen = {{0}};
    double edge[2] = {0, 0}, point[2] = {0, 0};
    for (int v = 0; v < SIDE; v++)
        for (int u = 0; u < SIDE; u++) {
            int x = clamp(cx + u - RADIUS, pair->width - 1), y = clamp(cy + v - RADIUS, pair->height - 1);
            struct direct_colour here = opponent[y * pair->width + x];
            for (int i = 0; i < 3; i++)
                seen.c[i] += f->sensitivity[i].w[v][u] * here.c[i];
            for (int i = 0; i < 2; i++) {
                edge[i] += f->edge[i].w[v][u] * (here.c[0] + 16) / 116;
                point[i] += f->point[i].w[v][u] * (here.c[0] + 16) / 116;
            }
        }
    struct direct_colour rgb = rgb_of_opponents(seen);
    for (int i = 0; i < 3; i++)
        rgb.c[i] = rgb.c[i] < 0 ? 0 : rgb.c[i] > 1 ? 1 : rgb.c[i];
    return (struct looks){hunt_lab(rgb), hypot(edge[0], edge[1]), hypot(point[0], point[1])};
}

static double pixel_error(struct looks a, struct looks b)
{
    double edge = fabs(a.edge - b.edge), point = fabs(a.point - b.point);
    double feature = pow((edge > point ? edge : point) / sqrt(2), 0.5);
    return pow(colour_difference(a.lab, b.lab), 1 - feature);
}

static struct direct_colour *opponents_of(const struct direct_pair *pair, const struct direct_colour *image)
{
    int count = pair->width * pair->height;
    struct direct_colour *result = calloc((size_t)count, sizeof *result);
    for (int i = 0; i < count; i++)
        result[i] = opponents(relative_xyz(image[i]));
    return result;
}

double direct_flip(const struct direct_pair *pair)
{
    struct filters f;
    struct direct_colour *image = opponents_of(pair, pair->image), *truth = opponents_of(pair, pair->truth);
    double sum = 0;
    int count = 0;
    make_filters(&f);
    for (int y = 0; y < pair->height; y++)
        for (int x = 0; x < pair->width; x++)
            if (!pair->sky[y * pair->width + x]) {
                sum += pixel_error(look_at(pair, &f, image, x, y), look_at(pair, &f, truth, x, y));
                count++;
            }
    free(image);
    free(truth);
    return sum / count;
}

double direct_flip_of_colours(struct direct_colour one, struct direct_colour other)
{
    return colour_difference(hunt_lab(one), hunt_lab(other));
}
