/* Levels of textures, areas of levels, and what textures are made for; one body for all backends: test_levels
 * vulkan|gl-egl|gl-osmesa|null. Values are small integers, so all sums are exact. */
#include <stdlib.h>
#include "base/text.h"
#include "made.h"
#include "rig.h"

enum { LEVELS = 5 }; /* of 37x11: 18x5, 9x2, 4x1, 2x1 */

static struct aob_gpu_texture *pyramid(struct aob_gpu *gpu, uint32_t uses, const void *texels)
{
    return make(gpu, (struct aob_gpu_texture_desc){.format = AOB_R32F,
                                                   .width = WIDTH,
                                                   .height = HEIGHT,
                                                   .levels = LEVELS,
                                                   .uses = uses,
                                                   .texels = texels});
}

static float *numbers(void)
{
    float *texels = AOB_NEW_ARRAY(float, TEXELS);
    for (int i = 0; i < TEXELS; i++)
        texels[i] = (float)(i * i % 1009);
    return texels;
}

/* The sum of the 2x2 texels above, those beyond the edge being those at the edge. */
static float *reduce(const float *above, int width, int height)
{
    int w = aob_gpu_level_side(width, 1), h = aob_gpu_level_side(height, 1);
    float *sums = AOB_NEW_ARRAY(float, (size_t)w *(size_t)h);
    for (int i = 0; i < 4 * w * h; i++) {
        int to = i / 4, x = 2 * (to % w) + i % 2, y = 2 * (to / w) + i / 2 % 2;
        x = x < width ? x : width - 1;
        y = y < height ? y : height - 1;
        sums[to] += above[y * width + x];
    }
    return sums;
}

static void expect_level(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, int level,
                         const float *expected)
{
    float *got = read_back(gpu, texture, level);
    int width = aob_gpu_level_side(texture->width, level),
        height = aob_gpu_level_side(texture->height, level);
    for (int i = 0; i < width * height; i++)
        if (got[i] != expected[i])
            fail_msg("level %d holds %g at %d, %d, not %g", level, (double)got[i], i % width, i / width,
                     (double)expected[i]);
    free(got);
}

static struct aob_gpu_program *reducer(struct aob_gpu *gpu, enum aob_gpu_bind_kind kind)
{
    struct aob_text glsl = {0};
    aob_text_add(&glsl, kind == AOB_GPU_SAMPLED ? "layout(BIND(2)) uniform sampler2D s;\n"
                                                  "#define SIZE textureSize(s, 0)\n"
                                                  "#define READ(p) texelFetch(s, p, 0).x\n"
                                                : "layout(r32f, BIND(2)) uniform readonly image2D s;\n"
                                                  "#define SIZE imageSize(s)\n"
                                                  "#define READ(p) imageLoad(s, p).x\n");
    aob_text_add(&glsl, "layout(location = 0) out float r;\n"
                        "void main() {\n"
                        "    ivec2 p = ivec2(gl_FragCoord.xy) * 2;\n"
                        "    r = 0.0;\n"
                        "    for (int i = 0; i < 4; i++)\n"
                        "        r += READ(min(p + ivec2(i & 1, i >> 1), SIZE - 1)); }\n");
    struct aob_gpu_program *made = program(gpu, glsl.data);
    aob_text_finish(&glsl);
    return made;
}

/* Level after level of one texture, each by a pass that reads the level above. */
static void writes_each_level_from_the_one_above(void **state)
{
    struct aob_gpu *gpu = *state;
    static const uint32_t use[] = {
        [AOB_GPU_SAMPLED] = AOB_GPU_USE_SAMPLED, [AOB_GPU_STORAGE] = AOB_GPU_USE_STORAGE};
    static const float zeros[TEXELS];
    for (enum aob_gpu_bind_kind kind = AOB_GPU_SAMPLED; kind <= AOB_GPU_STORAGE; kind++) {
        float *expected = numbers();
        struct aob_gpu_program *summer = reducer(gpu, kind);
        struct aob_gpu_texture *texture =
            pyramid(gpu, use[kind] | AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK, expected);
        for (int level = 1; level < LEVELS; level++) {
            const struct aob_gpu_bind bind = {
                .kind = kind, .binding = 2, .texture = texture, .first_level = level - 1, .level_count = 1};
            const struct aob_gpu_target target = {texture, level};
            run_pass(gpu,
                     &(struct aob_gpu_pass_desc){.program = summer,
                                                 .binds = &bind,
                                                 .bind_count = 1,
                                                 .targets = &target,
                                                 .target_count = 1},
                     NULL);
        }
        for (int level = 0; level < LEVELS; level++) {
            int width = aob_gpu_level_side(WIDTH, level), height = aob_gpu_level_side(HEIGHT, level);
            expect_level(gpu, texture, level, draws(gpu) || !level ? expected : zeros);
            float *next = reduce(expected, width, height);
            free(expected);
            expected = next;
        }
        free(expected);
        aob_gpu_texture_destroy(gpu, texture);
        aob_gpu_program_destroy(gpu, summer);
    }
}

