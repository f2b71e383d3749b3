/* The mean over time where the depths of two frames are rounded, each in its own way: a surface that the camera goes past is still found
 * again. */
#include "check.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "reel.h"
#include "rig.h"

enum { W = 160, H = 90, PIXELS = W * H, FRAMES = 16 };

/* A camera that goes past a corner. */
static const struct walk {
    double ortho; /* height of an orthographic view, or 0 */
} walks[] = {{0}, {4}};

struct outcome {
    double frames, mean, one; /* the mean number of frames that count; error of the mean, and of one frame */
};

/* Of the surfaces in the last frame. */
static double count_frames(const struct aob_reel *reel, const struct aob_rig *rig)
{
    static float surface[PIXELS][4];
    struct aob_error error = {""};
    const struct aob_pass_graph *graph = &reel->frame.graph;
    double sum = 0, count = 0;
    int index = 0;
    while (strcmp(graph->textures[index].name, "open_surface") != 0)
        index++;
    if (!aob_gpu_texture_read(reel->gpu, aob_frame_texture(&reel->frame, index), 0, surface, &error))
        fail_msg("%s", error.text);
    for (int i = 0; i < PIXELS; i++) {
        bool is_surface = rig->gbuffer.depth[i] < 0.5f * AOB_GBUFFER_SKY;
        sum += is_surface ? (double)surface[i][3] : 0;
        count += is_surface;
    }
    return sum / count;
}

static double rmse(const struct aob_rig *rig, const float *a, const float *b)
{
    double sum = 0, count = 0;
    for (int i = 0; i < PIXELS; i++)
        if (rig->gbuffer.depth[i] < 0.5f * AOB_GBUFFER_SKY) {
            sum += pow((double)a[i] - (double)b[i], 2);
            count++;
        }
    return sqrt(sum / count);
}

static struct outcome go(struct aob_gpu *gpu, const struct walk *walk, const char *options)
{
    static float image[PIXELS], many[PIXELS], one[PIXELS];
    struct aob_rig rigs[2];
    struct aob_reel reel;
    struct aob_mesh mesh = {0};
    struct aob_camera camera = {
        .eye = {2.5, 2, 4}, .target = {0, 1, 0}, .fov_deg = 60, .ortho_height = walk->ortho};
    struct outcome outcome;
    char params[128];
    aob_scene_find("corner")->build(&mesh);
    for (int t = 0; t < FRAMES; t++) {
        aob_rig_init(&rigs[t % 2], &mesh, &camera, W, H, 0);
        snprintf(params, sizeof params, "history=16 %s", options);
        if (t == 0)
            aob_reel_init(&reel, &rigs[0], gpu, "gtao", params);
        aob_reel_show(&reel, &rigs[t % 2]);
        aob_reel_draw(&reel, image);
        if (t)
            aob_rig_finish(&rigs[(t - 1) % 2]);
        camera.moves = true;
        camera.previous_eye = camera.eye;
        camera.previous_target = camera.target;
        camera.eye.x += 0.0267;
    }
    snprintf(params, sizeof params, "slices=1024 %s", options);
    aob_rig_run(&rigs[1], gpu, "gtao", params, AOB_FETCH_SAMPLED, many);
    aob_rig_run(&rigs[1], gpu, "gtao", options, AOB_FETCH_SAMPLED, one);
    outcome = (struct outcome){count_frames(&reel, &rigs[1]), rmse(&rigs[1], image, many),
                               rmse(&rigs[1], one, many)};
    aob_reel_finish(&reel);
    aob_rig_finish(&rigs[1]);
    aob_mesh_finish(&mesh);
    return outcome;
}

/* Rounded depths lie off the plane of a surface, in each frame by as much as the encoding's step. The mean has to be of as many frames as
 * with depths that are not rounded, and nearer to the image of many samples than one frame is. */
static void test_rounded_depths_keep_their_history(void **state)
{
    (void)state;
    static const char *const encodings[] = {"r32f", "r16f", "unorm16"};
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    for (size_t w = 0; w < AOB_COUNT(walks); w++) {
        double exact = 0;
        for (size_t e = 0; e < AOB_COUNT(encodings); e++) {
            char options[96];
            snprintf(options, sizeof options, "depth_encoding=%s", encodings[e]);
            const struct outcome is = go(gpu, &walks[w], options);
            exact = e ? exact : is.frames;
            printf("%s, %s: %.3f frames, %.5f of the mean, %.5f of one frame\n",
                   walks[w].ortho ? "orthographic" : "perspective", encodings[e], is.frames, is.mean, is.one);
            assert_true(is.frames > 3.5 && fabs(is.frames - exact) < 0.02 * exact);
            assert_true(is.mean < is.one);
        }
    }
    aob_gpu_close(gpu);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rounded_depths_keep_their_history)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
