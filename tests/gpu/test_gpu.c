/* One body for all backends: test_gpu vulkan|gl-egl|gl-osmesa|null. */
#include <stdlib.h>
#include "base/text.h"
#include "made.h"
#include "random.h"
#include "rig.h"

/* Runs a text that has one output and no inputs. */
static void *draw(struct aob_gpu *gpu, const char *glsl, enum aob_format format)
{
    struct aob_gpu_program *drawer = program(gpu, glsl);
    struct aob_gpu_texture *target = texture(gpu, format, NULL);
    const struct aob_gpu_target targets[] = {{target, 0}};
    run_pass(gpu, &(struct aob_gpu_pass_desc){.program = drawer, .targets = targets, .target_count = 1},
             NULL);
    void *texels = read_back(gpu, target, 0);
    aob_gpu_program_destroy(gpu, drawer);
    aob_gpu_texture_destroy(gpu, target);
    return texels;
}

/* Normal numbers only: what a driver does to infinities and denormals is its own affair. */
static void *random_texels(enum aob_format format)
{
    size_t size = aob_gpu_texel_size(format) / (size_t)aob_gpu_texel_components(format);
    size_t count = TEXELS * (size_t)aob_gpu_texel_components(format);
    uint8_t *texels = aob_alloc(count, size);
    uint32_t state = 1;
    for (size_t i = 0; i < count; i++) {
        random_next(&state);
        uint32_t random = state >> 3 ^ state;
        uint32_t half = (random & 0x83ff) | (1 + (random >> 16) % 30) << 10;
        uint32_t single = (random & 0x807fffff) | (1 + (state >> 11) % 254) << 23;
        uint32_t value = size == 1 ? random : size == 2 ? half : single;
        memcpy(texels + i * size, &value, size);
    }
    return texels;
}

static size_t byte_count(enum aob_format format)
{
    return TEXELS * aob_gpu_texel_size(format);
}

static void keeps_texels_of_every_format(void **state)
{
    struct aob_gpu *gpu = *state;
    for (enum aob_format format = 0; format < AOB_FORMAT_COUNT; format++) {
        void *texels = random_texels(format);
        struct aob_gpu_texture *made = texture(gpu, format, texels);
        void *got = read_back(gpu, made, 0);
        assert_memory_equal(got, texels, byte_count(format));
        aob_gpu_texture_destroy(gpu, made);
        free(got);
        free(texels);
    }
}

static void expect_copy(struct aob_gpu *gpu, enum aob_format format, enum aob_gpu_bind_kind kind)
{
    struct aob_text glsl = {0};
    if (kind == AOB_GPU_SAMPLED)
        aob_text_add(&glsl,
                     "layout(BIND(3)) uniform sampler2D source;\n#define READ(p) texelFetch(source, p, 0)\n");
    else
        aob_text_add(
            &glsl,
            "layout(%s, BIND(3)) uniform readonly image2D source;\n#define READ(p) imageLoad(source, p)\n",
            aob_gpu_format_layout(format));
    aob_text_add(&glsl,
                 "layout(location = 0) out vec4 r;\nvoid main() { r = READ(ivec2(gl_FragCoord.xy)); }\n");
    void *texels = random_texels(format);
    struct aob_gpu_texture *source = texture(gpu, format, texels), *target = texture(gpu, format, NULL);
    struct aob_gpu_program *copier = program(gpu, glsl.data);
    struct aob_gpu_bind bind = {.kind = kind, .binding = 3, .texture = source};
    const struct aob_gpu_target targets[] = {{target, 0}};
    run_pass(gpu,
             &(struct aob_gpu_pass_desc){
                 .program = copier, .binds = &bind, .bind_count = 1, .targets = targets, .target_count = 1},
             NULL);
    void *got = read_back(gpu, target, 0);
    if (!draws(gpu))
        memset(texels, 0, byte_count(format));
    if (memcmp(got, texels, byte_count(format)))
        fail_msg("%s, read as %s, changed", aob_gpu_format_layout(format),
                 kind == AOB_GPU_SAMPLED ? "a sampled texture" : "a storage image");
    aob_gpu_program_destroy(gpu, copier);
    aob_gpu_texture_destroy(gpu, source);
    aob_gpu_texture_destroy(gpu, target);
    aob_text_finish(&glsl);
    free(got);
    free(texels);
}

