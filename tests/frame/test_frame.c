#include "check.h"
#include <math.h>
#include <stdlib.h>
#include "base/memory.h"
#include "rig.h"

/* A frame that is run again and again: uniforms that change between runs, outputs beside visibility, levels. */

enum { W = 101, H = 59, LEVELS = 4 };

struct values {
    float scale, offset;
    int32_t levels;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, scale, .min = 0, .max = 9, .doc = "."),
    AOB_PARAM(struct values, levels, .stage = AOB_CONSTANT, .min = 0, .max = 9, .doc = "."),
    AOB_PARAM(struct values, offset, .min = 0, .max = 9, .doc = "."),
};
static const struct aob_shader shaders[] = {
    {"moving", "void main() {\n"
               "    visibility = param.scale * 0.125 + param.offset * 0.25 + float(aob_frame) / 64.0;\n"
               "    bent = vec4(float(aob_pixel.x), -float(aob_pixel.y), param.scale, 9.0);\n}\n"},
    {"packed", "void main() { both = vec4(float(aob_pixel.x), -float(aob_pixel.y), param.scale, 0.125); }\n"},
    {"place", "void main() { place = vec2(aob_pixel) / 128.0; flat_place = place; }\n"},
    {"flat", "void main() { vec2 uv = (vec2(aob_pixel) + 0.5) / vec2(aob_target_size);\n"
             "    o = vec4(aob_sample_place(uv), aob_sample_place(vec2(2.0))); }\n"},
    {"coarser", "void main() { place = 0.5 * aob_fetch_finer(2 * aob_pixel) + vec2(AOB_DIVISOR) / 16.0; }\n"},
    /* Level l of texel p holds p / 128 + (2^1 + ... + 2^l, weighed by halves) / 16, which the test computes. */
    {"fetch", "void main() { o = vec4(aob_fetch_place(aob_pixel >> LEVEL, LEVEL - FIRST),\n"
              "    aob_fetch_place(ivec2(1000), 99)); }\n"},
    {"sample",
     "void main() { vec2 uv = (vec2(aob_pixel) + 0.5) / vec2(aob_target_size);\n"
     "    o = vec4(aob_sample_place(uv, LEVEL - FIRST), aob_sample_place(vec2(2.0), LEVEL - FIRST)); }\n"},
    {NULL, NULL}};

static bool build_moving(struct aob_graph *graph, const void *values)
{
    /* What no real technique should do: a uniform that decides the passes. */
    float offset = ((const struct values *)values)->offset;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R32F),
            bent = aob_texture(graph, .name = "bent", .format = AOB_RGBA32F, .levels = 2); /* 102x60 */
    return aob_pass(graph, .name = "only", .shader = "moving", .defines = {{"FAR", offset >= 8}},
                    .out = {{.name = "visibility", .tex = visibility}, {.name = "bent", .tex = bent}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility) && aob_output(graph, AOB_OUT_BENT_NORMAL, bent);
}

static const char *reader;
static int first, level;

