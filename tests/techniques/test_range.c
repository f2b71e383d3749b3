#include "check.h"
#include <math.h>
#include "base/memory.h"
#include "rig.h"

/* The range rule of each technique, in closed form: a plate stands before a wall, at a height within the radius or
 * beyond it, over the left half of an orthographic image. Every parameter that matters is given, blurs are off. */

enum { N = 128, ROWS = N / 2 }; /* the rows in the middle: their discs end within the image */
#define SPAN  2.0               /* height of the image */
#define PIXEL (SPAN / N)
#define R     0.5

/* `height` 0: the wall alone. The plate's back faces the wall. */
static void draw(struct aob_gpu *gpu, double height, const char *name, const char *params, float *pixels)
{
    struct aob_rig rig;
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 0, 5}, .ortho_height = SPAN};
    aob_mesh_add_quad(&mesh, aob_vec(-9, -9, 0), aob_vec(18, 0, 0), aob_vec(0, 18, 0));
    if (height > 0) {
        aob_mesh_add_quad(&mesh, aob_vec(-9, -9, height), aob_vec(9, 0, 0), aob_vec(0, 18, 0));
        aob_mesh_add_quad(&mesh, aob_vec(-9, -9, height), aob_vec(0, 18, 0), aob_vec(9, 0, 0));
    }
    aob_rig_init(&rig, &mesh, &camera, N, N, 0);
    aob_rig_run(&rig, gpu, name, params, AOB_FETCH_SAMPLED, pixels);
    aob_mesh_finish(&mesh);
    aob_rig_finish(&rig);
}

/* What is closed in column k of the wall, on average: its centre is (k + 1/2) pixels from the plate's edge. */
static double closed(const float *pixels, int k)
{
    double sum = 0;
    for (int y = N / 2 - ROWS / 2; y < N / 2 + ROWS / 2; y++)
        sum += 1 - (double)pixels[y * N + N / 2 + k];
    return sum / ROWS;
}

enum { TURNS = 2000 };

/* The mean over the directions in the image of part(r, height), with r how far the plate's edge is along a direction. */
typedef double part(double r, double height);
static double mean_of(part *part, double distance, double height)
{
    double sum = 0;
    for (int i = 0; i < TURNS; i++) {
        double towards = cos(2 * M_PI * (i + 0.5) / TURNS);
        sum += towards > 0 ? part(distance / towards, height) : 0;
    }
    return sum / TURNS;
}

/* hbao and ray_march, uniform: elevations up to that of the edge, W(l) = 1 - .5 l^2 / R^2 within R. */
static double attenuated(double r, double h)
{
    double l = sqrt(r * r + h * h);
    return l <= R ? (1 - 0.5 * l * l / (R * R)) * h / l : 0;
}

/* gtao, cosine: the square of the elevation's sine, faded over the last half of R. */
static double faded(double r, double h)
{
    double l2 = r * r + h * h;
    return fmin(fmax((R - sqrt(l2)) / (0.5 * R), 0), 1) * h * h / l2;
}

/* Alchemy's equation 10 on the disc, up to a factor: the integral of h / (h^2 + s^2) over what is in range. */
static double obscured(double r, double h)
{
    double most = R * R - h * h;
    return most > r * r ? h * log((h * h + most) / (h * h + r * r)) : 0;
}

/* ao_volumes: the form factor of the plate within the ball, the integral of h^2 / (pi l^4). */
static double form_factor(double r, double h)
{
    double most = R * R - h * h;
    return most > r * r ? h * h * (1 / (h * h + r * r) - 1 / (h * h + most)) : 0;
}

/* volumetric_obscurance, doubled: lines of the plate's part of the disc are solid for min(2 c, c + h) of 2 c, with
 * c = sqrt(R^2 - s^2). The whole disc holds 4/3 pi R^3, of which the wall takes half. */
static double solid(double r, double h)
{
    double sum = 0, from = fmin(r, R), step = (R - from) / 400;
    for (int i = 0; i < 400; i++) {
        double s = from + (i + 0.5) * step, c = sqrt(R * R - s * s);
        sum += fmin(c, h) * s * step;
    }
    return 2 * sum * 2 * M_PI / (4 * M_PI / 3 * R * R * R);
}

static const struct row {
    const char *name, *params;
    part *part;
    bool scaled;  /* a factor is free: columns and heights are held to the closest column */
    bool endless; /* what is beyond the radius closes its lines as well */
} rows[] = {
    {"hbao",
     "radius=0.5 attenuation=0.5 directions=64 steps=64 min_step=0 weighting=uniform blur=0 intensity=1 "
     "angle_bias=0",
     attenuated, false, false},
    {"ray_march", "radius=0.5 attenuation=0.5 directions=32 rays=16 steps=64 weighting=uniform", attenuated,
     false, false},
    {"gtao", "radius=0.5 falloff=0.5 slices=32 steps=64 weighting=cosine blur=0", faded, false, false},
    {"alchemy", "radius=0.5 samples=199 bias=0 epsilon=4e-9 contrast=1 intensity=0.2 blur=0", obscured, true,
     false},
    {"ao_volumes", "radius=0.5 falloff=0 sides=32 divisor=1", form_factor, false, false},
    {"volumetric_obscurance",
     "radius=0.5 samples=64 resolutions=one divisor=1 hemisphere=off amplification=on blur=0", solid, false,
     true},
};

