/* The words of a trace, against what bodies made for the purpose are known to read. */
#include "traced.h"
#include <math.h>

enum { W = 70, H = 67, GUARD = 0 }; /* two bands; no side a multiple of 4 */

struct values {
    int32_t unused;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, unused, .min = 0, .max = 9, .stage = AOB_HOST, .doc = ".")};

static const struct aob_shader shaders[] = {
    {"number", "void main() { o = float(aob_pixel.y * 1000 + aob_pixel.x); }\n"},
    {"coarser", "void main() { o = aob_fetch_fine(2 * aob_pixel) + aob_fetch_fine(2 * aob_pixel + 1); }\n"},
    /* In this order: a border, levels and one beyond them, a table and its border, a bilinear sample, the same texture by
     * another name, the depth's border and what one pixel in two reads. */
    {"read", "void main() {\n"
             "    ivec2 p = aob_pixel;\n"
             "    float s = aob_fetch_again(p + ivec2(-2, 1));\n"
             "    s += aob_fetch_pyramid(p >> 1, 1) + aob_fetch_pyramid(p >> 2, 7);\n"
             "    s += aob_fetch_table(p % 7).y;\n"
             "    s += aob_sample_soft((vec2(p) + vec2(0.75, 0.25)) / vec2(aob_size));\n"
             "    s += aob_sample_levels((vec2(p) + 0.5) / vec2(aob_size), 1);\n"
             "    s += aob_view_z(p + ivec2(1000, 0));\n"
             "    if ((p.x & 1) == 0)\n"
             "        s += aob_normal(p).z;\n"
             "    o = clamp(s * 1e-6, 0.0, 1.0);\n}\n"},
    /* Samples about the middle of each texel, to all four sides, and beyond the texture. */
    {"edges", "void main() {\n"
              "    vec2 p = vec2(aob_pixel), size = vec2(aob_size);\n"
              "    float s = aob_sample_soft((p + vec2(0.25, 0.25)) / size);\n"
              "    s += aob_sample_soft((p + vec2(0.75, 0.25)) / size);\n"
              "    s += aob_sample_soft((p + vec2(0.25, 0.75)) / size);\n"
              "    s += aob_sample_soft((p + vec2(0.75, 0.75)) / size);\n"
              "    s += aob_sample_soft((3.0 * p - size + 0.25) / size);\n"
              "    o = clamp(s * 1e-6, 0.0, 1.0);\n}\n"},
    {"leave", "void main() {\n"
              "    o = aob_fetch_again(aob_pixel) * 0.0 + 1.0;\n"
              "    if (aob_pixel.x == 3) discard;\n"
              "    o *= aob_fetch_again(aob_pixel + 1) * 0.0 + 1.0;\n}\n"},
    {"stray", "void main() { o = aob_texel_again(ivec2(aob_pixel.x, 100000)) * 0.0; }\n"},
    {NULL, NULL}};

static void fill(const void *values, void *texels)
{
    (void)values;
    float *t = texels;
    for (int i = 0; i < 30; i++)
        t[i] = (float)i;
}

static const char *reader;

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex flat = aob_texture(graph, .name = "flat", .format = AOB_R32F);
    aob_tex pyramid = aob_texture(graph, .name = "pyramid", .format = AOB_R32F, .levels = 3);
    aob_tex table =
        aob_texture(graph, .name = "table", .format = AOB_RG32F, .width = 5, .height = 3, .fill = fill);
    aob_tex out = aob_texture(graph, .name = "o", .format = AOB_R32F);
    aob_pass(graph, .name = "flat", .shader = "number", .out = {{.name = "o", .tex = flat}});
    aob_pass(graph, .name = "fine", .shader = "number", .out = {{.name = "o", .tex = pyramid}});
    aob_pass(graph, .name = "half", .shader = "coarser", .in = {{.name = "fine", .tex = pyramid}},
             .out = {{.name = "o", .tex = pyramid, .level = 1}});
    aob_pass(graph, .name = "quarter", .shader = "coarser",
             .in = {{.name = "fine", .tex = pyramid, .level = 1}},
             .out = {{.name = "o", .tex = pyramid, .level = 2}});
    aob_pass(graph, .name = "reader", .shader = reader, .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = "again", .tex = flat},
                    {.name = "pyramid", .tex = pyramid},
                    {.name = "table", .tex = table},
                    {.name = "soft", .tex = flat, .filter = AOB_BILINEAR},
                    {.name = "levels", .tex = pyramid, .filter = AOB_BILINEAR}},
             .out = {{.name = "o", .tex = out}});
    return aob_output(graph, AOB_OUT_VISIBILITY, out);
}
AOB_TECHNIQUE(known, .title = "t", .citation = "c", .params = params, .param_count = 1,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);

