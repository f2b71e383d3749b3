/* What a device refuses, one body for all backends: test_refusals vulkan|gl-egl|gl-osmesa|null. */
#include "base/memory.h"
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

static void refuses_wrong_passes(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_program *plain =
        program(gpu, "layout(location = 0) out float r;\nvoid main() { r = 1; }\n");
    struct aob_gpu_program *reader =
        program(gpu, "layout(BIND(4)) uniform sampler2D s;\nlayout(location = 0) out float r;\n"
                     "void main() { r = texelFetch(s, ivec2(0), 0).x; }\n");
    struct aob_gpu_texture *a = texture(gpu, AOB_R8, NULL), *b = texture(gpu, AOB_R8, NULL);
    struct aob_gpu_texture *small =
        make(gpu, (struct aob_gpu_texture_desc){.width = 4, .height = 4, .uses = ALL_USES});
    const struct aob_gpu_target one[] = {{a, 0}}, sizes[] = {{a, 0}, {small, 0}}, twice[] = {{a, 0}, {a, 0}},
                                none[] = {{NULL, 0}};
    const float block[4] = {0};
    struct aob_gpu_pass_desc good = {.program = plain, .targets = one, .target_count = 1};
    struct aob_gpu_pass_desc desc = good;
#define REFUSE(why, ...)                                                                                     \
    desc = good;                                                                                             \
    __VA_ARGS__;                                                                                             \
    refuse_pass(gpu, desc, why)
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
    struct aob_gpu_bind binds[2] = {{.binding = 4, .texture = b}, {.binding = 5, .texture = b}};
    good.binds = binds;
    good.bind_count = 2;
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
#undef REFUSE
    struct aob_gpu_texture *made[] = {a, b, small};
    for (size_t i = 0; i < AOB_COUNT(made); i++)
        aob_gpu_texture_destroy(gpu, made[i]);
    aob_gpu_program_destroy(gpu, plain);
    aob_gpu_program_destroy(gpu, reader);
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

static const char *chosen; /* by main, for open_device */

static int open_device(void **state)
{
    *state = aob_rig_gpu(chosen);
    return 0;
}

static int close_device(void **state)
{
    aob_gpu_close(*state);
    return 0;
}

int main(int argc, char **argv)
{
    chosen = argc == 2 ? argv[1] : "null";
    const struct CMUnitTest tests[] = {cmocka_unit_test(refuses_wrong_textures),
                                       cmocka_unit_test(refuses_wrong_passes),
                                       cmocka_unit_test(validation_fails_the_call)};
    return cmocka_run_group_tests(tests, open_device, close_device);
}
