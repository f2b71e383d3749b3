#include "check.h"
#include "score/flip.h"
#include "pairs.h"

/* A second implementation: the paper's steps for any colours, in three channels, with filters of two dimensions, and
 * the image as an sRGB file that is decoded first. */
enum { RADIUS = 10, SIDE = 2 * RADIUS + 1 };
struct filter2 {
    double w[SIDE][SIDE];
};
struct colour {
    double c[3];
};

static const double to_xyz[3][3] = {{0.41238656, 0.35759149, 0.18045049},
                                    {0.21263682, 0.71518298, 0.07218020},
                                    {0.01933062, 0.11919716, 0.95037259}};
static const double ppd = 67.0206432765823;

static double determinant(const double m[3][3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += m[0][i] * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3]);
    return sum;
}

/* Cramer's rule. */
static struct colour solve(const double m[3][3], struct colour right)
{
    struct colour result;
    for (int column = 0; column < 3; column++) {
        double replaced[3][3];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                replaced[i][j] = j == column ? right.c[i] : m[i][j];
        result.c[column] = determinant((const double(*)[3])replaced) / determinant(m);
    }
    return result;
}

/* XYZ relative to that of white. */
static struct colour relative_xyz(struct colour rgb)
{
    struct colour out;
    for (int i = 0; i < 3; i++)
        out.c[i] = (to_xyz[i][0] * rgb.c[0] + to_xyz[i][1] * rgb.c[1] + to_xyz[i][2] * rgb.c[2]) /
                   (to_xyz[i][0] + to_xyz[i][1] + to_xyz[i][2]);
    return out;
}

static struct colour opponents(struct colour t)
{
    return (struct colour){{116 * t.c[1] - 16, 500 * (t.c[0] - t.c[1]), 200 * (t.c[1] - t.c[2])}};
}

static struct colour rgb_of_opponents(struct colour o)
{
    double y = (o.c[0] + 16) / 116;
    struct colour xyz = {{y + o.c[1] / 500, y, y - o.c[2] / 200}};
    for (int i = 0; i < 3; i++)
        xyz.c[i] *= to_xyz[i][0] + to_xyz[i][1] + to_xyz[i][2];
    return solve(to_xyz, xyz);
}

static struct colour hunt_lab(struct colour rgb)
{
    struct colour t = relative_xyz(rgb);
    for (int i = 0; i < 3; i++)
        t.c[i] = t.c[i] > 216.0 / 24389 ? pow(t.c[i], 1.0 / 3) : (24389.0 / 27 * t.c[i] + 16) / 116;
    struct colour lab = opponents(t);
    lab.c[1] *= 0.01 * lab.c[0];
    lab.c[2] *= 0.01 * lab.c[0];
    return lab;
}

