/* Operations of bodies made for the purpose, against what a hand counts. */
#include "counted.h"
#include "shader/counters.h"

enum { W = 70, H = 67 };

struct values {
    float k;
};
static const struct aob_param params[] = {AOB_PARAM(struct values, k, .min = 0, .max = 9, .doc = ".")};

/* What the prelude's reads take: the pixel is converted (2); a fetch clamps (4) to an edge, which is the same for all. */
enum { PIXEL = 2, FETCH = 4 };

static const struct aob_shader shaders[] = {
    {"flat", "void main() { o = param.k; }\n"},
    {"straight", "void main() {\n"
                 "    float a = aob_fetch_flat(aob_pixel);\n"
                 "    vec3 v = vec3(a, a + param.k, a - param.k);\n"
                 "    float r = sqrt(dot(v, v.zxy)) / param.k;\n"
                 "    vec3 s = v * r + param.k;\n"
                 "    o = clamp(pow(s.x, param.k) * s.y, 0.0, 1.0) + min(s.z, cos(a));\n}\n"},
    {"loop", "void main() {\n"
             "    int n = aob_pixel.x & 7;\n"
             "    float s = 0.0;\n"
             "    for (int i = 0; i < n; i++)\n"
             "        s += aob_fetch_flat(aob_pixel + ivec2(i, i)) * param.k;\n"
             "    o = s;\n}\n"},
    {"branch", "void main() {\n"
               "    if (aob_pixel.x < 10)\n"
               "        o = sqrt(aob_fetch_flat(aob_pixel));\n"
               "    else\n"
               "        o = float(aob_pixel.y) + param.k;\n}\n"},
    {"leave", "void main() {\n"
              "    if (aob_pixel.x == 3)\n"
              "        discard;\n"
              "    o = aob_fetch_flat(aob_pixel);\n}\n"},
    {"unknown", "void main() { o = refract(vec2(aob_fetch_flat(aob_pixel)), vec2(0.0, 1.0), param.k).x; }\n"},
    {NULL, NULL}};

static const char *body;
static uint32_t divisor = 1; /* of what the body reads */

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex flat = aob_texture(graph, .name = "flat", .format = AOB_R32F, .divisor = divisor);
    aob_tex out = aob_texture(graph, .name = "o", .format = AOB_R32F);
    aob_pass(graph, .name = "flat", .shader = "flat", .out = {{.name = "o", .tex = flat}});
    aob_pass(graph, .name = "body", .shader = body, .in = {{.name = "flat", .tex = flat}},
             .out = {{.name = "o", .tex = out}});
    return aob_output(graph, AOB_OUT_VISIBILITY, out);
}
AOB_TECHNIQUE(known, .title = "t", .citation = "c", .params = params, .param_count = 1,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);

static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};

static void check_pass(const struct aob_count *count, int index, struct aob_operations known)
{
    const struct aob_count_pass *pass = &count->passes[index];
    const uint64_t width = index ? W : (W + divisor - 1) / divisor,
                   height = index ? H : (H + divisor - 1) / divisor;
    if (pass->invocations != width * height || pass->whole.alu != known.alu ||
        pass->whole.special != known.special || pass->whole.image != known.image)
        fail_msg(
            "%s on %s: %llu invocations, alu %.0f, special %.0f, image %.0f; by hand %llu, %.0f, %.0f, %.0f",
            body, count->frame.screen->gpu->info.backend, (unsigned long long)pass->invocations,
            pass->whole.alu, pass->whole.special, pass->whole.image, (unsigned long long)(width * height),
            known.alu, known.special, known.image);
}

static void check_body(const char *name, struct aob_operations known)
{
    struct aob_rig rig;
    struct counted *counted = AOB_NEW(struct counted);
    const struct aob_options options = {0};
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    body = name;
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        counted_init(counted, &rig, gpu,
                     &(struct counted_desc){.technique = &aob_technique_known,
                                            .values = &(struct values){.k = 2},
                                            .options = &options});
        check_pass(&counted->count, 0, (struct aob_operations){0});
        check_pass(&counted->count, 1, known);
        counted_finish(counted);
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
    free(counted);
}