static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};

/* The number that a texel has, by the planes as the sink was told of them. */
static uint32_t number(const struct taken *taken, const struct taken_pass *pass, const char *texture,
                       int level, int x, int y)
{
    for (int i = 0; i < pass->pass.plane_count; i++) {
        const struct aob_trace_plane *plane = &pass->pass.planes[i];
        if (strcmp(taken->frame.textures[plane->texture].name, texture) == 0 && plane->level == level) {
            assert_true(x >= 0 && y >= 0 && x < plane->width && y < plane->height);
            return plane->first + (uint32_t)(y * plane->width + x);
        }
    }
    fail_msg("no plane of %s, level %d", texture, level);
    return 0;
}

static int at_most(int a, int b)
{
    return a < b ? a : b;
}

/* Of a sample at the middle of pixel `a` of `size`, among the texels of a level of half the size, whose texture is larger:
 * there the prelude itself keeps the place within what the view fills, so it never lies beyond the first texel. */
static int upper_left(int a, int size)
{
    double place = (a + 0.5) / size * ((size + 1) / 2) - 0.5;
    return place > 0 ? (int)place : 0;
}

/* What the text "read" reads at pixel (x, y). */
static size_t known_words(const struct taken *taken, const struct taken_pass *pass, int x, int y,
                          uint32_t words[8])
{
    size_t n = 0;
    words[n++] = number(taken, pass, "flat", 0, x < 2 ? 0 : x - 2, at_most(y + 1, H - 1));
    words[n++] = number(taken, pass, "pyramid", 1, x / 2, y / 2);
    words[n++] = number(taken, pass, "pyramid", 2, x / 4, y / 4);
    words[n++] = number(taken, pass, "table", 0, at_most(x % 7, 4), at_most(y % 7, 2));
    words[n++] = AOB_TRACE_BILINEAR | (y > 0 ? 0 : AOB_TRACE_ONE_ROW) |
                 number(taken, pass, "flat", 0, x, y > 0 ? y - 1 : 0);
    words[n++] = AOB_TRACE_BILINEAR | number(taken, pass, "pyramid", 1, upper_left(x, W), upper_left(y, H));
    words[n++] = number(taken, pass, "depth", 0, W - 1, y);
    if (x % 2 == 0)
        words[n++] = number(taken, pass, "normal", 0, x, y);
    return n;
}

static void check_reader(const struct taken *taken, const struct taken_pass *pass)
{
    assert_int_equal(pass->slots, 8);
    assert_int_equal(pass->count, W * H);
    assert_int_equal(pass->bands, 2);
    assert_int_equal(pass->pass.write_count, 1);
    assert_string_equal(taken->frame.textures[pass->pass.writes[0].texture].name, "o");
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            uint32_t known[8];
            const uint32_t *words = pass->words + (size_t)(y * W + x) * 8;
            size_t n = known_words(taken, pass, x, y, known);
            for (size_t i = 0; i < 8; i++)
                if (words[i] != (i < n ? known[i] : AOB_TRACE_NONE))
                    fail_msg("pixel %d, %d: word %zu is %x, not %x", x, y, i, words[i],
                             i < n ? known[i] : AOB_TRACE_NONE);
        }
}

/* A quarter-sized pixel reads two of level 1, which ends where the view's half does. */
static void check_quarter(const struct taken *taken, const struct taken_pass *pass)
{
    const int last_x = (W + 1) / 2 - 1, last_y = (H + 1) / 2 - 1;
    assert_int_equal(pass->slots, 2);
    assert_int_equal(pass->pass.width, (W + 3) / 4);
    for (int y = 0; y < pass->pass.height; y++)
        for (int x = 0; x < pass->pass.width; x++)
            for (int i = 0; i < 2; i++)
                assert_int_equal(pass->words[(y * pass->pass.width + x) * 2 + i],
                                 number(taken, pass, "pyramid", 1, at_most(2 * x + i, last_x),
                                        at_most(2 * y + i, last_y)));
}

