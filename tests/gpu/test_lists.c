/* Lists of passes as a GPU runs them, on each backend: test_lists vulkan|gl-egl|gl-osmesa|null. */
#include <stdlib.h>
#include "made.h"
#include "rig.h"

/* a -> b -> a, each adding 1. */
struct pair {
    struct aob_gpu *gpu;
    struct aob_gpu_program *adder;
    struct aob_gpu_texture *a, *b;
    struct aob_gpu_pass *passes[2];
};

static struct aob_gpu *open_as_gpu(void **state)
{
    const char *backend = ((struct aob_gpu *)*state)->info.backend;
    const struct aob_gpu_desc desc = {.validate = !strcmp(backend, "vulkan"), .as_gpu = true};
    struct aob_gpu *gpu = aob_gpu_open(backend, &desc, NULL);
    assert_non_null(gpu);
    assert_true(gpu->lists);
    return gpu;
}

static struct aob_gpu_pass *add_one(struct pair *pair, const struct aob_gpu_texture *from,
                                    const struct aob_gpu_texture *to)
{
    const struct aob_gpu_bind bind = {.binding = 1, .texture = from};
    const struct aob_gpu_target target = {to, 0};
    struct aob_gpu_pass *pass = aob_gpu_pass_create(
        pair->gpu,
        &(struct aob_gpu_pass_desc){
            .program = pair->adder, .binds = &bind, .bind_count = 1, .targets = &target, .target_count = 1},
        NULL);
    assert_non_null(pass);
    return pass;
}

static void init_pair(struct pair *pair, struct aob_gpu *gpu)
{
    static const float zeros[TEXELS];
    *pair = (struct pair){.gpu = gpu};
    pair->adder = program(gpu, "layout(BIND(1)) uniform sampler2D s;\nlayout(location = 0) out float r;\n"
                               "void main() { r = texelFetch(s, ivec2(gl_FragCoord.xy), 0).x + 1; }\n");
    pair->a = texture(gpu, AOB_R32F, zeros);
    pair->b = texture(gpu, AOB_R32F, NULL);
    pair->passes[0] = add_one(pair, pair->a, pair->b);
    pair->passes[1] = add_one(pair, pair->b, pair->a);
}

static void finish_pair(struct pair *pair)
{
    for (int i = 0; i < 2; i++)
        aob_gpu_pass_destroy(pair->gpu, pair->passes[i]);
    aob_gpu_texture_destroy(pair->gpu, pair->a);
    aob_gpu_texture_destroy(pair->gpu, pair->b);
    aob_gpu_program_destroy(pair->gpu, pair->adder);
}

static void run_pair(struct pair *pair, int repeats, struct aob_gpu_time times[2], struct aob_gpu_time *whole)
{
    struct aob_error error = {""};
    if (!aob_gpu_run(pair->gpu, &(struct aob_gpu_run_desc){pair->passes, 2, repeats}, times, whole, &error))
        fail_msg("%s", error.text);
}

static void expect_all(struct pair *pair, const struct aob_gpu_texture *texture, float value)
{
    float *got = read_back(pair->gpu, texture, 0);
    for (int i = 0; i < TEXELS; i++)
        assert_true(got[i] == (draws(pair->gpu) ? value : 0));
    free(got);
}

static void passes_of_a_list_see_one_another(void **state)
{
    struct pair pair;
    struct aob_gpu *gpu = open_as_gpu(state);
    init_pair(&pair, gpu);
    run_pair(&pair, 20, NULL, NULL);
    expect_all(&pair, pair.a, 40);
    run_pair(&pair, 600, NULL, NULL); /* more than one submit holds */
    expect_all(&pair, pair.a, 1240);
    expect_all(&pair, pair.b, 1239);
    finish_pair(&pair);
    aob_gpu_close(gpu);
}

static void a_list_has_the_device_s_times(void **state)
{
    struct pair pair;
    struct aob_gpu_time times[2], whole;
    struct aob_gpu *gpu = open_as_gpu(state);
    init_pair(&pair, gpu);
    for (int repeats = 1; repeats <= 300;
         repeats *= 300) { /* two submits, as nothing is known of them at first */
        run_pair(&pair, repeats, times, &whole);
        int64_t sum = times[0].device_ns + times[1].device_ns;
        assert_true(whole.wall_ns > 0 && whole.cpu_ns > 0);
        for (int i = 0; i < 2; i++)
            assert_true(times[i].wall_ns == 0 && times[i].cpu_ns == 0); /* nobody knows */
        if (strncmp(gpu->info.backend, "gl-", 3) == 0)
            continue; /* test_clock says what these clocks are worth */
        assert_true(times[0].device_ns > 0 && times[1].device_ns > 0);
        assert_true(sum <= whole.device_ns);
        assert_true(whole.device_ns <= whole.wall_ns + whole.wall_ns / 50);
        if (!draws(gpu))
            assert_int_equal(whole.device_ns, 2 * TEXELS * 100 * repeats);
    }
    finish_pair(&pair);
    aob_gpu_close(gpu);
}

static void a_software_device_runs_passes_alone(void **state)
{
    struct pair pair;
    struct aob_gpu_time times[2], whole;
    struct aob_gpu *gpu = *state;
    if (gpu->lists)
        return;
    init_pair(&pair, gpu);
    run_pair(&pair, 3, times, &whole);
    expect_all(&pair, pair.a, 6);
    assert_true(times[0].wall_ns > 0 && times[1].cpu_ns > 0);
    assert_int_equal(times[0].wall_ns + times[1].wall_ns, whole.wall_ns);
    assert_int_equal(times[0].cpu_ns + times[1].cpu_ns, whole.cpu_ns);
    assert_int_equal(whole.device_ns, 0);
    finish_pair(&pair);
}

static void a_run_without_passes_is_refused(void **state)
{
    struct aob_gpu *gpu = *state;
    struct aob_gpu_pass *none = NULL;
    const struct aob_gpu_run_desc wrong[] = {
        {&none, 0, 1}, {&none, 1, 0}, {&none, 1, -1}, {&none, AOB_GPU_MAX_LIST + 1, 1}};
    for (size_t i = 0; i < AOB_COUNT(wrong); i++) {
        struct aob_error error = {""};
        assert_false(aob_gpu_run(gpu, &wrong[i], NULL, NULL, &error));
        assert_contains(error.text, "there must be 1..64 passes, at least once");
    }
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_of_a_list_see_one_another),
        cmocka_unit_test(a_list_has_the_device_s_times),
        cmocka_unit_test(a_software_device_runs_passes_alone),
        cmocka_unit_test(a_run_without_passes_is_refused),
    };
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
