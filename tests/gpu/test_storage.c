/* Storage buffers that passes write, and parts of passes, one body for all backends: test_storage
 * vulkan|gl-egl|gl-osmesa|null. */
#include "made.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "rig.h"

static struct aob_gpu_buffer *buffer(struct aob_gpu *gpu, size_t size)
{
    struct aob_error error = {""};
    struct aob_gpu_buffer *made = aob_gpu_buffer_create(gpu, size, &error);
    if (!made)
        fail_msg("%s", error.text);
    return made;
}

static void write_words(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t first, size_t count,
                        const uint32_t *words)
{
    struct aob_error error = {""};
    if (!aob_gpu_buffer_write(gpu, buffer, 4 * first, 4 * count, words, &error))
        fail_msg("%s", error.text);
}

static void read_words(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t first, size_t count,
                       uint32_t *words)
{
    struct aob_error error = {""};
    if (!aob_gpu_buffer_read(gpu, buffer, 4 * first, 4 * count, words, &error))
        fail_msg("%s", error.text);
}

/* Counts invocations at word 0, reads word 1, and writes the pixel's own word. The target's values show what was drawn. */
static const char counting[] =
    "layout(std430, BIND_STORAGE) buffer Words { uint count, given; uint pixels[]; };\n"
    "layout(location = 0) out float r;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    atomicAdd(count, 1u);\n"
    "    pixels[p.y * 37 + p.x] = given + uint(p.y * 1000 + p.x);\n"
    "    r = float(p.y + 1);\n}\n";

struct stage {
    struct aob_gpu *gpu;
    struct aob_gpu_program *program;
    struct aob_gpu_texture *target;
    struct aob_gpu_buffer *buffer;
    struct aob_gpu_pass *pass;
};

static void stage_init(struct stage *stage, struct aob_gpu *gpu)
{
    struct aob_error error = {""};
    *stage = (struct stage){.gpu = gpu,
                            .program = program(gpu, counting),
                            .target = texture(gpu, AOB_R32F, NULL),
                            .buffer = buffer(gpu, 4 * (TEXELS + 2))};
    const struct aob_gpu_target target = {stage->target, 0};
    stage->pass = aob_gpu_pass_create(gpu,
                                      &(struct aob_gpu_pass_desc){.program = stage->program,
                                                                  .targets = &target,
                                                                  .target_count = 1,
                                                                  .storage = stage->buffer,
                                                                  .in_parts = true},
                                      &error);
    if (!stage->pass)
        fail_msg("%s", error.text);
}

static void stage_finish(struct stage *stage)
{
    aob_gpu_pass_destroy(stage->gpu, stage->pass);
    aob_gpu_buffer_destroy(stage->gpu, stage->buffer);
    aob_gpu_texture_destroy(stage->gpu, stage->target);
    aob_gpu_program_destroy(stage->gpu, stage->program);
}

/* Draws rows row .. row + rows - 1 over a buffer of zeros. */
static void draw(struct stage *stage, int row, int rows, uint32_t words[TEXELS + 2])
{
    struct aob_error error = {""};
    const struct aob_gpu_part part = {.row = row, .rows = rows};
    memset(words, 0, 4 * (TEXELS + 2));
    words[1] = 7000000;
    write_words(stage->gpu, stage->buffer, 0, TEXELS + 2, words);
    if (!aob_gpu_pass_set_part(stage->gpu, stage->pass, &part, &error) ||
        !run_once(stage->gpu, stage->pass, NULL, &error))
        fail_msg("%s", error.text);
    read_words(stage->gpu, stage->buffer, 0, TEXELS + 2, words);
}

static void check_rows(const struct stage *stage, int row, int rows, const uint32_t *words)
{
    if (!draws(stage->gpu))
        return;
    assert_int_equal(words[0], rows * WIDTH);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++)
            assert_int_equal(words[2 + y * WIDTH + x],
                             y >= row && y < row + rows ? 7000000 + y * 1000 + x : 0);
}