static double hyab(struct colour a, struct colour b)
{
    double da = a.c[1] - b.c[1], db = a.c[2] - b.c[2];
    return fabs(a.c[0] - b.c[0]) + sqrt(da * da + db * db);
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

/* What the file of the image holds at a pixel, and back. */
static double decode(double code)
{
    return code <= 0.04045 ? code / 12.92 : pow((code + 0.055) / 1.055, 2.4);
}

static double encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

static struct colour pixel_opponents(const struct pair *pair, const float *pixels, int x, int y)
{
    double grey = decode(encode(pair_pixel(pair, pixels, x, y)));
    return opponents(relative_xyz((struct colour){{grey, grey, grey}}));
}

struct looks {
    struct colour lab;
    double edge, point;
};

static struct looks look_at(const struct pair *pair, const struct filters *f, const struct colour *opponent,
                            int cx, int cy)
{
    struct colour seen = {{0}};
    double edge[2] = {0, 0}, point[2] = {0, 0};
    for (int v = 0; v < SIDE; v++)
        for (int u = 0; u < SIDE; u++) {
            int x = cx + u - RADIUS, y = cy + v - RADIUS;
            x = x < 0 ? 0 : x >= pair->desc.width ? pair->desc.width - 1 : x;
            y = y < 0 ? 0 : y >= pair->desc.height ? pair->desc.height - 1 : y;
            struct colour here = opponent[y * pair->desc.width + x];
            for (int i = 0; i < 3; i++)
                seen.c[i] += f->sensitivity[i].w[v][u] * here.c[i];
            for (int i = 0; i < 2; i++) {
                edge[i] += f->edge[i].w[v][u] * (here.c[0] + 16) / 116;
                point[i] += f->point[i].w[v][u] * (here.c[0] + 16) / 116;
            }
        }
    struct colour rgb = rgb_of_opponents(seen);
    for (int i = 0; i < 3; i++)
        rgb.c[i] = rgb.c[i] < 0 ? 0 : rgb.c[i] > 1 ? 1 : rgb.c[i];
    return (struct looks){hunt_lab(rgb), hypot(edge[0], edge[1]), hypot(point[0], point[1])};
}

static double direct_pixel(struct looks a, struct looks b)
{
    double cmax = pow(hyab(hunt_lab((struct colour){{0, 1, 0}}), hunt_lab((struct colour){{0, 0, 1}})), 0.7);
    double e = pow(hyab(a.lab, b.lab), 0.7), pccmax = 0.4 * cmax;
    double colour = e < pccmax ? 0.95 / pccmax * e : 0.95 + (e - pccmax) / (cmax - pccmax) * (1 - 0.95);
    double edge = fabs(a.edge - b.edge), point = fabs(a.point - b.point);
    return pow(colour, 1 - pow((edge > point ? edge : point) / sqrt(2), 0.5));
}

static double direct_flip(const struct pair *pair)
{
    struct filters f;
    struct colour image[PAIR_SIZE], truth[PAIR_SIZE];
    double sum = 0;
    int count = 0;
    for (int i = 0; i < 3; i++)
        make_sensitivity(&f.sensitivity[i], i);
    for (int i = 0; i < 2; i++) {
        make_feature(&f.edge[i], 1, i);
        make_feature(&f.point[i], 2, i);
    }
    for (int i = 0; i < PAIR_SIZE; i++) {
        image[i] = pixel_opponents(pair, pair->image, i % PAIR_WIDTH, i / PAIR_WIDTH);
        truth[i] = pixel_opponents(pair, pair->truth, i % PAIR_WIDTH, i / PAIR_WIDTH);
    }
    for (int y = 0; y < PAIR_HEIGHT; y++)
        for (int x = 0; x < PAIR_WIDTH; x++)
            if (pair->depth[y * PAIR_WIDTH + x] < pair->desc.sky_depth) {
                sum += direct_pixel(look_at(pair, &f, image, x, y), look_at(pair, &f, truth, x, y));
                count++;
            }
    return sum / count;
}

static void test_second_implementation(void **state)
{
    (void)state;
    double low = 1, high = 0;
    for (int i = 0; i < PAIR_COUNT; i++) {
        struct pair pair;
        pair_make(&pair, i);
        double flip = aob_flip(&pair.desc);
        assert_near(flip, direct_flip(&pair), 1e-5);
        low = fmin(low, flip);
        high = fmax(high, flip);
    }
    assert_true(low < 0.15 && high > 0.5); /* the pairs are not all alike */
}

static void test_identities(void **state)
{
    (void)state;
    for (int i = 0; i < PAIR_COUNT; i++) {
        struct pair pair;
        pair_make(&pair, i);
        double forth = aob_flip(&pair.desc);
        pair.desc.image = pair.truth;
        assert_true(aob_flip(&pair.desc) == 0);
        pair.desc.truth = pair.image;
        assert_near(aob_flip(&pair.desc), forth, 1e-12);
        assert_true(forth > 0 && forth < 1);
    }
}

/* Constants have no features: only the colour's difference is left. */
static void test_constants(void **state)
{
    (void)state;
    struct pair pair;
    pair_fill(&pair, 0, 1);
    assert_near(aob_flip(&pair.desc), 0.967, 0.001);
    pair_fill(&pair, 0.18418652f, 1); /* L* = 50: half the way from white to black, before the exponent */
    assert_near(aob_flip(&pair.desc), 0.95 * pow(50 / 203.2, 0.7) / 0.4, 0.001);
}

/* The more noise, or the wider a blur, the more one notices; what is finer than the eye sees goes nearly unnoticed. */
static void test_order(void **state)
{
    (void)state;
    struct pair pair;
    pair_make(&pair, 4);
    double noisy = 0, blurred = 0;
    for (int step = 1; step <= 5; step++) {
        pair_add_noise(&pair, 0.1 * step);
        double now = aob_flip(&pair.desc);
        assert_true(now > noisy);
        noisy = now;
    }
    for (int radius = 1; radius <= 4; radius++) {
        pair_blur(&pair, radius);
        double now = aob_flip(&pair.desc);
        assert_true(now > blurred);
        blurred = now;
    }
    pair_fill(&pair, 0.6f, 0.5f);
    double even = aob_flip(&pair.desc);
    for (int i = 0; i < PAIR_SIZE; i++)
        pair.image[i] = (i / PAIR_WIDTH + i % PAIR_WIDTH) % 2 ? 0.6f : 0.4f;
    assert_true(aob_flip(&pair.desc) < 0.2 * even);
}

static void test_small_images(void **state)
{
    (void)state;
    struct pair pair;
    pair_fill(&pair, 0, 1);
    pair.desc.width = pair.desc.height = 1;
    assert_near(aob_flip(&pair.desc), 0.967, 0.001);
    pair.depth[0] = 1e9f;
    assert_true(isnan(aob_flip(&pair.desc)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_second_implementation),
                                       cmocka_unit_test(test_identities), cmocka_unit_test(test_constants),
                                       cmocka_unit_test(test_order), cmocka_unit_test(test_small_images)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