static void fill_level(struct aob_gpu *gpu, const struct aob_gpu_target *target, int width, int height,
                       float value)
{
    struct aob_gpu_program *filler =
        program(gpu, "layout(std140, BIND(0)) uniform Block { float value; };\n"
                     "layout(location = 0) out float r;\nvoid main() { r = value; }\n");
    run_pass(gpu,
             &(struct aob_gpu_pass_desc){.program = filler,
                                         .targets = target,
                                         .target_count = 1,
                                         .width = width,
                                         .height = height,
                                         .uniforms = &value,
                                         .uniform_size = sizeof value},
             NULL);
    aob_gpu_program_destroy(gpu, filler);
}

/* Two binds of one texture show different levels, while the pass writes the one that neither shows. */
static void shows_a_range_of_levels(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_texture *texture =
        pyramid(gpu, AOB_GPU_USE_SAMPLED | AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK, NULL);
    for (int level = 0; level < LEVELS; level++)
        fill_level(gpu, &(struct aob_gpu_target){texture, level}, 0, 0, (float)(10 + level));
    struct aob_gpu_program *reader = program(
        gpu,
        "layout(BIND(1)) uniform sampler2D two;\nlayout(BIND(2)) uniform sampler2D rest;\n"
        "layout(location = 0) out float r;\n"
        "void main() {\n"
        "    vec2 q = vec2(0.5);\n"
        "    int i = int(gl_FragCoord.x);\n"
        "    r = float[](texelFetch(two, ivec2(0), 0).x, texelFetch(two, ivec2(0), 1).x,\n"
        "                textureLod(two, q, 0.4).x, textureLod(two, q, 0.6).x, textureLod(two, q, 9.0).x,\n"
        "                texelFetch(rest, ivec2(0), 0).x, textureLod(rest, q, 1.0).x,\n"
        "                textureLod(rest, q, 9.0).x, float(textureSize(two, 1).x),\n"
        "                float(textureSize(rest, 0).x))[min(i, 9)]; }\n");
    const struct aob_gpu_bind binds[] = {
        {.binding = 1, .texture = texture, .first_level = 1, .level_count = 2},
        {.binding = 2, .filter = AOB_BILINEAR, .texture = texture, .first_level = 3},
    };
    const struct aob_gpu_target target = {texture, 0};
    run_pass(gpu,
             &(struct aob_gpu_pass_desc){
                 .program = reader, .binds = binds, .bind_count = 2, .targets = &target, .target_count = 1},
             NULL);
    const float expected[] = {11, 12, 11, 12, 12, 13, 14, 14, 9, 4}, zeros[10] = {0};
    float *got = read_back(gpu, texture, 0);
    for (size_t i = 0; i < AOB_COUNT(expected); i++)
        if (got[i] != (draws(gpu) ? expected : zeros)[i])
            fail_msg("read %zu gives %g, not %g", i, (double)got[i], (double)expected[i]);
    free(got);
    for (int level = 1; level < LEVELS; level++) {
        float *kept = read_back(gpu, texture, level);
        assert_true(kept[0] == (draws(gpu) ? (float)(10 + level) : 0));
        free(kept);
    }
    aob_gpu_program_destroy(gpu, reader);
    aob_gpu_texture_destroy(gpu, texture);
}

/* What a pass finds in the upper left 7x3 texels of level 1 and leaves there; the rest must be as it was. */
static void expect_area(struct aob_gpu *gpu, const struct aob_gpu_texture *texture, const float inside[3][7],
                        float outside)
{
    float *got = read_back(gpu, texture, 1);
    int width = aob_gpu_level_side(WIDTH, 1), height = aob_gpu_level_side(HEIGHT, 1);
    for (int i = 0; i < width * height; i++) {
        int x = i % width, y = i / width;
        float expected = !draws(gpu) ? 0 : x < 7 && y < 3 ? inside[y][x] : outside;
        if (got[i] != expected)
            fail_msg("%g at %d, %d, not %g", (double)got[i], x, y, (double)expected);
    }
    free(got);
}