static bool build_levels(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex place = aob_texture(graph, .name = "place", .format = AOB_RG32F, .levels = LEVELS),
            flat = aob_texture(graph, .name = "flat", .format = AOB_RG32F),
            o = aob_texture(graph, .name = "o", .format = AOB_RGBA32F);
    bool is_flat = strcmp(reader, "flat") == 0;
    aob_pass(graph, .name = "level_0", .shader = "place",
             .out = {{.name = "place", .tex = place}, {.name = "flat_place", .tex = flat}});
    for (uint32_t l = 1; l < LEVELS; l++) {
        char name[] = "level_0";
        name[6] = (char)('0' + l);
        aob_pass(graph, .name = name, .shader = "coarser",
                 .in = {{.name = "finer", .tex = place, .level = l - 1}},
                 .out = {{.name = "place", .tex = place, .level = l}});
    }
    enum aob_filter filter = strcmp(reader, "fetch") == 0 ? AOB_NEAREST : AOB_BILINEAR;
    return aob_pass(graph, .name = "reader", .shader = reader,
                    .defines = {{"LEVEL", level}, {"FIRST", first}},
                    .in = {{.name = "place",
                            .tex = is_flat ? flat : place,
                            .level = (uint32_t)first,
                            .filter = filter}},
                    .out = {{.name = "o", .tex = o}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, o);
}

/* Both outputs in one texture, where the visibility is the last component. */
static bool build_packed(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex both = aob_texture(graph, .name = "both", .format = AOB_RGBA32F);
    return aob_pass(graph, .name = "only", .shader = "packed", .out = {{.name = "both", .tex = both}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, both) && aob_output(graph, AOB_OUT_BENT_NORMAL, both);
}

static struct aob_technique technique = {.abi = AOB_ABI,
                                         .size = sizeof technique,
                                         .name = "trial",
                                         .title = "t",
                                         .citation = "c",
                                         .params = params,
                                         .param_count = 3,
                                         .values_size = sizeof(struct values),
                                         .shaders = shaders};

static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};

struct stage {
    struct aob_rig rig;
    struct aob_gpu *gpu;
    struct aob_screen screen;
    struct aob_frame frame;
};

static void stage_init(struct stage *stage, const char *backend, int guard, enum aob_fetch fetch,
                       bool (*build)(struct aob_graph *, const void *))
{
    struct aob_error error = {{0}};
    technique.build = build;
    stage->gpu = aob_rig_gpu(backend);
    aob_rig_scene(&stage->rig, "spheres", NULL, W, H, guard);
    if (!aob_screen_init(&stage->screen, stage->gpu, &stage->rig.gbuffer,
                         &(struct aob_options){.fetch = (int32_t)fetch}, &error) ||
        !aob_frame_init_desc(&stage->frame, &stage->screen,
                             &(struct aob_frame_desc){.technique = &technique,
                                                      .values = &(struct values){.scale = 1},
                                                      .fetch = fetch,
                                                      .wanted = 1u << AOB_OUT_BENT_NORMAL},
                             &error))
        fail_msg("%s: %s", backend, error.text);
}

static void stage_finish(struct stage *stage)
{
    aob_frame_finish(&stage->frame);
    aob_screen_finish(&stage->screen);
    aob_rig_finish(&stage->rig);
    aob_gpu_close(stage->gpu);
}

static void run(struct stage *stage, enum aob_output which, int components, float *pixels)
{
    struct aob_error error = {{0}};
    if (!aob_frame_run(&stage->frame, 1, NULL, &error) ||
        !aob_frame_read(&stage->frame, which, components, pixels, &error))
        fail_msg("%s", error.text);
}

static float run_with(struct stage *stage, int number, float scale, float offset)
{
    static float pixels[W * H];
    struct aob_error error = {{0}};
    if (!aob_frame_set(&stage->frame, number, &(struct values){.scale = scale, .offset = offset}, &error))
        fail_msg("%s", error.text);
    run(stage, AOB_OUT_VISIBILITY, 1, pixels);
    for (int i = 1; i < W * H; i++)
        assert_true(pixels[i] == pixels[0]);
    return pixels[0];
}

static void test_uniforms_change_between_runs(void **state)
{
    (void)state;
    struct aob_error error;
    struct stage *stage = AOB_NEW(struct stage);
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        stage_init(stage, backends[b], 0, AOB_FETCH_SAMPLED, build_moving);
        float *pixels = AOB_NEW_ARRAY(float, W *H);
        run(stage, AOB_OUT_VISIBILITY, 1, pixels);
        assert_true(pixels[0] ==
                    0.125f); /* before anything is set: frame 0 and the values it was made with */
        assert_true(run_with(stage, 0, 2, 0) == 0.25f);
        assert_true(run_with(stage, 0, 2, 1) == 0.5f);
        assert_true(run_with(stage, 7, 2, 1) == 0.5f + 7 / 64.0f);
        assert_true(run_with(stage, 0, 1, 0) == 0.125f); /* the same as at first */
        run(stage, AOB_OUT_VISIBILITY, 1, pixels);       /* and again without setting */
        assert_true(pixels[0] == 0.125f);
        assert_false(aob_frame_set(&stage->frame, 0, &(struct values){.scale = 1, .levels = 2}, &error));
        assert_contains(error.text, "trial: parameter 'levels' is no uniform");
        assert_false(aob_frame_set(&stage->frame, 3, &(struct values){.scale = 2, .offset = 8}, &error));
        assert_contains(error.text, "trial: these values lay out other passes");
        run(stage, AOB_OUT_VISIBILITY, 1, pixels); /* a refusal changes neither number nor values */
        assert_true(pixels[0] == 0.125f);
        assert_true(run_with(stage, 1, 1, 0) == 0.125f + 1 / 64.0f);
        free(pixels);
        stage_finish(stage);
    }
    free(stage);
}

