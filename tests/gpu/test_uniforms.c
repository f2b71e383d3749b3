/* Uniform blocks, on each backend. */
#include <stdlib.h>
#include "made.h"
#include "rig.h"

static void reads_uniforms_as_they_were(void **state)
{
    struct aob_gpu *gpu = *state;
    struct {
        float scale;
        int32_t offset;
        float more;
    } block = {1.5f, -3, 0.25f};
    struct aob_gpu_program *drawer =
        program(gpu, "layout(std140, BIND(0)) uniform Block { float scale; int offset; float more; };\n"
                     "layout(location = 0) out vec4 r;\n"
                     "void main() { r = vec4(scale, offset, more, scale * float(offset)); }\n");
    struct aob_gpu_texture *target = texture(gpu, AOB_RGBA32F, NULL);
    const struct aob_gpu_target targets[] = {{target, 0}};
    struct aob_gpu_pass_desc desc = {.program = drawer,
                                     .targets = targets,
                                     .target_count = 1,
                                     .uniforms = &block,
                                     .uniform_size = sizeof block};
    struct aob_gpu_pass *pass = aob_gpu_pass_create(gpu, &desc, NULL);
    assert_non_null(pass);
    memset(&block, 0, sizeof block);
    assert_true(run_once(gpu, pass, NULL, NULL));
    float *got = read_back(gpu, target, 0);
    const float expected[] = {1.5f, -3, 0.25f, -4.5f};
    if (draws(gpu))
        assert_memory_equal(got + 4 * (TEXELS - 1), expected, sizeof expected);
    free(got);
    aob_gpu_pass_destroy(gpu, pass);
    aob_gpu_texture_destroy(gpu, target);
    aob_gpu_program_destroy(gpu, drawer);
}

/* A pass with the block that draws to the texture, run once. */
static struct aob_gpu_pass *run_with(struct aob_gpu *gpu, struct aob_gpu_program *drawer,
                                     struct aob_gpu_texture *made, const float block[3])
{
    const struct aob_gpu_target target = {made, 0};
    struct aob_gpu_pass *pass = aob_gpu_pass_create(
        gpu,
        &(struct aob_gpu_pass_desc){
            .program = drawer, .targets = &target, .target_count = 1, .uniforms = block, .uniform_size = 12},
        NULL);
    assert_non_null(pass);
    assert_true(run_once(gpu, pass, NULL, NULL));
    return pass;
}

/* Two passes of one description: what is set for one is its next image, and nothing of the other's. */
static void sets_uniforms_between_runs(void **state)
{
    struct aob_gpu *gpu = *state;
    float block[3] = {1, 2, 3};
    struct aob_gpu_program *drawer =
        program(gpu, "layout(std140, BIND(0)) uniform Block { float a; float b; float c; };\n"
                     "layout(location = 0) out vec4 r;\nvoid main() { r = vec4(a, b, c, 9); }\n");
    struct aob_gpu_texture *made[] = {texture(gpu, AOB_RGBA32F, NULL), texture(gpu, AOB_RGBA32F, NULL)};
    struct aob_gpu_pass *passes[] = {run_with(gpu, drawer, made[0], block),
                                     run_with(gpu, drawer, made[1], block)};
    const float first[] = {1, 2, 3, 9}, second[] = {4, 5, 6, 9}, zero[4] = {0};
    const float *expected[3][2] = {{first, first}, {second, first}, {first, first}};
    for (int run = 0; run < 3; run++) {
        float next[] = {4, 5, 6}, last[] = {1, 2, 3};
        assert_true(!run ||
                    aob_gpu_pass_set_uniforms(gpu, passes[0], run == 1 ? next : last, sizeof next, NULL));
        memset(next, 0, sizeof next); /* it was copied */
        memset(last, 0, sizeof last);
        for (int i = 0; run && i < 2; i++) {
            float *before = read_back(gpu, made[i], 0); /* setting draws nothing */
            assert_memory_equal(before, draws(gpu) ? expected[run - 1][i] : zero, sizeof first);
            free(before);
            assert_true(run_once(gpu, passes[i], NULL, NULL));
        }
        for (int i = 0; i < 2; i++) {
            float *got = read_back(gpu, made[i], 0);
            for (int k = 0; k < TEXELS; k++)
                assert_memory_equal(got + 4 * k, draws(gpu) ? expected[run][i] : zero, sizeof first);
            free(got);
        }
    }
    for (int i = 0; i < 2; i++) {
        aob_gpu_pass_destroy(gpu, passes[i]);
        aob_gpu_texture_destroy(gpu, made[i]);
    }
    aob_gpu_program_destroy(gpu, drawer);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(reads_uniforms_as_they_were),
                                       cmocka_unit_test(sets_uniforms_between_runs)};
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