/* The plate's edge is half a pixel from the centre of column 0 and one pixel from the centre of its own last column, for
 * which a tap stands. Half a step of 64 taps comes on top. */
static void check_columns(const struct row *row, const float *pixels, double height, double scale)
{
    for (int k = 2; k < 30; k += 3) {
        double near = scale * mean_of(row->part, (k + 0.5) * PIXEL, height),
               far = scale * mean_of(row->part, (k + 1) * PIXEL, height), got = closed(pixels, k);
        if (!(got <= near + 1 / 128.0 && got >= far - 1 / 128.0))
            fail_msg("%s, plate at %g, column %d: %.4f is closed, not %.4f .. %.4f", row->name, height, k,
                     got, far, near);
    }
}

static void test_within_range(void **state)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    static float pixels[N * N];
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        double scale = 1;
        for (int n = 1; n <= 3; n++) {
            double height = n * R / 4;
            draw(gpu, height, rows[i].name, rows[i].params, pixels);
            if (rows[i].scaled && n == 1)
                scale = closed(pixels, 2) / mean_of(rows[i].part, 2.75 * PIXEL, height);
            check_columns(&rows[i], pixels, height, scale);
        }
    }
    aob_gpu_close(gpu);
}

static void expect_like_alone(struct aob_gpu *gpu, double height, const char *name, const char *params)
{
    static float pixels[N * N], alone[N * N];
    draw(gpu, height, name, params, pixels);
    draw(gpu, 0, name, params, alone);
    for (int y = N / 2 - ROWS / 2; y < N / 2 + ROWS / 2; y++)
        for (int x = N / 2; x < N; x++)
            if (fabsf(pixels[y * N + x] - alone[y * N + x]) > 0.001f)
                fail_msg("%s: a plate at %g shows: %.4f in column %d, %.4f without it", name, height,
                         (double)pixels[y * N + x], x - N / 2, (double)alone[y * N + x]);
}

/* A plate that is farther away than the radius changes no pixel of the wall. */
static void test_beyond_range(void **state)
{
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++)
        if (!rows[i].endless)
            expect_like_alone(gpu, 1.02 * R, rows[i].name, rows[i].params);
    aob_gpu_close(gpu);
}

/* How much is closed in all columns beside a plate. */
static double all_closed(struct aob_gpu *gpu, double height, const char *name, const char *params)
{
    static float pixels[N * N];
    double sum = 0;
    draw(gpu, height, name, params, pixels);
    for (int k = 0; k < N / 4; k++)
        sum += closed(pixels, k);
    return sum;
}

/* StarCraft II: a plate at height h lies h - p before a point at height p of 0 .. R. Up to full_occlusion it blocks,
 * then less and less, and from no_occlusion on nothing. */
static void test_starcraft2_blocker(void **state)
{
    static const char name[] = "starcraft2_ssao",
                      params[] =
                          "radius=0.5 full_occlusion=1.5 no_occlusion=2.5 power=1 radii=one samples=64 "
                          "blocker=formula epsilon=0.0001 near_factor=1 max_screen_radius=0 blur=0";
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    (void)state;
    double all = all_closed(gpu, 1, name, params), half = all_closed(gpu, 2, name, params),
           less = all_closed(gpu, 2.25, name, params);
    assert_true(all > 1);
    assert_near(half - less, 0.25 * all, 0.01 * all);
    assert_true(half > 0.5 * all && half < all); /* (.5 + p) of it */
    assert_near(all_closed(gpu, 0.75, name, params), all, 0.01 * all);
    expect_like_alone(gpu, 3.02, name, params);
    aob_gpu_close(gpu);
}

/* Crytek: samples behind a plate at height h before a wall 5 away count the default by h / (5 - h) / range, at most
 * whole. */
static void test_crytek_range(void **state)
{
    static const char params[] = "radius=0.5 size=scene samples=16 rotation=matrix hemisphere=off "
                                 "amplification=off blur=0 range=1 range_default=";
    static const struct {
        double height, share;
    } heights[] = {{2.5, 1}, {3, 1}, {1, 0.25}, {0.625, 1 / 7.0}};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    double whole = 0;
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(heights); i++) {
        char text[3][256];
        double sums[3];
        for (int d = 0; d < 3; d++) {
            snprintf(text[d], sizeof text[d], "%s%g", params, 0.5 * d);
            sums[d] = all_closed(gpu, heights[i].height, "crytek_ssao", text[d]);
        }
        whole = i ? whole : sums[0] - sums[2];
        assert_true(whole > 1);
        assert_near(sums[0] - sums[2], heights[i].share * whole, 0.01 * whole);
        assert_near(sums[0] - sums[1], 0.5 * heights[i].share * whole, 0.01 * whole);
    }
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_within_range), cmocka_unit_test(test_beyond_range),
        cmocka_unit_test(test_starcraft2_blocker), cmocka_unit_test(test_crytek_range)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