/* Sum and difference (2); a dot product (3); a root and its product with the reciprocal of what is the same for all (1); a
 * product and a sum of three components (3); a power's product (1), a product (1), a minimum (1), a sum (1). The clamp is a
 * modifier. Special: the root, two of the power, the cosine. */
static void test_straight(void **state)
{
    (void)state;
    check_body("straight", (struct aob_operations){.alu = W * H * (PIXEL + FETCH + 2 + 3 + 1 + 3 + 4),
                                                   .special = W * H * 4,
                                                   .image = W * H});
}

/* The mask of n (1), one comparison more than turns, and in each turn a sum of two components, a fetch, a product with its
 * sum (1) and the next number (1). */
static void check_loop(void)
{
    double turns = 0;
    for (int x = 0; x < W; x++)
        turns += H * (x & 7);
    check_body("loop", (struct aob_operations){
                           .alu = W * H * (PIXEL + 1 + 1) + turns * (1 + 2 + FETCH + 1 + 1), .image = turns});
}

static void test_loop(void **state)
{
    (void)state;
    check_loop();
}

/* The edge of what is half as large takes a division of the size in each turn, as the text has it: of no invocation. */
static void test_divided(void **state)
{
    (void)state;
    divisor = 2;
    check_loop();
    divisor = 1;
}

static void test_branch(void **state)
{
    (void)state;
    const double left = 10 * H, right = (W - 10) * H;
    check_body("branch", (struct aob_operations){.alu = W * H * (PIXEL + 1) + left * FETCH + right * (1 + 1),
                                                 .special = left,
                                                 .image = left});
}

/* What an invocation ran before it was given up is counted, and nothing behind. */
static void test_discard(void **state)
{
    (void)state;
    const double left = H;
    check_body("leave", (struct aob_operations){.alu = W * H * (PIXEL + 1) + (W * H - left) * FETCH,
                                                .image = W * H - left});
}

static void assert_same(const struct aob_count *a, const struct aob_count *b)
{
    for (int i = 0; i < a->frame.graph.pass_count; i++) {
        const struct aob_count_pass *p = &a->passes[i], *q = &b->passes[i];
        assert_int_equal(p->invocations, q->invocations);
        assert_true(p->whole.alu == q->whole.alu && p->whole.special == q->whole.special);
        assert_true(p->whole.image == q->whole.image);
    }
}

static int draws;
static bool (*run)(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                   struct aob_gpu_time *whole, struct aob_error *error);

static bool count_run(struct aob_gpu *gpu, const struct aob_gpu_run_desc *desc, struct aob_gpu_time *times,
                      struct aob_gpu_time *whole, struct aob_error *error)
{
    draws++;
    return run(gpu, desc, times, whole, error);
}

static void read_image(struct counted *counted, float *pixels)
{
    struct aob_error error = {""};
    if (!aob_frame_read(&counted->count.frame, AOB_OUT_VISIBILITY, 1, pixels, &error))
        fail_msg("%s", error.text);
}

/* Few runs to a counter make many draws, of rows and of triangles, that count the same and leave the same image. */
static void check_parts(struct aob_gpu *gpu, const struct aob_rig *rig, const char *name, uint64_t limit)
{
    struct counted *whole = AOB_NEW(struct counted), *parts = AOB_NEW(struct counted);
    const struct aob_technique *found = counted_find(name);
    struct aob_options options;
    unsigned char values[4 * AOB_MAX_PARAM];
    float *a = AOB_NEW_ARRAY(float, W *H), *b = AOB_NEW_ARRAY(float, W *H);
    aob_rig_params(found, "", values, &options);
    struct counted_desc desc = {.technique = found, .values = values, .options = &options};
    counted_init(whole, rig, gpu, &desc);
    draws = 0;
    desc.limit = limit;
    counted_init(parts, rig, gpu, &desc);
    assert_true(draws > 2 * parts->count.frame.graph.pass_count);
    assert_same(&whole->count, &parts->count);
    read_image(whole, a);
    read_image(parts, b);
    assert_memory_equal(a, b, sizeof(float) * W * H);
    counted_finish(whole);
    counted_finish(parts);
    free(whole);
    free(parts);
    free(a);
    free(b);
}