static void copies_every_format_through_a_pass(void **state)
{
    for (enum aob_format format = 0; format < AOB_FORMAT_COUNT; format++) {
        expect_copy(*state, format, AOB_GPU_SAMPLED);
        expect_copy(*state, format, AOB_GPU_STORAGE);
    }
}

static void puts_row_0_at_the_top(void **state)
{
    struct aob_gpu *gpu = *state;
    float *got =
        draw(gpu, "layout(location = 0) out vec2 r;\nvoid main() { r = gl_FragCoord.xy; }\n", AOB_RG32F);
    for (int i = 0; i < TEXELS; i++) {
        assert_true(got[2 * i] == (draws(gpu) ? (float)(i % WIDTH) + .5f : 0));
        assert_true(got[2 * i + 1] == (draws(gpu) ? (float)(i / WIDTH) + .5f : 0));
    }
    free(got);
}

static void writes_eight_targets(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_program *drawer = program(
        gpu, "layout(location = 0) out float a;\n"
             "layout(location = 1) out vec2 b;\n"
             "layout(location = 2) out vec4 c;\n"
             "layout(location = 3) out vec4 d;\n"
             "layout(location = 4) out float e;\n"
             "layout(location = 5) out vec2 f;\n"
             "layout(location = 6) out float g;\n"
             "layout(location = 7) out vec4 h;\n"
             "void main() { a = 0.25; b = vec2(1, 2); c = vec4(3, 4, 5, 6);\n"
             "              d = vec4(0, 1, 1, 0); e = 1; f = vec2(1, 0); g = -8; h = vec4(7, 8, 9, 10); }\n");
    static const enum aob_format formats[] = {AOB_R32F, AOB_RG32F, AOB_RGBA32F, AOB_RGBA8,
                                              AOB_R16,  AOB_RG8,   AOB_R32F,    AOB_RGBA32F};
    const float a[] = {0.25f}, b[] = {1, 2}, c[] = {3, 4, 5, 6}, g[] = {-8}, h[] = {7, 8, 9, 10};
    const uint8_t d[] = {0, 255, 255, 0}, e[] = {255, 255}, f[] = {255, 0}, zero[16] = {0};
    const void *const expected[] = {a, b, c, d, e, f, g, h};
    struct aob_gpu_texture *made[AOB_MAX_OUT];
    struct aob_gpu_target targets[AOB_MAX_OUT] = {{0}};
    assert_int_equal(AOB_COUNT(formats), AOB_MAX_OUT);
    for (size_t i = 0; i < AOB_MAX_OUT; i++)
        targets[i].texture = made[i] = texture(gpu, formats[i], NULL);
    run_pass(gpu,
             &(struct aob_gpu_pass_desc){.program = drawer, .targets = targets, .target_count = AOB_MAX_OUT},
             NULL);
    for (size_t i = 0; i < AOB_MAX_OUT; i++) {
        size_t size = aob_gpu_texel_size(formats[i]);
        uint8_t *got = read_back(gpu, made[i], 0);
        for (size_t k = 0; k < TEXELS; k++)
            assert_memory_equal(got + k * size, draws(gpu) ? expected[i] : zero, size);
        free(got);
        aob_gpu_texture_destroy(gpu, made[i]);
    }
    aob_gpu_program_destroy(gpu, drawer);
}

static void filters_and_clamps(void **state)
{
    struct aob_gpu *gpu = *state;
    const float pair[] = {2, 4};
    struct aob_gpu_texture *source = make(
        gpu, (struct aob_gpu_texture_desc){
                 .format = AOB_R32F, .width = 2, .height = 1, .uses = AOB_GPU_USE_SAMPLED, .texels = pair});
    struct aob_gpu_texture *target = texture(gpu, AOB_RGBA32F, NULL);
    struct aob_gpu_program *drawer = program(
        gpu, "layout(BIND(1)) uniform sampler2D soft;\nlayout(BIND(2)) uniform sampler2D hard;\n"
             "layout(location = 0) out vec4 r;\n"
             "void main() { r = vec4(texture(soft, vec2(0.5)).x, texture(hard, vec2(0.6, 0.5)).x,\n"
             "                       texture(soft, vec2(-3, 0.5)).x, texture(soft, vec2(9, 2)).x); }\n");
    const struct aob_gpu_bind binds[] = {
        {.binding = 1, .filter = AOB_BILINEAR, .texture = source},
        {.binding = 2, .filter = AOB_NEAREST, .texture = source},
    };
    const struct aob_gpu_target targets[] = {{target, 0}};
    run_pass(gpu,
             &(struct aob_gpu_pass_desc){
                 .program = drawer, .binds = binds, .bind_count = 2, .targets = targets, .target_count = 1},
             NULL);
    float *got = read_back(gpu, target, 0);
    const float expected[] = {3, 4, 2, 4};
    if (draws(gpu))
        assert_memory_equal(got, expected, sizeof expected);
    free(got);
    aob_gpu_program_destroy(gpu, drawer);
    aob_gpu_texture_destroy(gpu, source);
    aob_gpu_texture_destroy(gpu, target);
}

