/* What a device refuses, one body for all backends: test_refusals vulkan|gl-egl|gl-osmesa|null. */
#include "made.h"
#include "rig.h"

static void refuse_texture(struct aob_gpu *gpu, struct aob_gpu_texture_desc desc, const char *why)
{
    struct aob_error error = {""};
    assert_null(aob_gpu_texture_create(gpu, &desc, &error));
    assert_contains(error.text, why);
}

static void refuses_wrong_textures(void **state)
{
    struct aob_gpu *gpu = *state;
    const struct aob_gpu_texture_desc good = {.width = 8, .height = 5, .levels = 4, .uses = ALL_USES};
    struct aob_gpu_texture_desc desc = good;
#define REFUSE(why, ...)                                                                                     \
    desc = good;                                                                                             \
    __VA_ARGS__;                                                                                             \
    refuse_texture(gpu, desc, why)
    aob_gpu_texture_destroy(gpu, make(gpu, good));
    REFUSE("format 10 does not exist", desc.format = AOB_FORMAT_COUNT);
    REFUSE("format -1 does not exist", desc.format = (enum aob_format) - 1);
    REFUSE("size 0x5", desc.width = 0);
    REFUSE("size 8x-1", desc.height = -1);
    REFUSE("size 16385x5", desc.width = 16385);
    REFUSE("8x5 with 5 levels: this size has 1..4", desc.levels = 5);
    REFUSE("8x5 with -1 levels", desc.levels = -1);
    REFUSE("8x5 with uses 0x0", desc.uses = 0);
    REFUSE("8x5 with uses 0x1f", desc.uses = 31);
#undef REFUSE
}

static void refuse_pass(struct aob_gpu *gpu, struct aob_gpu_pass_desc desc, const char *why)
{
    struct aob_error error = {""};
    assert_null(aob_gpu_pass_create(gpu, &desc, &error));
    assert_contains(error.text, why);
}

static const char constant_text[] = "layout(location = 0) out float r;\nvoid main() { r = 1; }\n";
static const char reader_text[] = "layout(BIND(4)) uniform sampler2D s;\nlayout(location = 0) out float r;\n"
                                  "void main() { r = texelFetch(s, ivec2(0), 0).x; }\n";

/* A copy of `good` in which the rest of the arguments is changed. */
#define REFUSE(why, ...)                                                                                     \
    desc = good;                                                                                             \
    __VA_ARGS__;                                                                                             \
    refuse_pass(gpu, desc, why)

static void refuses_wrong_passes(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_program *plain = program(gpu, constant_text), *reader = program(gpu, reader_text);
    struct aob_gpu_texture *a = texture(gpu, AOB_R8, NULL),
                           *small = make(
                               gpu, (struct aob_gpu_texture_desc){.width = 4, .height = 4, .uses = ALL_USES});
    const struct aob_gpu_target one[] = {{a, 0}}, sizes[] = {{a, 0}, {small, 0}}, twice[] = {{a, 0}, {a, 0}},
                                none[] = {{NULL, 0}};
    const float block[4] = {0};
    struct aob_gpu_pass_desc good = {.program = plain, .targets = one, .target_count = 1}, desc;
    REFUSE("without a program", desc.program = NULL);
    REFUSE("0 targets", desc.target_count = 0);
    REFUSE("9 targets", desc.target_count = 9);
    REFUSE("two sizes", desc.targets = sizes, desc.target_count = 2);
    REFUSE("two targets", desc.targets = twice, desc.target_count = 2);
    REFUSE("without a texture at target 0", desc.targets = none);
    REFUSE("uniform block", desc.uniforms = block);
    REFUSE("uniform block", desc.uniform_size = 4);
    REFUSE("uniform block", desc.uniforms = block, desc.uniform_size = 1 << 20);
    REFUSE("nothing at 4", desc.program = reader);
    aob_gpu_texture_destroy(gpu, a);
    aob_gpu_texture_destroy(gpu, small);
    aob_gpu_program_destroy(gpu, plain);
    aob_gpu_program_destroy(gpu, reader);
}

static void refuses_wrong_inputs(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_program *plain = program(gpu, constant_text);
    struct aob_gpu_texture *a = texture(gpu, AOB_R8, NULL), *b = texture(gpu, AOB_R8, NULL);
    const struct aob_gpu_target one[] = {{a, 0}};
    struct aob_gpu_bind binds[2] = {{.binding = 4, .texture = b}, {.binding = 5, .texture = b}};
    struct aob_gpu_pass_desc good = {.program = plain,
                                     .targets = one,
                                     .target_count = 1,
                                     .binds = binds,
                                     .bind_count = 2},
                             desc;
    REFUSE("binding 0", binds[1].binding = 0);
    REFUSE("binding 32", binds[1].binding = 32);
    REFUSE("two textures at binding 4", binds[1].binding = 4);
    binds[1].binding = 5;
    REFUSE("without a texture at binding 5", binds[1].texture = NULL);
    REFUSE("reads level 0 of the texture at binding 5 and writes it at target 0", binds[1].texture = a);
    binds[1].texture = b;
    REFUSE("kind 7", binds[1].kind = (enum aob_gpu_bind_kind)7);
    binds[1].kind = AOB_GPU_SAMPLED;
    REFUSE("filter 7", binds[1].filter = (enum aob_filter)7);
    aob_gpu_texture_destroy(gpu, a);
    aob_gpu_texture_destroy(gpu, b);
    aob_gpu_program_destroy(gpu, plain);
}
#undef REFUSE

