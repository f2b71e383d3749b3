/* What a device has too little of, on each backend: test_limits vulkan|gl-egl|gl-osmesa|null. Its limits are lowered, so that
 * what is refused would be drawn otherwise. */
#include "made.h"
#include "rig.h"

enum { BINDS = 4 };

struct stand {
    struct aob_gpu *gpu;
    struct aob_gpu_program *plain, *geometry;
    struct aob_gpu_texture *read, *targets[2];
    struct aob_gpu_bind binds[BINDS];
    struct aob_gpu_target drawn[2];
};

static void init_stand(struct stand *stand, struct aob_gpu *gpu)
{
    static const char text[] = "layout(location = 0) out float r;\nvoid main() { r = 1; }\n";
    static const char vertex[] = "void main() { gl_Position = vec4(0, 0, 0, 1); }\n";
    *stand = (struct stand){.gpu = gpu, .plain = program(gpu, text)};
    stand->geometry = aob_gpu_program_create_geometry(gpu, vertex, text, NULL);
    assert_non_null(stand->geometry);
    stand->read = texture(gpu, AOB_R32F, NULL);
    for (int i = 0; i < 2; i++) {
        stand->targets[i] = texture(gpu, AOB_R32F, NULL);
        stand->drawn[i] = (struct aob_gpu_target){stand->targets[i], 0};
    }
    for (int i = 0; i < BINDS; i++) /* two of each kind */
        stand->binds[i] = (struct aob_gpu_bind){.kind = i < 2 ? AOB_GPU_STORAGE : AOB_GPU_SAMPLED,
                                                .binding = 1 + (uint32_t)i,
                                                .texture = stand->read,
                                                .vertex = true};
}

static void finish_stand(struct stand *stand)
{
    for (int i = 0; i < 2; i++)
        aob_gpu_texture_destroy(stand->gpu, stand->targets[i]);
    aob_gpu_texture_destroy(stand->gpu, stand->read);
    aob_gpu_program_destroy(stand->gpu, stand->plain);
    aob_gpu_program_destroy(stand->gpu, stand->geometry);
}

/* Two storage images at 1 and 2, two sampled textures, two targets, and the block: seven. */
static struct aob_gpu_pass_desc pass_of(const struct stand *stand, bool geometry)
{
    static const float block[4];
    return (struct aob_gpu_pass_desc){.program = geometry ? stand->geometry : stand->plain,
                                      .binds = stand->binds,
                                      .bind_count = BINDS,
                                      .targets = stand->drawn,
                                      .target_count = 2,
                                      .uniforms = block,
                                      .uniform_size = sizeof block,
                                      .vertex_count = geometry ? 3 : 0};
}

static const struct {
    size_t offset; /* of the limit */
    uint32_t enough;
    bool geometry; /* only there */
    const char *line;
} rows[] = {
    {offsetof(struct aob_gpu_limits, targets), 2, false,
     "pass with 2 targets: %s has 1 at most: use another"},
    {offsetof(struct aob_gpu_limits, sampled), 2, false, "pass with 2 sampled textures: %s has 1 at most: "},
    {offsetof(struct aob_gpu_limits, storage), 2, false,
     "pass with 2 storage images: %s has 1 at most: use sampled reads, or another device or backend"},
    {offsetof(struct aob_gpu_limits, vertex_sampled), 2, true,
     "pass with 2 sampled textures in its vertex text: %s has 1 at most: "},
    {offsetof(struct aob_gpu_limits, vertex_storage), 2, true,
     "pass with 2 storage images in its vertex text: %s has 1 at most: use sampled reads"},
    {offsetof(struct aob_gpu_limits, storage_bindings), 3, false,
     "pass with 3 bindings up to its last storage image: %s has 2 at most: use sampled reads"},
    {offsetof(struct aob_gpu_limits, storage_and_targets), 4, false,
     "pass with 4 storage images, buffers and targets: %s has 3 at most: use sampled reads"},
    {offsetof(struct aob_gpu_limits, resources), 7, false,
     "pass with 7 textures, targets, buffers and uniform blocks: %s has 6 at most: use another"},
};

