#include "check.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "rig.h"

/* What a pass reads of a surface's material and of the light, on each backend, by a technique made for the purpose: it reads at a
 * divided size, and a second pass spreads that over the image. */

enum { W = 33, H = 19, PIXELS = W * H };

static const struct aob_shader shaders[] = {
    {"albedo", "void main() { o = vec4(aob_albedo(aob_pixel), 0.0); }\n"},
    {"shine", "void main() { o = vec4(aob_roughness(aob_pixel), aob_metalness(aob_pixel), 0.0, 0.0); }\n"},
    {"light", "void main() { o = vec4(aob_light(min(aob_pixel.x, 8)) + param.later, 0.0); }\n"},
    {"spread", "void main() { full = aob_fetch_o(aob_pixel / AOB_DIVISOR_O); share = 1.0; }\n"},
    {NULL, NULL}};

struct values {
    float later; /* lies behind the light in the block */
    int32_t divisor;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, later, .min = 0, .max = 9, .doc = "."),
    AOB_PARAM(struct values, divisor, .stage = AOB_HOST, .min = 1, .max = 4, .initial = 1, .doc = "."),
};
static const char *chosen;
static uint32_t reads;

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    aob_tex o = aob_texture(graph, .name = "o", .format = AOB_RGBA32F, .divisor = (uint32_t)v->divisor);
    aob_tex full = aob_texture(graph, .name = "full", .format = AOB_RGBA32F);
    aob_tex share = aob_texture(graph, .name = "share", .format = AOB_R8);
    return aob_pass(graph, .name = "only", .shader = chosen, .reads = reads,
                    .out = {{.name = "o", .tex = o}}) &&
           aob_pass(graph, .name = "spread", .shader = "spread", .in = {{.name = "o", .tex = o}},
                    .out = {{.name = "full", .tex = full}, {.name = "share", .tex = share}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, share) && aob_output(graph, AOB_OUT_IRRADIANCE, full);
}
static const struct aob_technique technique = {.name = "materials",
                                               .params = params,
                                               .param_count = 2,
                                               .values_size = sizeof(struct values),
                                               .shaders = shaders,
                                               .build = build};
static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};

static void read(const struct aob_rig *rig, struct aob_gpu *gpu, const char *what, int divisor,
                 enum aob_fetch fetch, float (*pixels)[3])
{
    chosen = what;
    reads = strcmp(what, "light") == 0 ? AOB_LIGHT : AOB_MATERIAL;
    aob_rig_draw(rig, gpu, &technique, &(struct values){0.25f, divisor},
                 &(struct aob_options){.fetch = (int32_t)fetch},
                 (float *[AOB_OUTPUT_COUNT]){[AOB_OUT_IRRADIANCE] = pixels[0]});
}

/* The surface that pixel i of a divided image stands for. */
static size_t surface_of(int i, int divisor)
{
    return (size_t)(i / W / divisor * divisor * W + i % W / divisor * divisor);
}

/* 8 bits of the root: the error is at most 1/255 of it, twice. */
static void check_material(const struct aob_rig *rig, struct aob_gpu *gpu, int divisor, enum aob_fetch fetch)
{
    float albedo[PIXELS][3], shine[PIXELS][3];
    int seen = 0;
    read(rig, gpu, "albedo", divisor, fetch, albedo);
    read(rig, gpu, "shine", divisor, fetch, shine);
    for (int i = 0; i < PIXELS; i++) {
        size_t at = surface_of(i, divisor);
        for (size_t c = 0; c < 3; c++) {
            double stated = (double)rig->gbuffer.albedo[3 * at + c];
            assert_near(albedo[i][c], stated, sqrt(stated) / 255 + 1e-5);
        }
        for (size_t c = 0; c < 2; c++)
            assert_near(shine[i][c], rig->gbuffer.shine[2 * at + c], 0.5 / 255 + 1e-6);
        seen += shine[i][0] > 0.1f && shine[i][0] < 0.9f;
    }
    assert_true(seen > 50);
}

static void test_material(void **state)
{
    (void)state;
    struct aob_rig rig;
    aob_rig_scene(&rig, "gallery", NULL, W, H, 0);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        for (int divisor = 1; divisor <= 4; divisor *= 2)
            check_material(&rig, gpu, divisor, divisor == 2 ? AOB_FETCH_STORAGE : AOB_FETCH_SAMPLED);
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
}

/* A scene that states no materials has base colour .8 and roughness 1 throughout, and no metal. */
static void test_default(void **state)
{
    (void)state;
    struct aob_rig rig;
    float albedo[PIXELS][3], shine[PIXELS][3];
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    aob_rig_scene(&rig, "corner", NULL, W, H, 0);
    assert_null(rig.gbuffer.albedo);
    read(&rig, gpu, "albedo", 1, AOB_FETCH_SAMPLED, albedo);
    read(&rig, gpu, "shine", 1, AOB_FETCH_SAMPLED, shine);
    for (int i = 0; i < PIXELS; i++) {
        assert_near(albedo[i][1], 0.8, 3e-3);
        assert_near(shine[i][0], 1, 0);
        assert_near(shine[i][1], 0, 0);
    }
    aob_rig_finish(&rig);
    aob_gpu_close(gpu);
}

/* All 27 numbers, turned into view space, and a parameter behind them. */
static void test_light(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_light turned;
    float pixels[PIXELS][3];
    aob_rig_scene(&rig, "corner", "far", W, H, 0);
    for (int i = 0; i < 9; i++)
        for (int c = 0; c < 3; c++)
            rig.light.sh[i][c] = 1 + 0.3 * i - 0.1 * c * i * i;
    struct aob_frame_axes axes = aob_camera_axes(&rig.camera);
    aob_light_turn(&rig.light, &axes, &turned);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        read(&rig, gpu, "light", 1, AOB_FETCH_SAMPLED, pixels);
        for (int i = 0; i < 9; i++)
            for (int c = 0; c < 3; c++)
                assert_near(pixels[i][c], turned.sh[i][c] + 0.25, 2e-6);
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_material), cmocka_unit_test(test_default),
                                       cmocka_unit_test(test_light)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