static void passes_write_what_is_read_back(void **state)
{
    struct stage stage;
    uint32_t words[TEXELS + 2], some[3];
    stage_init(&stage, *state);
    draw(&stage, 0, 0, words);
    check_rows(&stage, 0, HEIGHT, words);
    read_words(stage.gpu, stage.buffer, 40, 3, some);
    assert_memory_equal(some, words + 40, sizeof some);
    write_words(stage.gpu, stage.buffer, 41, 1, &(uint32_t){99});
    read_words(stage.gpu, stage.buffer, 40, 3, some);
    assert_int_equal(some[0], words[40]);
    assert_int_equal(some[1], 99);
    assert_int_equal(some[2], words[42]);
    stage_finish(&stage);
}

/* The rest of the target keeps what the last run drew. */
static void a_part_draws_its_rows_only(void **state)
{
    struct stage stage;
    uint32_t words[TEXELS + 2];
    stage_init(&stage, *state);
    draw(&stage, 3, 0, words);
    check_rows(&stage, 3, HEIGHT - 3, words);
    draw(&stage, 0, 2, words);
    check_rows(&stage, 0, 2, words);
    draw(&stage, 2, 1, words);
    check_rows(&stage, 2, 1, words);
    float *texels = read_back(stage.gpu, stage.target, 0);
    for (int i = 0; i < TEXELS; i++)
        assert_true(texels[i] == (draws(stage.gpu) ? (float)(i / WIDTH + 1) : 0));
    free(texels);
    stage_finish(&stage);
}

/* Triangle k covers column k from x = 0 on: one of them alone is cleared and drawn within its rows. */
static void a_part_draws_its_triangles_only(void **state)
{
    static const char vertex[] =
        "void main() {\n"
        "    int k = VERTEX_ID / 3, i = VERTEX_ID % 3;\n"
        "    float left = 2.0 * float(k) / 37.0 - 1.0, right = left + 2.0 / 37.0;\n"
        "    gl_Position = vec4(i == 1 ? 2.0 * right - left : left, i == 2 ? 3.0 : -1.0, 0.5, 1.0);\n}\n";
    static const char fragment[] = "layout(std430, BIND_STORAGE) buffer Words { uint columns[]; };\n"
                                   "layout(location = 0) out float r;\n"
                                   "void main() { atomicAdd(columns[int(gl_FragCoord.x)], 1u); r = 1; }\n";
    struct aob_gpu *gpu = *state;
    struct aob_error error = {""};
    struct aob_gpu_program *program = aob_gpu_program_create_geometry(gpu, vertex, fragment, &error);
    struct aob_gpu_texture *target = texture(gpu, AOB_R32F, NULL);
    struct aob_gpu_buffer *words = buffer(gpu, 4 * WIDTH);
    uint32_t columns[WIDTH] = {0};
    write_words(gpu, words, 0, WIDTH, columns);
    struct aob_gpu_pass *pass =
        aob_gpu_pass_create(gpu,
                            &(struct aob_gpu_pass_desc){.program = program,
                                                        .targets = &(struct aob_gpu_target){target, 0},
                                                        .target_count = 1,
                                                        .vertex_count = 30,
                                                        .storage = words,
                                                        .in_parts = true},
                            &error);
    if (!pass ||
        !aob_gpu_pass_set_part(gpu, pass, &(struct aob_gpu_part){2, 5, .first_vertex = 12, .vertex_count = 3},
                               &error) ||
        !run_once(gpu, pass, NULL, &error))
        fail_msg("%s", error.text);
    read_words(gpu, words, 0, WIDTH, columns);
    for (int x = 0; draws(gpu) && x < WIDTH; x++) {
        assert_int_equal(columns[x] > 0, x == 4 || x == 5); /* the slope of its long side */
        assert_true(columns[x] <= 5);
    }
    aob_gpu_pass_destroy(gpu, pass);
    aob_gpu_buffer_destroy(gpu, words);
    aob_gpu_texture_destroy(gpu, target);
    aob_gpu_program_destroy(gpu, program);
}

static void refuse_buffer(struct aob_gpu *gpu, size_t size)
{
    struct aob_error error = {""};
    assert_null(aob_gpu_buffer_create(gpu, size, &error));
    assert_contains(error.text, "must be 4, 8, ...");
}

static void refuse_part(const struct stage *stage, struct aob_gpu_part part, const char *why)
{
    struct aob_error error = {""};
    assert_false(aob_gpu_pass_set_part(stage->gpu, stage->pass, &part, &error));
    assert_contains(error.text, why);
}