static void read_both(const char *backend, int guard, bool (*build)(struct aob_graph *, const void *))
{
    struct stage *stage = AOB_NEW(struct stage);
    float(*bent)[3] = aob_alloc(W * H, sizeof *bent), *visibility = AOB_NEW_ARRAY(float, W *H);
    stage_init(stage, backend, guard, AOB_FETCH_SAMPLED, build);
    assert_true(aob_graph_gives(&stage->frame.graph, AOB_OUT_BENT_NORMAL));
    run(stage, AOB_OUT_BENT_NORMAL, 3, &bent[0][0]);
    run(stage, AOB_OUT_VISIBILITY, 1, visibility);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const float *n = bent[y * W + x];
            assert_true(n[0] == (float)(x + guard) && n[1] == -(float)(y + guard) && n[2] == 1);
            assert_true(visibility[y * W + x] == 0.125f);
        }
    stage_finish(stage);
    free(visibility);
    free(bent);
    free(stage);
}

/* All components of both outputs, in a texture each and in one; with and without a guard band, whose pixels are cropped. */
static void test_bent_normal_is_read(void **state)
{
    (void)state;
    for (size_t b = 0; b < AOB_COUNT(backends); b++)
        for (int guard = 0; guard <= 8; guard += 8) {
            read_both(backends[b], guard, build_moving);
            read_both(backends[b], guard, build_packed);
        }
}

/* What `coarser` leaves in texel p of a level. */
static double place_at(int p, int l)
{
    double value = p * (1 << l) / 128.0; /* of the finest level */
    for (int k = 1; k <= l; k++)
        value = 0.5 * value + (1 << k) / 16.0;
    return value;
}

static int side(int whole, int l)
{
    return (whole + (1 << l) - 1) >> l;
}

static void check_levels(const char *backend, enum aob_fetch fetch)
{
    struct stage *stage = AOB_NEW(struct stage);
    float(*o)[4] = aob_alloc(W * H, sizeof *o);
    reader = "fetch";
    for (first = 0; first < LEVELS; first++)
        for (level = first; level < LEVELS; level++) {
            stage_init(stage, backend, 0, fetch, build_levels);
            run(stage, AOB_OUT_VISIBILITY, 4, &o[0][0]);
            for (int y = 0; y < H; y++)
                for (int x = 0; x < W; x++) {
                    assert_near(o[y * W + x][0], place_at(x >> level, level), 1e-6);
                    assert_near(o[y * W + x][1], place_at(y >> level, level), 1e-6);
                }
            /* Beyond the coarsest level and its last texel: those. */
            assert_near(o[0][2], place_at(side(W, LEVELS - 1) - 1, LEVELS - 1), 1e-6);
            assert_near(o[0][3], place_at(side(H, LEVELS - 1) - 1, LEVELS - 1), 1e-6);
            stage_finish(stage);
        }
    free(o);
    free(stage);
}

static void test_levels_are_fetched(void **state)
{
    (void)state;
    for (size_t b = 0; b < AOB_COUNT(backends); b++)
        for (int fetch = AOB_FETCH_SAMPLED; fetch <= AOB_FETCH_STORAGE; fetch++)
            check_levels(backends[b], (enum aob_fetch)fetch);
}

/* Bilinear reads know what the view fills of a level, whose texture is larger: 101x59 pixels lie in 104x64. */
static void test_levels_are_sampled(void **state)
{
    (void)state;
    struct stage *stage = AOB_NEW(struct stage);
    float(*o)[4] = aob_alloc(W * H, sizeof *o);
    for (size_t b = 0; b < AOB_COUNT(backends); b++)
        for (level = 0; level < LEVELS; level++) {
            first = level >
                    0; /* level 0 is that of the texture of one level that is drawn with the first of four */
            reader = level > 0 ? "sample" : "flat";
            stage_init(stage, backends[b], 0, AOB_FETCH_STORAGE, build_levels);
            run(stage, AOB_OUT_VISIBILITY, 4, &o[0][0]);
            double slope = place_at(1, level) - place_at(0, level);
            int w = side(W, level), h = side(H, level);
            for (int x = 0; x < W; x++) {
                double place = fmin(fmax((x + 0.5) / W * w - 0.5, 0), w - 1);
                assert_near(o[x][0], place_at(0, level) + slope * place, 2e-3 * slope + 1e-6);
            }
            assert_near(o[0][2], place_at(w - 1, level), 2e-3 * slope);
            assert_near(o[0][3], place_at(h - 1, level), 2e-3 * slope);
            stage_finish(stage);
        }
    free(o);
    free(stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_uniforms_change_between_runs), cmocka_unit_test(test_bent_normal_is_read),
        cmocka_unit_test(test_levels_are_fetched), cmocka_unit_test(test_levels_are_sampled)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