static void replaced_functions_mean_what_glsl_says(void **state)
{
    struct aob_gpu *gpu = *state;
    float *got = draw(
        gpu,
        "layout(location = 0) out vec4 r;\n"
        "void main() {\n"
        "    float a = dot(vec3(1, 2, 3), vec3(4, 5, 6)) + length(vec2(3, 4)) + distance(vec4(1), vec4(2));\n"
        "    float b = normalize(vec3(0, 0, 4)).z + mix(1.0, 3.0, 0.5) + length(-2.0) + normalize(-3.0);\n"
        "    vec2 c = mix(vec2(1, 2), vec2(3, 4), bvec2(true, false)) + mix(vec2(1), vec2(5), vec2(0, 1));\n"
        "    vec2 d = reflect(vec2(1, -1), vec2(0, 1));\n"
        "    r = vec4(a, b, c.x * 10 + c.y, d.x * 10 + d.y); }\n",
        AOB_RGBA32F);
    const float expected[] = {39, 4, 47, 11};
    if (draws(gpu))
        assert_memory_equal(got, expected, sizeof expected);
    free(got);
}

/* a -> b -> a, many times: each pass must see all that the one before it wrote. */
static void passes_see_what_earlier_ones_wrote(void **state)
{
    struct aob_gpu *gpu = *state;
    static const float zeros[TEXELS];
    struct aob_gpu_program *sampler =
        program(gpu, "layout(BIND(1)) uniform sampler2D s;\nlayout(location = 0) out float r;\n"
                     "void main() { r = texelFetch(s, ivec2(gl_FragCoord.xy), 0).x + 1; }\n");
    struct aob_gpu_program *loader =
        program(gpu, "layout(r32f, BIND(1)) uniform readonly image2D s;\nlayout(location = 0) out float r;\n"
                     "void main() { r = imageLoad(s, ivec2(gl_FragCoord.xy)).x + 1; }\n");
    struct aob_gpu_texture *a = texture(gpu, AOB_R32F, zeros), *b = texture(gpu, AOB_R32F, NULL);
    const struct aob_gpu_target to_a[] = {{a, 0}}, to_b[] = {{b, 0}};
    const struct aob_gpu_bind sampled = {.kind = AOB_GPU_SAMPLED, .binding = 1, .texture = a};
    const struct aob_gpu_bind stored = {.kind = AOB_GPU_STORAGE, .binding = 1, .texture = b};
    struct aob_gpu_pass_desc forth = {
        .program = sampler, .binds = &sampled, .bind_count = 1, .targets = to_b, .target_count = 1};
    struct aob_gpu_pass_desc back = {
        .program = loader, .binds = &stored, .bind_count = 1, .targets = to_a, .target_count = 1};
    struct aob_gpu_pass *passes[] = {aob_gpu_pass_create(gpu, &forth, NULL),
                                     aob_gpu_pass_create(gpu, &back, NULL)};
    for (int i = 0; i < 40; i++)
        assert_true(run_once(gpu, passes[i % 2], NULL, NULL));
    float *got = read_back(gpu, a, 0);
    for (int i = 0; i < TEXELS; i++)
        assert_true(got[i] == (draws(gpu) ? 40 : 0));
    free(got);
    for (int i = 0; i < 2; i++)
        aob_gpu_pass_destroy(gpu, passes[i]);
    aob_gpu_texture_destroy(gpu, a);
    aob_gpu_texture_destroy(gpu, b);
    aob_gpu_program_destroy(gpu, sampler);
    aob_gpu_program_destroy(gpu, loader);
}