static void refuses_wrong_buffers_and_parts(void **state)
{
    struct stage stage;
    struct aob_error error = {""};
    struct aob_gpu *gpu = *state;
    uint32_t word = 0;
    stage_init(&stage, gpu);
    refuse_buffer(gpu, 0);
    refuse_buffer(gpu, 6);
    refuse_buffer(gpu, gpu->info.storage_bytes + 4);
    assert_false(aob_gpu_buffer_read(gpu, stage.buffer, 4 * (TEXELS + 2), 4, &word, &error));
    assert_contains(error.text, "4 bytes from 1636");
    assert_false(aob_gpu_buffer_write(gpu, stage.buffer, SIZE_MAX, 4, &word, &error));
    refuse_part(&stage, (struct aob_gpu_part){.row = -1}, "part of 0 rows from -1: the pass has 11");
    refuse_part(&stage, (struct aob_gpu_part){.row = 8, .rows = 4}, "part of 4 rows from 8");
    refuse_part(&stage, (struct aob_gpu_part){.vertex_count = 3}, "part of 3 vertices from 0");
    const struct aob_gpu_target target = {stage.target, 0};
    struct aob_gpu_pass_desc desc = {.program = stage.program, .targets = &target, .target_count = 1};
    assert_null(aob_gpu_pass_create(gpu, &desc, &error));
    assert_contains(error.text, "without a storage buffer, which its program declares");
    desc.storage = stage.buffer;
    struct aob_gpu_pass *whole = aob_gpu_pass_create(gpu, &desc, &error);
    assert_non_null(whole);
    assert_false(aob_gpu_pass_set_part(gpu, whole, &(struct aob_gpu_part){0}, &error));
    assert_contains(error.text, "made without in_parts");
    aob_gpu_pass_destroy(gpu, whole);
    size_t had = gpu->info.storage_bytes;
    gpu->info.storage_bytes = 0; /* a device whose fragment programs cannot write */
    assert_null(aob_gpu_buffer_create(gpu, 4, &error));
    assert_contains(error.text, "cannot write storage buffers: use another device or backend");
    gpu->info.storage_bytes = had;
    stage_finish(&stage);
}

struct rewriter {
    int calls;
    uint32_t storage;
    bool refuses;
};

static uint32_t *copy_words(void *self, const uint32_t *words, size_t *count, uint32_t storage,
                            struct aob_error *error)
{
    struct rewriter *rewriter = self;
    rewriter->calls++;
    rewriter->storage = storage;
    if (rewriter->refuses) {
        aob_fail(error, "not these");
        return NULL;
    }
    return memcpy(aob_alloc(*count, sizeof *words), words, *count * sizeof *words);
}

/* Of the fragment text only, and with the number that BIND_STORAGE has in its words. */
static void a_program_can_be_rewritten(void **state)
{
    static const char vertex[] = "void main() { gl_Position = vec4(0.0); }\n";
    struct aob_gpu *gpu = *state;
    struct aob_error error = {""};
    struct rewriter rewriter = {0};
    const struct aob_gpu_rewrite rewrite = {&rewriter, copy_words};
    const struct aob_gpu_program_desc desc = {.vertex = vertex, .fragment = counting, .rewrite = &rewrite};
    struct aob_gpu_program *made = aob_gpu_program_create_desc(gpu, &desc, &error);
    assert_non_null(made);
    assert_true(made->geometry);
    assert_int_equal(rewriter.calls, 1);
    assert_int_equal(rewriter.storage, strncmp(gpu->info.backend, "gl-", 3) == 0 ? 0 : 32);
    aob_gpu_program_destroy(gpu, made);
    rewriter.refuses = true;
    assert_null(aob_gpu_program_create_desc(gpu, &desc, &error));
    assert_contains(error.text, "not these");
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(passes_write_what_is_read_back),  cmocka_unit_test(a_part_draws_its_rows_only),
        cmocka_unit_test(a_part_draws_its_triangles_only), cmocka_unit_test(refuses_wrong_buffers_and_parts),
        cmocka_unit_test(a_program_can_be_rewritten),
    };
    return aob_rig_device_tests(argc, argv, tests, AOB_COUNT(tests));
}
