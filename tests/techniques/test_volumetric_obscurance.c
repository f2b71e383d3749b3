#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "half.h"
#include "score/score.h"
#include "rig.h"
#include "spread.h"
#include "technique/registry.h"

enum { W = 160, H = 90, GUARD = 64 };

static void run(const struct aob_rig *rig, struct aob_gpu *gpu, const char *params, float *ao)
{
    char all[200];
    snprintf(all, sizeof all, "blur=0 hemisphere=off %s", params); /* the last one stands */
    aob_rig_run(rig, gpu, "volumetric_obscurance", all, AOB_FETCH_SAMPLED, ao);
}

/* A wall is half of the sphere at any tilt, before the factor 2 and in each pixel: opposite lines make up for each
 * other. */
static void test_wall_is_half_solid(void **state)
{
    (void)state;
    static const char *const kinds[] = {"", "resolutions=one divisor=1 samples=2", "hemisphere=on"};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float ao[W * H];
    for (double tilt = 0; tilt <= 60; tilt += 30)
        for (double azimuth = 0; azimuth < 240; azimuth += 120) {
            struct aob_rig rig;
            aob_rig_plane(&rig, &(struct aob_rig_plane){.distance = 4,
                                                        .fov_deg = 45,
                                                        .tilt_deg = tilt,
                                                        .azimuth_deg = azimuth,
                                                        .width = W,
                                                        .height = H});
            for (size_t k = 0; k < AOB_COUNT(kinds); k++) {
                char params[100];
                float inner[W * H];
                int count = 0;
                snprintf(params, sizeof params, "amplification=off radius=0.5 %s", kinds[k]);
                run(&rig, gpu, params, ao);
                for (int i = 0; i < W * H; i++) { /* lines that leave the image are empty */
                    int edge =
                        (int)ceil(0.5 / (rig.gbuffer.projection.sy * (double)rig.gbuffer.depth[i])) + 3;
                    int x = i % W, y = i / W;
                    if (rig.hits.depth[i] > 0 && fmin(fmin(x, W - 1 - x), fmin(y, H - 1 - y)) > edge)
                        inner[count++] = ao[i];
                }
                struct spread s = spread_of(inner, count);
                if (azimuth == 120 && k == 0)
                    printf("volumetric_obscurance, wall of tilt %g: empty share %.4f, %.4f to %.4f\n", tilt,
                           s.mean, s.least, s.most);
                assert_true(count > 1000);
                assert_true(s.least >= 0.49 && s.most <= 0.51);
            }
            aob_rig_finish(&rig);
        }
    aob_gpu_close(gpu);
}

/* Crease of two large planes at right angles, seen from between them; pixel row 46 lies on it. */
static void crease_rig(struct aob_rig *rig, bool ortho)
{
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 4, 4}, .fov_deg = 45, .ortho_height = ortho ? 5 : 0};
    aob_mesh_add_quad(&mesh, aob_vec(-200, 0, 0), aob_vec(0, 0, 200), aob_vec(400, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-200, 0, 0), aob_vec(400, 0, 0), aob_vec(0, 200, 0));
    aob_rig_init(rig, &mesh, &camera, W, 93, GUARD);
    aob_mesh_finish(&mesh);
}