static struct aob_gpu_texture *levels_for(struct aob_gpu *gpu, uint32_t uses)
{
    return make(gpu, (struct aob_gpu_texture_desc){.width = 8, .height = 5, .levels = 4, .uses = uses});
}

#define SET(...)                                                                                             \
    target = (struct aob_gpu_target){texture, 1};                                                            \
    bind = (struct aob_gpu_bind){.binding = 4, .texture = texture, .level_count = 1};                        \
    desc = (struct aob_gpu_pass_desc){                                                                       \
        .program = reader, .binds = &bind, .bind_count = 1, .targets = &target, .target_count = 1};          \
    __VA_ARGS__
#define REFUSE(why, ...)                                                                                     \
    SET(__VA_ARGS__);                                                                                        \
    refuse_pass(gpu, desc, why)

static void refuses_wrong_levels(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_program *reader = program(gpu, reader_text);
    struct aob_gpu_texture *texture = levels_for(gpu, ALL_USES);
    struct aob_gpu_target target;
    struct aob_gpu_bind bind;
    struct aob_gpu_pass_desc desc;
    SET(run_pass(gpu, &desc, NULL));
    SET(bind.first_level = 2, bind.level_count = 0, run_pass(gpu, &desc, NULL));
    SET(desc.width = 4, desc.height = 2, run_pass(gpu, &desc, NULL));
    REFUSE("level 4 at target 0: its texture has 0..3", target.level = 4);
    REFUSE("level -1 at target 0", target.level = -1);
    REFUSE("2 levels from 3 at binding 4: its texture has 0..3", bind.first_level = 3, bind.level_count = 2);
    REFUSE("0 levels from 4 at binding 4", bind.first_level = 4, bind.level_count = 0);
    REFUSE("1 levels from -1 at binding 4", bind.first_level = -1);
    REFUSE("-1 levels from 0 at binding 4", bind.level_count = -1);
    REFUSE("levels from 3 at binding 4", bind.first_level = 3, bind.level_count = INT32_MAX);
    REFUSE("reads level 1 of the texture at binding 4 and writes it at target 0", bind.first_level = 1);
    REFUSE("reads level 1 of the texture at binding 4", bind.level_count = 2);
    REFUSE("reads level 1 of the texture at binding 4", bind.level_count = 0);
    REFUSE("reads level 3 of the texture at binding 4", bind.level_count = 0, target.level = 3);
    REFUSE("2 levels at binding 4: a storage image shows one", bind.kind = AOB_GPU_STORAGE,
           bind.level_count = 2);
    REFUSE("4 levels at binding 4: a storage image shows one", bind.kind = AOB_GPU_STORAGE,
           bind.level_count = 0);
    REFUSE("area of 5x0 on targets of 4x2", desc.width = 5);
    REFUSE("area of 4x3 on targets of 4x2", desc.width = 4, desc.height = 3);
    REFUSE("area of -1x0 on targets of 4x2", desc.width = -1);
    aob_gpu_texture_destroy(gpu, texture);
    aob_gpu_program_destroy(gpu, reader);
}
#undef REFUSE
#undef SET

static void refuses_to_read_wrong_levels(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_texture *texture = levels_for(gpu, ALL_USES);
    unsigned char texels[8 * 5];
    struct aob_error error = {""};
    assert_false(aob_gpu_texture_read(gpu, texture, 4, texels, &error));
    assert_contains(error.text, "8x5 has no level 4 to read: it has 0..3");
    assert_false(aob_gpu_texture_read(gpu, texture, -1, texels, &error));
    aob_gpu_texture_destroy(gpu, texture);
}

