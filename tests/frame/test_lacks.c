/* A technique on a device that lacks what it needs: it is the device that does (unfit), and the line says what. On the null
 * backend, of which something is taken away. */
#include "check.h"
#include "base/memory.h"
#include "gpu/backends.h"
#include "rig.h"

static enum aob_format missing;
static uint32_t missing_needs;

static const char *lacks(const struct aob_gpu *gpu, enum aob_format format, uint32_t needs)
{
    (void)gpu;
    return format == missing && needs & missing_needs ? "kind of texture" : NULL;
}

static const struct aob_shader shaders[] = {
    {"first", "void main() { a = 1.0; }\n"},
    {"second", "void main() { o = aob_fetch_a(aob_pixel) * aob_view_z(aob_pixel); }\n"},
    {"broken", "void main() { o = nothing(); }\n"},
    {NULL, NULL}};
static const char *second;

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex a = aob_texture(graph, .name = "between", .format = AOB_R16F),
            o = aob_texture(graph, .name = "o", .format = AOB_R8);
    return aob_pass(graph, .name = "one", .shader = "first", .out = {{.name = "a", .tex = a}}) &&
           aob_pass(graph, .name = "two", .shader = second, .reads = AOB_DEPTH,
                    .in = {{.name = "a", .tex = a}}, .out = {{.name = "o", .tex = o}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, o);
}

AOB_TECHNIQUE(trial, .title = "t", .citation = "c", .shaders = shaders, .build = build, .values_size = 4);

/* Of a device without this format, for these needs, and with so many sampled textures in a pass. */
struct trial {
    enum aob_format format;
    uint32_t needs, sampled;
};

struct outcome {
    bool screen, frame, unfit;
    struct aob_error error;
};

static struct outcome try_device(const struct trial *trial)
{
    struct outcome outcome = {.error = {""}};
    struct aob_rig rig;
    struct aob_screen screen;
    struct aob_frame frame = {0};
    const struct aob_options options = {0};
    struct aob_gpu_fns fns = aob_gpu_null;
    struct aob_gpu *gpu = aob_gpu_open("null", NULL, NULL);
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = 16, .height = 9});
    fns.format_lacks = lacks;
    gpu->fns = &fns;
    missing = trial->format;
    missing_needs = trial->needs;
    gpu->limits.sampled = trial->sampled;
    outcome.screen = aob_screen_init(&screen, gpu, &rig.gbuffer, &options, &outcome.error);
    outcome.frame = outcome.screen && aob_frame_init(&frame, &screen, &aob_technique_trial, &(int32_t){0},
                                                     AOB_FETCH_SAMPLED, &outcome.error);
    outcome.unfit = outcome.screen ? frame.unfit : screen.unfit;
    aob_frame_finish(&frame);
    aob_screen_finish(&screen);
    gpu->fns = &aob_gpu_null;
    aob_gpu_close(gpu);
    aob_rig_finish(&rig);
    return outcome;
}

static void test_what_is_there_is_used(void **state)
{
    (void)state;
    second = "second";
    /* Formats that are not asked for are not missed: no pass stores, filters or blends. */
    const struct trial trials[] = {{0, 0, 2},
                                   {AOB_R16F, AOB_GPU_USE_STORAGE, 2},
                                   {AOB_R16F, AOB_GPU_NEED_FILTER | AOB_GPU_NEED_BLEND, 2},
                                   {AOB_RGBA8, ~0u, 2}};
    for (size_t i = 0; i < AOB_COUNT(trials); i++) {
        struct outcome outcome = try_device(&trials[i]);
        if (!outcome.frame || outcome.unfit)
            fail_msg("trial %zu: %s", i, outcome.error.text);
    }
}

static void expect_unfit(struct trial trial, const char *line)
{
    struct outcome outcome = try_device(&trial);
    assert_false(outcome.frame);
    assert_true(outcome.unfit);
    assert_string_equal(outcome.error.text, line);
}

static void test_what_is_missing_is_the_devices(void **state)
{
    (void)state;
    second = "second";
    expect_unfit(
        (struct trial){AOB_R16F, AOB_GPU_USE_TARGET, 9},
        "trial: texture 'between': null: none has no kind of texture of format r16f: use another device or "
        "backend");
    expect_unfit(
        (struct trial){AOB_R8, AOB_GPU_USE_READ_BACK, 9},
        "trial: texture 'o': null: none has no kind of texture of format r8: use another device or backend");
    expect_unfit((struct trial){AOB_R32F, AOB_GPU_USE_SAMPLED, 9},
                 "null: none has no kind of texture of format r32f: use another device or backend");
    expect_unfit((struct trial){0, 0, 1},
                 "trial: pass 'two': null: pass with 2 sampled textures: none has 1 at "
                 "most: use another device or backend");
}

/* It is told before the program is made, which a driver might not even link; what else is wrong is no lack. */
static void test_other_faults_are_no_lack(void **state)
{
    (void)state;
    second = "broken";
    struct outcome outcome = try_device(&(struct trial){0, 0, 2});
    assert_true(outcome.screen && !outcome.frame);
    assert_false(outcome.unfit);
    expect_unfit((struct trial){0, 0, 1},
                 "trial: pass 'two': null: pass with 2 sampled textures: none has 1 at "
                 "most: use another device or backend");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_what_is_there_is_used),
                                       cmocka_unit_test(test_what_is_missing_is_the_devices),
                                       cmocka_unit_test(test_other_faults_are_no_lack)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
