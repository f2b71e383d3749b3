/* The mean over time of gtao: it converges while all stands still, and keeps nothing of what has gone. */
#include "check.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include "base/memory.h"
#include "reel.h"
#include "rig.h"

enum { W = 160, H = 90, PIXELS = W * H, FRAMES = 64 };

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

static double largest(const float *a, const float *b)
{
    double worst = 0;
    for (int i = 0; i < PIXELS; i++)
        worst = fmax(worst, fabs((double)a[i] - (double)b[i]));
    return worst;
}

/* Of the logarithm of error over that of frames, by least squares. */
static double slope_of(const double errors[FRAMES])
{
    double x = 0, y = 0, xx = 0, xy = 0;
    for (int i = 0; i < FRAMES; i++) {
        double a = log(i + 1), b = log(errors[i]);
        x += a;
        y += b;
        xx += a * a;
        xy += a * b;
    }
    return (FRAMES * xy - x * y) / (FRAMES * xx - x * x);
}

static const struct {
    const char *scene, *view;
    int blur;
} views[] = {{"atrium", "nave", 0}, {"cornell", NULL, 5}, {"thicket", "edge", 5}};

/* The error to the image of many slices, whose steps move as those of the frames do. */
static void test_a_still_image_converges(void **state)
{
    (void)state;
    static float image[PIXELS], many[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    for (size_t v = 0; v < AOB_COUNT(views); v++) {
        struct aob_rig rig;
        struct aob_reel reel;
        char params[128];
        double errors[FRAMES];
        aob_rig_scene(&rig, views[v].scene, views[v].view, W, H, 0);
        snprintf(params, sizeof params, "slices=1024 blur=%d", views[v].blur);
        aob_rig_run(&rig, gpu, "gtao", params, AOB_FETCH_SAMPLED, many);
        snprintf(params, sizeof params, "history=64 blur=%d", views[v].blur);
        aob_reel_init(&reel, &rig, gpu, "gtao", params);
        for (int i = 0; i < FRAMES; i++) {
            aob_reel_draw(&reel, image);
            errors[i] = rmse(&rig, image, many);
        }
        printf("%s, blur %d: error %.5f of one frame, %.5f of 8, %.5f of 64; slope %.3f\n", views[v].scene,
               views[v].blur, errors[0], errors[7], errors[63], slope_of(errors));
        assert_true(slope_of(errors) <= -0.4);
        assert_true(errors[63] < errors[31] && errors[31] < errors[15]); /* it goes on beyond the text's 24 */
        aob_reel_finish(&reel);
        aob_rig_finish(&rig);
    }
    aob_gpu_close(gpu);
}

/* Up to `history` frames count alike, from then on the newest counts as one in so many: by hand, of images of single frames. */
static void test_weights_of_frames(void **state)
{
    (void)state;
    static float image[PIXELS], single[PIXELS], mean[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    struct aob_rig rig;
    struct aob_reel reel;
    aob_rig_scene(&rig, "atrium", "nave", W, H, 0);
    aob_reel_init(&reel, &rig, gpu, "gtao", "history=4 noise_index=3");
    for (int i = 0; i < 9; i++) {
        char params[64];
        snprintf(params, sizeof params, "noise_index=%d", 3 + i);
        aob_rig_run(&rig, gpu, "gtao", params, AOB_FETCH_SAMPLED, single);
        for (int p = 0; p < PIXELS; p++)
            mean[p] += (single[p] - mean[p]) / (float)(i < 4 ? i + 1 : 4);
        aob_reel_draw(&reel, image);
        assert_true(largest(image, mean) < 1e-6);
    }
    aob_reel_finish(&reel);
    aob_rig_run(&rig, gpu, "gtao", "history=1", AOB_FETCH_SAMPLED, image); /* none of it is laid */
    aob_rig_run(&rig, gpu, "gtao", "", AOB_FETCH_SAMPLED, single);
    assert_memory_equal(image, single, sizeof image);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* A floor before a wall, and a box that stands at x, and came there from `step` before; NAN: there is none. */
static void room_init(struct aob_rig *rig, double x, double step)
{
    static const struct aob_camera camera = {.eye = {0, 1.6, 4}, .target = {0, 0.6, -1}, .fov_deg = 50};
    const struct aob_frame_axes axes = aob_camera_axes(&camera);
    struct aob_mesh mesh = {0};
    aob_mesh_add_quad(&mesh, aob_vec(-6, 0, -2), aob_vec(0, 0, 8), aob_vec(12, 0, 0));
    aob_mesh_add_quad(&mesh, aob_vec(-6, 0, -2), aob_vec(12, 0, 0), aob_vec(0, 6, 0));
    size_t still = mesh.triangle_count;
    if (isfinite(x))
        aob_mesh_add_box(&mesh, aob_vec(x - 0.3, 0, -1.5), aob_vec(x + 0.3, 1, -0.9), 20);
    aob_rig_init(rig, &mesh, &camera, W, H, 0);
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
        struct aob_vec3 from = aob_vec_sub(point, camera.eye);
        assert_true(aob_camera_project(&camera, &rig->gbuffer.projection, from, q));
        velocity[0] = (float)(i % W + 0.5 - q[0]);
        velocity[1] = (float)(i / W + 0.5 - q[1]);
        velocity[2] = (float)-aob_vec_dot(from, axes.back);
    }
    aob_mesh_finish(&mesh);
}

/* Where the box is in frame t. All is still from frame REST on. */
typedef double path(int t);
enum { REST = 8, LAST = REST + 7 };

static double stands(int t)
{
    (void)t;
    return 0.45;
}

static double is_gone(int t)
{
    (void)t;
    return NAN;
}

static double comes(int t)
{
    return t < REST ? 0.45 - 0.1 * (REST - t) : 0.45;
}

static double creeps(int t)
{
    return t < REST ? 0.45 - 0.004 * (REST - t) : 0.45;
}

static double leaps(int t)
{
    return t < REST ? -1.2 : 0.45;
}

static double goes(int t)
{
    return t < REST ? 0.45 : NAN;
}

/* What frame LAST shows. */
static void film(struct aob_gpu *gpu, path *where, const char *params, float *pixels)
{
    struct aob_rig rigs[2];
    struct aob_reel reel;
    for (int t = 0; t <= LAST; t++) {
        struct aob_rig *rig = &rigs[t % 2];
        room_init(rig, where(t), t ? where(t) - where(t - 1) : 0);
        if (t == 0)
            aob_reel_init(&reel, rig, gpu, "gtao", params);
        aob_reel_show(&reel, rig);
        aob_reel_draw(&reel, pixels);
        if (t)
            aob_rig_finish(&rigs[(t - 1) % 2]);
    }
    aob_reel_finish(&reel);
    aob_rig_finish(&rigs[LAST % 2]);
}

/* Eight frames after all has come to rest nothing shows that anything moved: the image is as if the box had always been there. What the
 * means of 8 and of 16 frames differ by is noise, which so many samples keep below the bound. */
static void test_what_moves_leaves_no_trail(void **state)
{
    (void)state;
    static const struct {
        path *moves, *rests;
        const char *name;
        double radius;
        const char *encoding;
    } rows[] = {{comes, stands, "comes", 0.5, "r32f"},   {creeps, stands, "creeps", 1, "r32f"},
                {leaps, stands, "leaps", 0.5, "r32f"},   {goes, is_gone, "goes", 0.5, "r32f"},
                {creeps, stands, "creeps", 0.5, "r16f"}, {comes, stands, "comes", 1, "r16f"},
                {goes, is_gone, "goes", 0.5, "unorm16"}};
    static float moved[PIXELS], still[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        char params[128];
        snprintf(params, sizeof params, "radius=%g slices=24 steps=12 history=32 depth_encoding=%s",
                 rows[i].radius, rows[i].encoding);
        film(gpu, rows[i].moves, params, moved);
        film(gpu, rows[i].rests, params, still);
        printf("%s, radius %g, %s: %.5f from the still image\n", rows[i].name, rows[i].radius,
               rows[i].encoding, largest(moved, still));
        assert_true(largest(moved, still) <= 2 / 255.0);
    }
    aob_gpu_close(gpu);
}

/* A filter of a divided image carries a shadow farther than the radius. */
static void test_filters_carry_no_trail(void **state)
{
    (void)state;
    static const char *const sets[] = {"blur=33", "divisor=4 blur=9"};
    static float moved[PIXELS], still[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    for (size_t i = 0; i < AOB_COUNT(sets); i++) {
        char params[96];
        snprintf(params, sizeof params, "radius=0.5 slices=24 steps=12 history=32 %s", sets[i]);
        film(gpu, goes, params, moved);
        film(gpu, is_gone, params, still);
        printf("%s: %.5f from the still image\n", sets[i], largest(moved, still));
        assert_true(largest(moved, still) <= 2 / 255.0);
    }
    aob_gpu_close(gpu);
}

/* The last of 16 frames of a camera that goes past a corner: the mean is nearer to the image of many samples than one frame is, also by
 * the creases, which readings between pixels would wash out. */
static void test_a_moving_camera_blurs_nothing(void **state)
{
    (void)state;
    static const struct {
        double turn, ortho; /* how far the target goes along with the eye; height of an orthographic view */
    } rows[] = {{0, 0}, {0, 4}, {1, 4}};
    static float image[PIXELS], many[PIXELS], one[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    struct aob_mesh mesh = {0};
    aob_scene_find("corner")->build(&mesh);
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_rig rigs[2];
        struct aob_reel reel;
        struct aob_camera camera = {
            .eye = {2.5, 2, 4}, .target = {0, 1, 0}, .fov_deg = 60, .ortho_height = rows[i].ortho};
        for (int t = 0; t < 16; t++) {
            aob_rig_init(&rigs[t % 2], &mesh, &camera, W, H, 0);
            if (t == 0)
                aob_reel_init(&reel, &rigs[0], gpu, "gtao", "history=16");
            aob_reel_show(&reel, &rigs[t % 2]);
            aob_reel_draw(&reel, image);
            if (t)
                aob_rig_finish(&rigs[(t - 1) % 2]);
            camera.moves = true;
            camera.previous_eye = camera.eye;
            camera.previous_target = camera.target;
            camera.eye.x += 0.0267;
            camera.target.x += 0.0267 * rows[i].turn;
        }
        aob_rig_run(&rigs[1], gpu, "gtao", "slices=1024", AOB_FETCH_SAMPLED, many);
        aob_rig_run(&rigs[1], gpu, "gtao", "", AOB_FETCH_SAMPLED, one);
        printf("turn %g, orthographic %g: %.5f of the mean, %.5f of one frame\n", 1 - rows[i].turn,
               rows[i].ortho, rmse(&rigs[1], image, many), rmse(&rigs[1], one, many));
        assert_true(rmse(&rigs[1], image, many) <= rmse(&rigs[1], one, many));
        aob_reel_finish(&reel);
        aob_rig_finish(&rigs[1]);
    }
    aob_mesh_finish(&mesh);
    aob_gpu_close(gpu);
}

/* Where something moves the image is that of a single frame with the first one's noise, to the bit: on the box itself and beside it. */
static void test_what_moves_has_still_noise(void **state)
{
    (void)state;
    static float moved[PIXELS], single[PIXELS];
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    struct aob_rig rig, before;
    struct aob_reel reel;
    int box = 0, alike = 0;
    room_init(&before, 0.3, 0);
    room_init(&rig, 0.35, 0.05);
    aob_reel_init(&reel, &before, gpu, "gtao", "history=32");
    for (int i = 0; i < 5; i++)
        aob_reel_draw(&reel, NULL);
    aob_reel_show(&reel, &rig);
    aob_reel_draw(&reel, moved);
    aob_rig_run(&rig, gpu, "gtao", "", AOB_FETCH_SAMPLED, single);
    for (int i = 0; i < PIXELS; i++) {
        bool on_box = rig.gbuffer.depth[i] < 0.5f * AOB_GBUFFER_SKY && rig.hits.primitive[i] >= 4;
        box += on_box;
        alike += on_box && moved[i] == single[i];
    }
    assert_true(box > 200 && alike == box);
    assert_memory_not_equal(moved, single, sizeof moved); /* elsewhere it is a mean */
    aob_reel_finish(&reel);
    aob_rig_finish(&before);
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_still_image_converges),
                                       cmocka_unit_test(test_weights_of_frames),
                                       cmocka_unit_test(test_what_moves_leaves_no_trail),
                                       cmocka_unit_test(test_filters_carry_no_trail),
                                       cmocka_unit_test(test_a_moving_camera_blurs_nothing),
                                       cmocka_unit_test(test_what_moves_has_still_noise)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