static void init(struct traced *traced, const struct aob_rig *rig, struct aob_gpu *gpu, int fetch)
{
    const struct aob_options options = {.fetch = fetch};
    traced_init(traced, rig, gpu,
                &(struct traced_desc){
                    .technique = &aob_technique_known, .values = &(struct values){0}, .options = &options});
}

/* Storage images and sampled textures alike; the graph's passes write what their reads are numbered by. */
static void test_known_reads(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *taken = AOB_NEW(struct taken);
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    reader = "read";
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        for (int fetch = AOB_FETCH_SAMPLED; fetch <= AOB_FETCH_STORAGE; fetch++) {
            init(traced, &rig, gpu, fetch);
            take(traced, taken);
            assert_int_equal(taken->pass_count, 5);
            assert_int_equal(taken->passes[0].slots, 0);
            check_quarter(taken, &taken->passes[3]);
            check_reader(taken, &taken->passes[4]);
            taken_finish(taken);
            traced_finish(traced);
        }
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
    free(traced);
    free(taken);
}

/* A pixel that is given up keeps what it had read until then. */
static void test_discarded_pixels_have_words(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *taken = AOB_NEW(struct taken);
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    reader = "leave";
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        init(traced, &rig, gpu, AOB_FETCH_SAMPLED);
        take(traced, taken);
        const struct taken_pass *pass = &taken->passes[taken->pass_count - 1];
        assert_int_equal(pass->slots, 2);
        for (int i = 0; i < W * H; i++) {
            assert_int_equal(pass->words[2 * i], number(taken, pass, "flat", 0, i % W, i / W));
            assert_int_equal(pass->words[2 * i + 1] == AOB_TRACE_NONE, i % W == 3);
        }
        taken_finish(taken);
        traced_finish(traced);
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
    free(traced);
    free(taken);
}

/* The first and the last texel that a sampler reads in a row of `size`, for a place in it: it clamps both of the texels
 * about the place to the edge. */
static void clamped(double place, int size, int *first, int *last)
{
    int left = (int)floor(place - 0.5), end = size - 1;
    *first = left < 0 ? 0 : left > end ? end : left;
    *last = left + 1 < 0 ? 0 : left + 1 > end ? end : left + 1;
}

/* The word names just the texels that the sampler reads at a place of `flat`. */
static void check_footprint(uint32_t word, uint32_t first_texel, double x, double y)
{
    int left, right, top, bottom;
    clamped(x, W, &left, &right);
    clamped(y, H, &top, &bottom);
    assert_true(word & AOB_TRACE_BILINEAR);
    int texel = (int)(aob_trace_texel(word) - first_texel), column = texel % W, row = texel / W;
    bool one_column = word & AOB_TRACE_ONE_COLUMN || column == W - 1,
         one_row = word & AOB_TRACE_ONE_ROW || row == H - 1;
    if (column != left || row != top || column + !one_column != right || row + !one_row != bottom)
        fail_msg("at %g, %g: word %x is %d x %d texels from %d, %d, not %d .. %d, %d .. %d", x, y, word,
                 2 - one_column, 2 - one_row, column, row, left, right, top, bottom);
}

/* What the text "edges" reads. */
static void check_edges(const struct taken *taken, const struct taken_pass *pass)
{
    uint32_t first = number(taken, pass, "flat", 0, 0, 0);
    assert_int_equal(pass->slots, 5);
    assert_int_equal(pass->count, W * H);
    for (int y = 0; y < H; y++)
        for (int x = 0; x < W; x++) {
            const uint32_t *words = pass->words + (size_t)(y * W + x) * 5;
            for (int i = 0; i < 4; i++)
                check_footprint(words[i], first, x + (i & 1 ? 0.75 : 0.25), y + (i & 2 ? 0.75 : 0.25));
            check_footprint(words[4], first, 3 * x - W + 0.25, 3 * y - H + 0.25);
        }
}