static void draws_an_area_and_leaves_the_rest(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_texture *texture =
        pyramid(gpu, AOB_GPU_USE_SAMPLED | AOB_GPU_USE_TARGET | AOB_GPU_USE_READ_BACK, NULL);
    const struct aob_gpu_target target = {texture, 1};
    const float six[3][7] = {{6, 6, 6, 6, 6, 6, 6}, {6, 6, 6, 6, 6, 6, 6}, {6, 6, 6, 6, 6, 6, 6}};
    fill_level(gpu, &target, 0, 0, 5);
    fill_level(gpu, &target, 7, 3, 6);
    expect_area(gpu, texture, six, 5);
    /* A triangle over the left part of the area, which is cleared first. */
    struct aob_error error = {{0}};
    struct aob_gpu_program *triangle = aob_gpu_program_create_geometry(
        gpu,
        "void main() { gl_Position = vec4(VERTEX_ID == 2 ? -0.1 : -1.0, VERTEX_ID == 1 ? 999.0 : -1.0, 0.5, "
        "1.0); }\n",
        "layout(location = 0) out float r;\nvoid main() { r = gl_FragCoord.x + 10.0 * gl_FragCoord.y; }\n",
        &error);
    if (!triangle)
        fail_msg("%s", error.text);
    struct aob_gpu_pass_desc desc = {.program = triangle,
                                     .targets = &target,
                                     .target_count = 1,
                                     .width = 7,
                                     .height = 3,
                                     .vertex_count = 3};
    const float left[3][7] = {{5.5f, 6.5f, 7.5f}, {15.5f, 16.5f, 17.5f}, {25.5f, 26.5f, 27.5f}};
    for (int round = 0; round < 2; round++) {
        desc.depth_test = round; /* a depth of the area's size bounds what GL clears, so also without */
        run_pass(gpu, &desc, NULL);
        expect_area(gpu, texture, left, 5);
    }
    aob_gpu_program_destroy(gpu, triangle);
    aob_gpu_texture_destroy(gpu, texture);
}

/* Copies `from` to a texture of its own, by way of `kind`, and compares. */
static void expect_read(struct aob_gpu *gpu, struct aob_gpu_texture *from, enum aob_gpu_bind_kind kind,
                        const float *expected)
{
    static const float zeros[TEXELS];
    struct aob_gpu_texture *to = texture(gpu, AOB_R32F, NULL);
    struct aob_gpu_program *copier = program(
        gpu, kind == AOB_GPU_SAMPLED
                 ? "layout(BIND(31)) uniform sampler2D s;\nlayout(location = 0) out float r;\n"
                   "void main() { r = texelFetch(s, ivec2(gl_FragCoord.xy), 0).x; }\n"
                 : "layout(r32f, BIND(7)) uniform readonly image2D s;\nlayout(location = 0) out float r;\n"
                   "void main() { r = imageLoad(s, ivec2(gl_FragCoord.xy)).x; }\n");
    const struct aob_gpu_bind bind = {
        .kind = kind, .binding = kind == AOB_GPU_SAMPLED ? 31 : 7, .texture = from};
    const struct aob_gpu_target target = {to, 0};
    run_pass(gpu,
             &(struct aob_gpu_pass_desc){
                 .program = copier, .binds = &bind, .bind_count = 1, .targets = &target, .target_count = 1},
             NULL);
    expect_level(gpu, to, 0, draws(gpu) ? expected : zeros);
    aob_gpu_program_destroy(gpu, copier);
    aob_gpu_texture_destroy(gpu, to);
}

/* A device may keep each set of uses in a form of its own; all hold what was put there. */
static void serves_every_set_of_uses(void **state)
{
    struct aob_gpu *gpu = *state;
    float *texels = numbers(), *drawn = AOB_NEW_ARRAY(float, TEXELS);
    for (uint32_t uses = 1; uses <= ALL_USES; uses++) {
        struct aob_gpu_texture *made = make(
            gpu, (struct aob_gpu_texture_desc){
                     .format = AOB_R32F, .width = WIDTH, .height = HEIGHT, .uses = uses, .texels = texels});
        for (int i = 0; i < TEXELS; i++)
            drawn[i] = texels[i];
        for (int round = 0; round < 2; round++) {
            if (uses & AOB_GPU_USE_READ_BACK)
                expect_level(gpu, made, 0, drawn);
            if (uses & AOB_GPU_USE_SAMPLED)
                expect_read(gpu, made, AOB_GPU_SAMPLED, drawn);
            if (uses & AOB_GPU_USE_STORAGE)
                expect_read(gpu, made, AOB_GPU_STORAGE, drawn);
            if (uses & AOB_GPU_USE_TARGET && !round)
                fill_level(gpu, &(struct aob_gpu_target){made, 0}, 9, 4, 77);
            for (int i = 0; uses & AOB_GPU_USE_TARGET && i < TEXELS; i++)
                drawn[i] = i % WIDTH < 9 && i / WIDTH < 4 ? (draws(gpu) ? 77.0f : 0.0f) : drawn[i];
        }
        aob_gpu_texture_destroy(gpu, made);
    }
    free(texels);
    free(drawn);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(writes_each_level_from_the_one_above), cmocka_unit_test(shows_a_range_of_levels),
        cmocka_unit_test(draws_an_area_and_leaves_the_rest), cmocka_unit_test(serves_every_set_of_uses)};
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