/* Three quarters of a sphere about a point of the crease are solid: V = 2 (1 - 3/4), whatever the radius. */
static void test_crease_is_half_open(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    float ao[W * 93];
    for (int ortho = 0; ortho < 2; ortho++) {
        struct aob_rig rig;
        crease_rig(&rig, ortho);
        for (double radius = 0.5; radius <= 2; radius *= 4)
            for (int k = 0; k < 3; k++) {
                char params[100];
                snprintf(params, sizeof params, "radius=%g samples=%d hemisphere=%s", radius, k ? 64 : 6,
                         k == 2 ? "on" : "off");
                run(&rig, gpu, params, ao);
                struct spread s = spread_of(&ao[46 * W], W);
                printf("volumetric_obscurance, crease, %s, %s: %.4f, %.3f to %.3f\n",
                       ortho ? "orthographic" : "perspective", params, s.mean, s.least, s.most);
                assert_near(s.mean, 0.5, 0.02);
                assert_true(k == 0 || (s.least >= 0.44 && s.most <= 0.56));
            }
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* The share of a unit ball that lies beyond a plane at distance t of its centre, and before a plane through its centre;
 * c: cosine of the angle between their normals. Slices parallel to the first plane are discs that the second one cuts. */
static double wedge(double t, double c)
{
    enum { SLICES = 400 };
    double sum = 0, tilt = c / sqrt(1 - c * c);
    for (int i = 0; i < SLICES; i++) {
        double u = t + (1 - t) * (i + 0.5) / SLICES, radius = sqrt(1 - u * u);
        double h = fmax(-radius, fmin(radius, u * tilt));
        sum += radius * radius * acos(h / radius) - h * sqrt(fmax(0, radius * radius - h * h));
    }
    return sum * (1 - t) / SLICES / (4 * M_PI / 3);
}

/* What is open at a point of a right corner at distance d of the other plane: half of a cap is beyond it. */
static double ball_form(double d, double r)
{
    double t = fmin(1, d / r);
    return 1 - (1 - t) * (1 - t) * (2 + t) / 4;
}

/* The same of the text's lines: they are those of the view, and their depths zc (1 - zc/z). In these coordinates (the
 * offset at the centre's depth, and that depth) every plane n.P = b stays one: n.C - b + n_xy.offset + (b / zc) depth = 0.
 * The ball about the centre is another one off the image's middle, and so are angle and distance of the planes. */
static double line_form(const struct aob_rig *rig, struct aob_vec3 point, double r)
{
    struct aob_vec3 eye = rig->camera.eye, f = aob_vec_normalize(aob_vec_sub(rig->camera.target, eye)), m[2];
    const struct aob_vec3 floor_wall[2] = {{0, 1, 0}, {0, 0, 1}};
    double zc = aob_vec_dot(aob_vec_sub(point, eye), f);
    int own = point.y < point.z ? 0 : 1;
    for (int k = 0; k < 2; k++) {
        struct aob_vec3 n = floor_wall[k];
        m[k] = aob_vec_add(n, aob_vec_scale(f, -aob_vec_dot(n, eye) / zc - aob_vec_dot(n, f)));
    }
    double length = aob_vec_length(m[1 - own]);
    double t = aob_vec_dot(floor_wall[1 - own], point) / (length * r);
    double c = aob_vec_dot(m[0], m[1]) / (length * aob_vec_length(m[own]));
    return t < 1 ? 1 - 2 * wedge(t, c) : 1;
}

struct corner_case {
    const char *params;
    double radius, fine; /* fine: of the image of full size, where there are two; else the radius */
    double full;         /* what is open: 1, or 0.5 without amplification */
};

struct corner_errors {
    double lines, ball,
        loss; /* RMSE: of the image to line_form, to its traced definition; of the two forms */
};

static struct corner_errors corner_errors(struct aob_gpu *gpu, const struct aob_rig *rig,
                                          const struct corner_case *c)
{
    float ao[W * H], traced[W * H];
    struct corner_errors e = {0};
    int count = 0;
    run(rig, gpu, c->params, ao);
    aob_rig_definition(rig, "volumetric_obscurance", c->params, 256, traced);
    for (int i = 0; i < W * H; i++) {
        struct aob_vec3 p;
        if (!aob_rig_position(rig, i % W, i / W, &p) ||
            ball_form(fmax(p.y, p.z), c->radius) >= AOB_BAND_LIMIT)
            continue;
        double lines = c->full * 0.5 * (line_form(rig, p, c->radius) + line_form(rig, p, c->fine));
        double d = fmax(p.y, p.z), ball = c->full * 0.5 * (ball_form(d, c->radius) + ball_form(d, c->fine));
        e.lines += pow((double)ao[i] - lines, 2);
        e.ball += pow((double)ao[i] - (double)traced[i], 2);
        e.loss += pow(lines - ball, 2);
        count++;
    }
    assert_true(count > 500);
    e = (struct corner_errors){sqrt(e.lines / count), sqrt(e.ball / count), sqrt(e.loss / count)};
    printf("volumetric_obscurance on corner, fov %g, %s: in-band RMSE %.4f to the form of lines, %.4f to its "
           "definition; the forms differ by %.4f\n",
           rig->camera.fov_deg, c->params, e.lines, e.ball, e.loss);
    return e;
}

#define ONE "samples=256 resolutions=one divisor=1"
/* Off the middle of a view "a ball about C projects to an ellipse, not a disk" (section 2.3), which the text leaves out. So
 * the lines are held to what they are to find, in the scene's own view of 91 degrees as with a long lens, and the
 * definition is missed by what the text loses and no more. The bar is what is asked of the techniques on this scene at
 * some 200 samples a pixel and more (test_gtao.c). */
static void test_corner_against_closed_forms(void **state)
{
    static const double bar = 0.012;
    static const struct corner_case cases[] = {
        {ONE " radius=0.5", 0.5, 0.5, 1},
        {ONE " radius=1", 1, 1, 1},
        {ONE " radius=2", 2, 2, 1},
        {ONE " radius=1 hemisphere=on", 1, 1, 1},
        {ONE " radius=1 amplification=off", 1, 1, 0.5}, /* half of all values, so half of the error */
        {"samples=256 radius=2 fine_radius=0.5", 2, 1, 1},
    };
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rigs[2];
    struct aob_mesh mesh = {0};
    double back =
        tan(30 * M_PI / 180) / tan(2.5 * M_PI / 180); /* as large in the image as in the view `front` */
    struct aob_camera camera = {.eye = {0, 0.8 + 1.2 * back, 4 * back}, .target = {0, 0.8, 0}, .fov_deg = 5};
    aob_scene_find("corner")->build(&mesh);
    aob_rig_init(&rigs[0], &mesh, &camera, W, H, GUARD);
    aob_mesh_finish(&mesh);
    aob_rig_scene(&rigs[1], "corner", "front", W, H, GUARD);
    assert_near(1 - 2 * wedge(0.3, 0), ball_form(0.3, 1), 1e-5);
    for (int k = 0; k < 2; k++) {
        for (size_t i = 0; i < AOB_COUNT(cases); i++) {
            struct corner_errors e = corner_errors(gpu, &rigs[k], &cases[i]);
            assert_true(e.lines <= bar * cases[i].full);
            assert_true(e.ball <= bar * cases[i].full + e.loss);
        }
        aob_rig_finish(&rigs[k]);
    }
    aob_gpu_close(gpu);
}

/* Figure 10: "shadows floating in air" behind a silhouette, where equation 10 of the same text has none. A board 3 m in
 * front of a wall, radius 0.5. */
static void test_shadow_floats_behind_a_silhouette(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {.eye = {0, 0, 6}, .fov_deg = 45};
    float volumetric[W * H], alchemy[W * H];
    struct spread halo = {0, 1, 0}, clear = {0, 1, 0};
    aob_mesh_add_quad(&mesh, aob_vec(-50, -50, 0), aob_vec(100, 0, 0), aob_vec(0, 100, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-0.5, -0.5, 3), aob_vec(1, 0, 0), aob_vec(0, 1, 0));
    aob_rig_init(&rig, &mesh, &camera, W, H, GUARD);
    run(&rig, gpu, "samples=64", volumetric);
    aob_rig_run(&rig, gpu, "alchemy", "blur=0 samples=64", AOB_FETCH_SAMPLED, alchemy);
    for (int i = 0; i < W * H; i++) {
        struct aob_vec3 p;
        if (!aob_rig_position(&rig, i % W, i / W, &p) || p.z > 1)
            continue;
        halo.least = fmin(halo.least, (double)volumetric[i]);
        clear.least = fmin(clear.least, (double)alchemy[i]);
    }
    printf("behind a board's silhouette: volumetric_obscurance falls to %.3f, alchemy to %.3f\n", halo.least,
           clear.least);
    assert_true(halo.least < 0.7);
    assert_true(clear.least > 0.995);
    aob_mesh_finish(&mesh);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* A larger radius darkens, a finer one beside it brightens; opposite pairs are of an even number. */
static void test_parameters(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float ao[W * H];
    static const char *const params[] = {"samples=64", "samples=64 radius=1", "samples=64 fine_radius=0.25",
                                         "samples=64 amplification=off", "samples=64 seed=5"};
    double mean[AOB_COUNT(params)];
    aob_rig_scene(&rig, "corner", "front", W, H, GUARD);
    for (size_t i = 0; i < AOB_COUNT(params); i++) {
        run(&rig, gpu, params[i], ao);
        mean[i] = spread_of(ao, W * H).mean;
    }
    assert_true(mean[1] < mean[0] - 0.005);
    assert_true(mean[2] > mean[0] + 0.005);
    assert_true(mean[3] < 0.6 * mean[0]);
    assert_near(mean[4], mean[0], 0.002);
    const char *why = NULL;
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        if (!strcmp((*t)->name, "volumetric_obscurance")) {
            int32_t values[16] = {0};
            for (uint32_t i = 0; i < (*t)->param_count; i++) {
                const struct aob_param *p = &(*t)->params[i];
                values[p->offset / 4] = !strcmp(p->name, "samples") ? 7 : !strcmp(p->name, "divisor");
            }
            assert_false((*t)->check(values, &why));
        }
    assert_contains(why, "even");
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* Each divisor-th pixel of an image, and between them the bilinear mean. */
static double bilinear(const float *image, int x, int y, int divisor)
{
    int left = x / divisor * divisor, top = y / divisor * divisor;
    int right = left + divisor < W ? left + divisor : left, low = top + divisor < H ? top + divisor : top;
    double u = (double)(x - left) / divisor, v = (double)(y - top) / divisor;
    return (1 - v) * ((1 - u) * (double)image[top * W + left] + u * (double)image[top * W + right]) +
           v * ((1 - u) * (double)image[low * W + left] + u * (double)image[low * W + right]);
}

/* What is drawn at a part of the size and upsampled along surfaces is nearer to the image of full size than that image's own
 * pixels at that size are, upsampled without a look at surfaces. */
static void test_divided_size(void **state)
{
    (void)state;
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    struct aob_rig rig;
    float full[W * H], low[W * H];
    aob_rig_scene(&rig, "spheres", "front", W, H, 0);
    run(&rig, gpu, "samples=64 resolutions=one divisor=1", full);
    for (int divisor = 2; divisor <= 4; divisor *= 2) {
        char params[64];
        size_t alone, phantoms;
        double sum = 0, plain = 0;
        snprintf(params, sizeof params, "samples=64 resolutions=one divisor=%d", divisor);
        run(&rig, gpu, params, low);
        phantoms = aob_half_phantoms(&rig, low, divisor, &alone);
        for (int i = 0; i < W * H; i++) {
            sum += pow((double)low[i] - (double)full[i], 2) / (W * H);
            plain += pow(bilinear(full, i % W, i / W, divisor) - (double)full[i], 2) / (W * H);
        }
        printf("volumetric_obscurance, divisor %d: RMSE %.4f to full size, %.4f where surfaces do not "
               "matter; %zu "
               "phantoms, %zu pixels alone\n",
               divisor, sqrt(sum), sqrt(plain), phantoms, alone);
        assert_int_equal(phantoms, 0);
        assert_true(sum < plain);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_wall_is_half_solid),
                                       cmocka_unit_test(test_crease_is_half_open),
                                       cmocka_unit_test(test_corner_against_closed_forms),
                                       cmocka_unit_test(test_shadow_floats_behind_a_silhouette),
                                       cmocka_unit_test(test_parameters),
                                       cmocka_unit_test(test_divided_size)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