static void gives_the_same_bits_twice_and_takes_time(void **state)
{
    struct aob_gpu *gpu = *state;
    const char *glsl = "layout(location = 0) out vec4 r;\n"
                       "void main() { vec2 p = gl_FragCoord.xy;\n"
                       "    r = vec4(sin(p.x) / p.y, inversesqrt(p.x * p.y), exp(-p.y), pow(p.x, 0.3)); }\n";
    struct aob_gpu_program *drawer = program(gpu, glsl);
    struct aob_gpu_texture *target = texture(gpu, AOB_RGBA32F, NULL);
    const struct aob_gpu_target targets[] = {{target, 0}};
    struct aob_gpu_pass_desc desc = {.program = drawer, .targets = targets, .target_count = 1};
    struct aob_gpu_time time = {-1, -1, -1};
    run_pass(gpu, &desc, &time);
    assert_true(time.wall_ns > 0);
    assert_true(time.cpu_ns > 0);
    assert_int_equal(time.device_ns, 0); /* a software device is judged by the host's clocks only */
    void *first = read_back(gpu, target, 0);
    run_pass(gpu, &desc, NULL);
    void *second = read_back(gpu, target, 0);
    assert_memory_equal(first, second, byte_count(AOB_RGBA32F));
    free(first);
    free(second);
    aob_gpu_program_destroy(gpu, drawer);
    aob_gpu_texture_destroy(gpu, target);
}

static void explains_a_compile_error_in_one_line(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_error error = {""};
    char expected[128];
    snprintf(expected, sizeof expected, "%s: fragment shader, line 2: 'x' : undeclared identifier",
             gpu->info.backend);
    assert_null(aob_gpu_program_create(gpu, "void main() {\n  x = 1; }\n", &error));
    assert_string_equal(error.text, expected);
    assert_null(aob_gpu_program_create(gpu, "\xff\x01", &error));
    assert_null(strchr(error.text, '\n'));
}

static void survives_many_passes(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_program *drawer =
        program(gpu, "layout(location = 0) out float r;\nvoid main() { r = 1; }\n");
    struct aob_gpu_texture *target = texture(gpu, AOB_R8, NULL);
    const struct aob_gpu_target targets[] = {{target, 0}};
    struct aob_gpu_pass_desc desc = {.program = drawer, .targets = targets, .target_count = 1};
    for (int i = 0; i < 50; i++) {
        struct aob_gpu_pass *pass = aob_gpu_pass_create(gpu, &desc, NULL);
        assert_non_null(pass);
        aob_gpu_pass_destroy(gpu, pass);
    }
    run_pass(gpu, &desc, NULL);
    aob_gpu_texture_destroy(gpu, target);
    aob_gpu_program_destroy(gpu, drawer);
}

static void describes_itself(void **state)
{
    struct aob_gpu *gpu = *state;
    assert_ptr_equal(aob_gpu_find(gpu->info.backend), gpu->fns);
    assert_true(strlen(gpu->info.device) > 0);
    assert_true(strlen(gpu->info.driver) > 0);
    assert_null(aob_gpu_find("metal"));
    struct aob_error error = {""};
    assert_null(aob_gpu_open("metal", NULL, &error));
    assert_string_equal(error.text, "backend 'metal' is unknown: use one of vulkan, gl-egl, gl-osmesa, null");
    aob_gpu_close(NULL);
    aob_gpu_texture_destroy(gpu, NULL);
    aob_gpu_program_destroy(gpu, NULL);
    aob_gpu_pass_destroy(gpu, NULL);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(describes_itself),
        cmocka_unit_test(keeps_texels_of_every_format),
        cmocka_unit_test(copies_every_format_through_a_pass),
        cmocka_unit_test(puts_row_0_at_the_top),
        cmocka_unit_test(writes_eight_targets),
        cmocka_unit_test(filters_and_clamps),
        cmocka_unit_test(replaced_functions_mean_what_glsl_says),
        cmocka_unit_test(passes_see_what_earlier_ones_wrote),
        cmocka_unit_test(gives_the_same_bits_twice_and_takes_time),
        cmocka_unit_test(explains_a_compile_error_in_one_line),
        cmocka_unit_test(survives_many_passes),
    };
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