/* At all edges and corners, and for places far beyond them. */
static void test_bilinear_edges(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *taken = AOB_NEW(struct taken);
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    reader = "edges";
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct aob_gpu *gpu = aob_rig_gpu(backends[b]);
        for (int fetch = AOB_FETCH_SAMPLED; fetch <= AOB_FETCH_STORAGE; fetch++) {
            init(traced, &rig, gpu, fetch);
            take(traced, taken);
            check_edges(taken, &taken->passes[taken->pass_count - 1]);
            taken_finish(taken);
            traced_finish(traced);
        }
        aob_gpu_close(gpu);
    }
    aob_rig_finish(&rig);
    free(traced);
    free(taken);
}

static bool refused(const struct aob_rig *rig, struct aob_gpu *gpu, size_t device_bytes, size_t host_bytes,
                    struct aob_error *error)
{
    const struct aob_options options = {0};
    struct aob_trace *trace = AOB_NEW(struct aob_trace);
    struct aob_screen screen;
    assert_true(aob_screen_init(&screen, gpu, &rig->gbuffer, &options, error));
    const struct aob_trace_desc desc = {.screen = &screen,
                                        .technique = &aob_technique_known,
                                        .values = &(struct values){0},
                                        .device_bytes = device_bytes,
                                        .host_bytes = host_bytes};
    assert_false(aob_trace_init(trace, &desc, error));
    bool unfit = trace->unfit;
    aob_screen_finish(&screen);
    free(trace);
    return unfit;
}

static void test_refusals(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_error error = {""};
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl"), *null = aob_rig_gpu("null");
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    reader = "read";
    /* A row of 70 pixels with 8 words each; 64 such rows. */
    assert_true(refused(&rig, gpu, 32 + 70 * 8 * 4 - 4, 0, &error));
    assert_contains(error.text, "known: pass 'reader': 1 row of 70 pixels take 2240 bytes of trace");
    assert_contains(error.text, "the device's buffer of 2236: use fewer samples");
    assert_true(refused(&rig, gpu, 0, 64 * 70 * 8 * 4 - 4, &error));
    assert_contains(error.text, "64 rows of 70 pixels take 143360 bytes of trace");
    assert_true(refused(&rig, null, 0, 0, &error));
    assert_contains(error.text, "null: no trace: none draws nothing");
    gpu->info.storage_bytes = 0;
    assert_true(refused(&rig, gpu, 0, 0, &error));
    assert_contains(error.text, "cannot write storage buffers: use another device or backend");
    gpu->info.storage_bytes = 1 << 20;
    reader = "stray";
    assert_false(refused(&rig, gpu, 0, 0, &error));
    assert_contains(error.text, "texels outside its textures");
    aob_gpu_close(gpu);
    aob_gpu_close(null);
    aob_rig_finish(&rig);
}

static bool begin_only(void *self, const struct aob_trace_frame *frame, const struct aob_trace_pass *pass,
                       struct aob_error *error)
{
    (void)frame;
    ++*(int *)self;
    return pass->index < 2 || aob_fail(error, "enough");
}

static bool ignore_band(void *self, const struct aob_trace_band *band, struct aob_error *error)
{
    (void)self;
    (void)band;
    (void)error;
    return true;
}

static bool ignore_end(void *self, struct aob_error *error)
{
    (void)self;
    (void)error;
    return true;
}

static void test_a_sink_stops_a_capture(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct aob_error error = {""};
    struct traced *traced = AOB_NEW(struct traced);
    struct aob_gpu *gpu = aob_rig_gpu("gl-egl");
    int begun = 0;
    aob_rig_plane(&rig, &(struct aob_rig_plane){.width = W, .height = H});
    reader = "read";
    init(traced, &rig, gpu, AOB_FETCH_SAMPLED);
    const struct aob_trace_sink sink = {&begun, begin_only, ignore_band, ignore_end};
    assert_false(aob_trace_run(&traced->trace, &sink, &error));
    assert_string_equal(error.text, "known: enough");
    assert_int_equal(begun, 3);
    traced_finish(traced);
    aob_gpu_close(gpu);
    aob_rig_finish(&rig);
    free(traced);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_reads), cmocka_unit_test(test_bilinear_edges),
        cmocka_unit_test(test_discarded_pixels_have_words), cmocka_unit_test(test_refusals),
        cmocka_unit_test(test_a_sink_stops_a_capture)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