static void expect_pass(const struct stand *stand, bool geometry, const char *line)
{
    const struct aob_gpu_pass_desc desc = pass_of(stand, geometry);
    struct aob_error made_error = {""}, asked_error = {""};
    struct aob_gpu_pass *made = aob_gpu_pass_create(stand->gpu, &desc, &made_error);
    assert_int_equal(aob_gpu_pass_fits(stand->gpu, &desc, &asked_error), !line);
    assert_string_equal(made_error.text, asked_error.text);
    assert_int_equal(!made, line != NULL);
    if (line)
        assert_contains(made_error.text, line);
    aob_gpu_pass_destroy(stand->gpu, made);
}

static void refuses_a_pass_with_too_much(void **state)
{
    struct stand stand;
    struct aob_gpu *gpu = *state;
    const struct aob_gpu_limits own = gpu->limits;
    init_stand(&stand, gpu);
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        char line[512];
        uint32_t *limit = (uint32_t *)(void *)((char *)&gpu->limits + rows[i].offset);
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
        snprintf(line, sizeof line, rows[i].line, gpu->info.device);
        expect_pass(&stand, rows[i].geometry, NULL);
        *limit = rows[i].enough;
        expect_pass(&stand, rows[i].geometry, NULL);
        *limit = rows[i].enough - 1;
        expect_pass(&stand, rows[i].geometry, line);
        if (rows[i].geometry)
            expect_pass(&stand, false, NULL);
        gpu->limits = own;
    }
    /* What only the fragment text has is none of the vertex text's. */
    stand.binds[0].vertex = stand.binds[2].vertex = false;
    gpu->limits.vertex_storage = gpu->limits.vertex_sampled = 1;
    expect_pass(&stand, true, NULL);
    gpu->limits = own;
    finish_stand(&stand);
}

static void refuses_a_texture_that_is_too_large(void **state)
{
    struct aob_gpu *gpu = *state;
    const uint32_t own = gpu->limits.side;
    struct aob_error error = {""};
    struct aob_gpu_texture_desc desc = {.width = 64, .height = 20, .uses = AOB_GPU_USE_SAMPLED};
    gpu->limits.side = 64;
    aob_gpu_texture_destroy(gpu, make(gpu, desc));
    gpu->limits.side = 63;
    assert_null(aob_gpu_texture_create(gpu, &desc, &error));
    assert_contains(error.text, "texture size 64x20: ");
    assert_contains(error.text, " has 63 at most: use a smaller view");
    gpu->limits.side = own;
}

static void refuses_a_depth_that_is_not_there(void **state)
{
    struct stand stand;
    struct aob_gpu *gpu = *state;
    const bool own = gpu->limits.lacks_depth;
    struct aob_error error = {""};
    init_stand(&stand, gpu);
    struct aob_gpu_pass_desc desc = pass_of(&stand, true);
    desc.depth_test = true;
    gpu->limits.lacks_depth = true;
    assert_null(aob_gpu_pass_create(gpu, &desc, &error));
    assert_contains(error.text, "has no 32-bit float depth: use another device or backend");
    gpu->limits.lacks_depth = own;
    finish_stand(&stand);
}

/* As little as Vulkan 1.3 and OpenGL 4.5 promise: a limit that was not read would be less. */
static void a_device_has_what_its_api_promises(void **state)
{
    const struct aob_gpu_limits *limits = &((struct aob_gpu *)*state)->limits;
    assert_true(limits->side >= 4096);
    assert_true(limits->targets >= 4);
    assert_true(limits->sampled >= 16 && limits->vertex_sampled >= 16);
    assert_true(limits->storage >= 4 && limits->storage_bindings >= 8);
    assert_true(limits->resources >= 128 && limits->storage_and_targets >= 4);
    assert_false(limits->lacks_depth);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(refuses_a_pass_with_too_much),
                                       cmocka_unit_test(refuses_a_texture_that_is_too_large),
                                       cmocka_unit_test(refuses_a_depth_that_is_not_there),
                                       cmocka_unit_test(a_device_has_what_its_api_promises)};
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