/* Each use is taken away once, and only what needs it is refused. */
static void refuses_a_use_that_was_not_asked_for(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_program *plain =
        program(gpu, "layout(location = 0) out float r;\nvoid main() { r = 1; }\n");
    for (uint32_t use = AOB_GPU_USE_SAMPLED; use <= AOB_GPU_USE_READ_BACK; use *= 2) {
        struct aob_gpu_texture *texture = levels_for(gpu, ALL_USES & ~use);
        const struct aob_gpu_bind bind = {.kind =
                                              use == AOB_GPU_USE_STORAGE ? AOB_GPU_STORAGE : AOB_GPU_SAMPLED,
                                          .binding = 6,
                                          .texture = texture,
                                          .level_count = 1};
        const struct aob_gpu_target target = {texture, 1};
        struct aob_gpu_pass_desc desc = {.program = plain, .targets = &target, .target_count = 1};
        unsigned char texels[8 * 5];
        struct aob_error error = {""};
        if (use == AOB_GPU_USE_TARGET)
            refuse_pass(gpu, desc, "texture at target 0 that was made without AOB_GPU_USE_TARGET");
        else
            run_pass(gpu, &desc, NULL);
        desc.binds = &bind;
        desc.bind_count = 1;
        if (use == AOB_GPU_USE_SAMPLED)
            refuse_pass(gpu, desc, "texture at binding 6 that was made without AOB_GPU_USE_SAMPLED");
        if (use == AOB_GPU_USE_STORAGE)
            refuse_pass(gpu, desc, "texture at binding 6 that was made without AOB_GPU_USE_STORAGE");
        assert_int_equal(aob_gpu_texture_read(gpu, texture, 0, texels, &error), use != AOB_GPU_USE_READ_BACK);
        if (use == AOB_GPU_USE_READ_BACK)
            assert_contains(error.text, "8x5 was made without AOB_GPU_USE_READ_BACK");
        aob_gpu_texture_destroy(gpu, texture);
    }
    aob_gpu_program_destroy(gpu, plain);
}

static void refuses_wrong_uniforms(void **state)
{
    struct aob_gpu *gpu = *state;
    const float block[5] = {0};
    struct aob_gpu_program *plain =
        program(gpu, "layout(location = 0) out float r;\nvoid main() { r = 1; }\n");
    struct aob_gpu_texture *made = texture(gpu, AOB_R8, NULL);
    const struct aob_gpu_target target = {made, 0};
    struct aob_gpu_pass_desc desc = {.program = plain, .targets = &target, .target_count = 1};
    for (size_t size = 0; size <= 16; size += 16) {
        struct aob_error error = {""};
        char expected[64];
        desc.uniforms = size ? block : NULL;
        desc.uniform_size = size;
        struct aob_gpu_pass *pass = aob_gpu_pass_create(gpu, &desc, &error);
        assert_non_null(pass);
        snprintf(expected, sizeof expected, "block of 20 bytes for a pass that was made with %zu", size);
        assert_false(aob_gpu_pass_set_uniforms(gpu, pass, block, 20, &error));
        assert_contains(error.text, expected);
        assert_int_equal(aob_gpu_pass_set_uniforms(gpu, pass, block, size, &error), size == 16);
        aob_gpu_pass_destroy(gpu, pass);
    }
    aob_gpu_texture_destroy(gpu, made);
    aob_gpu_program_destroy(gpu, plain);
}

static void refuses_a_binding_beyond_the_last(void **state)
{
    struct aob_error error = {""};
    for (int binding = 32; binding < 80; binding += 47) { /* GL's own limit is 80 */
        char glsl[160];
        snprintf(glsl, sizeof glsl,
                 "layout(BIND(%d)) uniform sampler2D s;\nlayout(location = 0) out float r;\n"
                 "void main() { r = texelFetch(s, ivec2(0), 0).x; }\n",
                 binding);
        assert_null(aob_gpu_program_create(*state, glsl, &error));
        assert_contains(error.text, "program with a BIND beyond 31");
    }
}

static void validation_fails_the_call(void **state)
{
    struct aob_gpu *gpu = *state;
    if (strcmp(gpu->info.backend, "vulkan"))
        skip();
    struct aob_gpu_program *reader =
        program(gpu, "layout(BIND(4)) uniform sampler2D s;\nlayout(location = 0) out float r;\n"
                     "void main() { r = texelFetch(s, ivec2(0), 0).x; }\n");
    struct aob_gpu_texture *source = texture(gpu, AOB_R32F, NULL), *target = texture(gpu, AOB_R32F, NULL);
    const struct aob_gpu_target targets[] = {{target, 0}};
    struct aob_gpu_bind bind = {.kind = AOB_GPU_STORAGE, .binding = 4, .texture = source};
    refuse_pass(
        gpu,
        (struct aob_gpu_pass_desc){
            .program = reader, .binds = &bind, .bind_count = 1, .targets = targets, .target_count = 1},
        "vulkan: validation, on the way to create a pipeline: ");
    aob_gpu_texture_destroy(gpu, source);
    aob_gpu_texture_destroy(gpu, target);
    aob_gpu_program_destroy(gpu, reader);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(refuses_wrong_textures),
                                       cmocka_unit_test(refuses_wrong_passes),
                                       cmocka_unit_test(refuses_wrong_inputs),
                                       cmocka_unit_test(refuses_wrong_levels),
                                       cmocka_unit_test(refuses_to_read_wrong_levels),
                                       cmocka_unit_test(refuses_a_use_that_was_not_asked_for),
                                       cmocka_unit_test(refuses_wrong_uniforms),
                                       cmocka_unit_test(refuses_a_binding_beyond_the_last),
                                       cmocka_unit_test(validation_fails_the_call)};
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
