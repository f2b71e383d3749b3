/* The mean over time of gtao: it converges while all stands still, and keeps nothing of what has gone. */
#include "check.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"
#include "reel.h"

enum { W = 160, H = 90, PIXELS = W * H };

static double rmse(const struct aob_rig *rig, const float *a, const float *b)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < PIXELS; i++)
        if (rig->gbuffer.depth[i] < 0.5f * AOB_GBUFFER_SKY) {
            sum += pow((double)a[i] - (double)b[i], 2);
            count++;
        }
    return sqrt(sum / count);
}

/* The slope of the logarithms of error over frames. */
static double slope_of(const double *errors, int count)
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int i = 0; i < count; i++) {
        double a = log(i + 1), b = log(errors[i]);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    return (count * xy - x * y) / (count * xx - x * x);
}

static void test_still(void **state)
{
    (void)state;
    static const char *const views[][2] = {{"atrium", "nave"}, {"cornell", NULL}, {"thicket", "edge"}};
    static float image[PIXELS], many[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    for (int v = 0; v < 3; v++)
        for (int blur = 0; blur <= 5; blur += 5) {
            struct aob_rig rig;
            struct aob_reel reel;
            char params[128];
            double errors[64];
            aob_rig_scene(&rig, views[v][0], views[v][1], W, H, 0);
            snprintf(params, sizeof params, "slices=1024 blur=%d", blur);
            aob_rig_run(&rig, gpu, "gtao", params, AOB_FETCH_SAMPLED, many);
            snprintf(params, sizeof params, "history=64 blur=%d", blur);
            aob_reel_init(&reel, &rig, gpu, "gtao", params);
            for (int i = 0; i < 64; i++) {
                aob_reel_draw(&reel, image);
                errors[i] = rmse(&rig, image, many);
            }
            printf("%s blur %d: 1 %.5f 2 %.5f 4 %.5f 8 %.5f 16 %.5f 24 %.5f 32 %.5f 64 %.5f slope %.3f\n", views[v][0], blur, errors[0],
                   errors[1], errors[3], errors[7], errors[15], errors[23], errors[31], errors[63], slope_of(errors, 64));
            aob_reel_finish(&reel);
            aob_rig_finish(&rig);
        }
    aob_gpu_close(gpu);
}

/* A floor before a wall, and a box that stands at x, and came there from `step` before; NAN: there is none. */
static void room_init(struct aob_rig *rig, const struct aob_camera *camera, double x, double step)
{
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-6, 0, -2), aob_vec(0, 0, 8), aob_vec(12, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-6, 0, -2), aob_vec(12, 0, 0), aob_vec(0, 6, 0));
    size_t still = mesh.triangle_count;
    if (isfinite(x))
        aob_mesh_add_box(&mesh, aob_vec(x - 0.3, 0, -1.5), aob_vec(x + 0.3, 1, -0.9), 20);
    aob_rig_init(rig, &mesh, camera, W, H, 0);
    const struct aob_camera before = aob_camera_previous(camera);
    const struct aob_frame_axes axes = aob_camera_axes(&before);
    rig->gbuffer.velocity = AOB_NEW_ARRAY(float, 3 * PIXELS);
    for (int i = 0; i < PIXELS; i++) {
        struct aob_vec3 point;
        double q[2];
        float *velocity = &rig->gbuffer.velocity[3 * i];
        velocity[2] = AOB_GBUFFER_SKY;
        if (!aob_rig_position(rig, i % W, i / W, &point))
            continue;
        if (rig->hits.primitive[i] >= still)
            point.x -= step;
        struct aob_vec3 from = aob_vec_sub(point, before.eye);
        assert_true(aob_camera_project(&before, &rig->gbuffer.projection, from, q));
        velocity[0] = (float)(i % W + 0.5 - q[0]);
        velocity[1] = (float)(i / W + 0.5 - q[1]);
        velocity[2] = (float)-aob_vec_dot(from, axes.back);
    }
    aob_mesh_finish(&mesh);
}

static const struct aob_camera watching = {.eye = {0, 1.6, 4}, .target = {0, 0.6, -1}, .fov_deg = 50};

/* Where the box is in frame t of a sequence, and what its step was. */
typedef double path(int t);

static double stays(int t)
{
    (void)t;
    return 0.45;
}

static double comes(int t) { return t < 8 ? 0.45 - 0.1 * (8 - t) : 0.45; }
static double creeps(int t) { return t < 8 ? 0.45 - 0.004 * (8 - t) : 0.45; }
static double leaps(int t) { return t < 8 ? -1.2 : 0.45; }
static double is_gone(int t)
{
    (void)t;
    return NAN;
}
static double goes(int t) { return t < 8 ? 0.45 : NAN; }

/* What frame `last` shows. */
static void film(struct aob_gpu *gpu, path *where, int first, int last, const char *params, float *pixels)
{
    struct aob_rig rigs[2];
    struct aob_reel reel;
    for (int t = first; t <= last; t++) {
        struct aob_rig *rig = &rigs[t % 2];
        double step = t > first ? where(t) - where(t - 1) : 0;
        room_init(rig, &watching, where(t), step);
        if (t == first)
            aob_reel_init(&reel, rig, gpu, "gtao", params);
        aob_reel_show(&reel, rig);
        aob_reel_draw(&reel, pixels);
        if (t > first)
            aob_rig_finish(&rigs[(t - 1) % 2]);
    }
    aob_reel_finish(&reel);
    aob_rig_finish(&rigs[last % 2]);
}

static double largest(const float *a, const float *b)
{
    double worst = 0;
    for (int i = 0; i < PIXELS; i++)
        worst = fmax(worst, fabs((double)a[i] - (double)b[i]));
    return worst;
}

static void test_no_trail(void **state)
{
    (void)state;
    static const struct {
        path *moves, *stands;
        const char *name;
    } rows[] = {{comes, stays, "comes"}, {creeps, stays, "creeps"}, {leaps, stays, "leaps"}, {goes, is_gone, "goes"}};
    static float moved[PIXELS], stood[PIXELS], anew[PIXELS];
    static const char *params[] = {"radius=0.5 slices=9 steps=12 history=32", "radius=1 slices=9 steps=12 history=32"};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    for (size_t i = 0; i < AOB_COUNT(rows); i++)
        for (int p = 0; p < 2; p++) {
            char late[128];
            snprintf(late, sizeof late, "%s noise_index=8", params[p]);
            film(gpu, rows[i].moves, 0, 15, params[p], moved);
            film(gpu, rows[i].stands, 0, 15, params[p], stood);
            film(gpu, rows[i].stands, 8, 15, late, anew);
            double least = 0; int where = 0, over = 0;
            for (int k = 0; k < PIXELS; k++) { double d = fmin(fabs((double)moved[k]-(double)stood[k]), fabs((double)moved[k]-(double)anew[k])); if (d > least) { least = d; where = k; } over += d > 2/255.0; }
            printf("%s %s: largest %.5f, of the nearer %.5f at %d,%d: %.3f %.3f %.3f over %d; stood-anew %.5f\n", rows[i].name, params[p], largest(moved, stood), least, where % W, where / W, (double)moved[where], (double)stood[where], (double)anew[where], over, largest(stood, anew));
        }
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_still), cmocka_unit_test(test_no_trail)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