static void test_parts(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_gpu *gpu = aob_rig_gpu("vulkan");
    struct aob_gpu_fns fns = *gpu->fns;
    const struct aob_gpu_fns *original = gpu->fns;
    run = fns.run;
    fns.run = count_run;
    gpu->fns = &fns;
    aob_rig_scene(&rig, "cornell", "blocks", W, H, 0);
    check_parts(gpu, &rig, "gtao", 40000);
    check_parts(gpu, &rig, "ao_volumes", 40000);
    gpu->fns = original;
    aob_gpu_close(gpu);
    aob_rig_finish(&rig);
}

static bool refused(struct aob_gpu *gpu, const struct aob_rig *rig, uint64_t limit, struct aob_error *error)
{
    const struct aob_options options = {0};
    struct aob_count *count = AOB_NEW(struct aob_count);
    struct aob_screen screen;
    assert_true(aob_screen_init(&screen, gpu, &rig->gbuffer, &options, error));
    const struct aob_count_desc desc = {.screen = &screen,
                                        .technique = &aob_technique_known,
                                        .values = &(struct values){.k = 2},
                                        .limit = limit};
    assert_false(aob_count_init(count, &desc, error) && aob_count_run(count, error));
    bool unfit = count->unfit;
    aob_count_finish(count);
    aob_screen_finish(&screen);
    free(count);
    return unfit;
}

static void test_refusals(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_error error = {""};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl"), *null = aob_rig_gpu("null");
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    body = "unknown";
    assert_true(refused(gpu, &rig, 0, &error));
    assert_contains(error.text, "pass 'body', shader 'unknown'");
    assert_contains(error.text, "instruction 72 of GLSL.std.450 cannot be counted");
    body = "straight"; /* a row of 70 pixels with one block each */
    assert_true(refused(gpu, &rig, 70, &error));
    assert_contains(error.text,
                    "known: pass 'flat': a row of 70 invocations of up to 1 blocks each is too much");
    assert_true(refused(null, &rig, 0, &error));
    assert_contains(error.text, "null: operations are not counted: none draws nothing: use another device");
    gpu->info.storage_bytes = 0;
    assert_true(refused(gpu, &rig, 0, &error));
    assert_contains(error.text, "cannot write storage buffers: use another device or backend");
    aob_gpu_close(gpu);
    aob_gpu_close(null);
    aob_rig_finish(&rig);
}

static bool (*write_buffer)(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                            const void *bytes, struct aob_error *error);

/* As if 2^32 - 10 invocations had come before. */
static bool write_full(struct aob_gpu *gpu, struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                       const void *bytes, struct aob_error *error)
{
    const uint32_t before = UINT32_MAX - 9;
    return write_buffer(gpu, buffer, offset, size, bytes, error) &&
           write_buffer(gpu, buffer, 4 * AOB_COUNTERS_INVOCATIONS, 4, &before, error);
}

/* More invocations than 32 bits hold are seen as that many, and so are refused. */
static void test_more_than_32_bits(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_error error = {""};
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    body = "straight";
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        struct aob_gpu_fns fns = *gpu->fns;
        const struct aob_gpu_fns *original = gpu->fns;
        write_buffer = fns.buffer_write;
        fns.buffer_write = write_full;
        gpu->fns = &fns;
        assert_true(refused(gpu, &rig, 0, &error));
        assert_contains(error.text, "a row of 4294967356 invocations"); /* 2^32 - 10 + 70 */
        gpu->fns = original;
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_straight), cmocka_unit_test(test_loop),
        cmocka_unit_test(test_divided),  cmocka_unit_test(test_branch),
        cmocka_unit_test(test_discard),  cmocka_unit_test(test_parts),
        cmocka_unit_test(test_refusals), cmocka_unit_test(test_more_than_32_bits)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
