/* A pass of triangles that each cover the whole image, so that every fragment is known: the order in which they come and
 * what they read, however few of them fit at one time. */
#include "traced.h"
#include <math.h>

enum { W = 24, H = 14, PIXELS = W * H, SLOTS = 2, ENTRY = 4 * (2 + SLOTS) };

struct values {
    int32_t unused;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, unused, .min = 0, .max = 9, .stage = AOB_HOST, .doc = ".")};

static const struct aob_shader shaders[] = {
    {"cover", "vec4 place(int triangle, int k) {\n"
              "    return vec4(k == 1 ? 3.0 : -1.0, k == 2 ? 3.0 : -1.0, 0.5, 1.0);\n}\n"},
    {"nothing", "vec4 place(int triangle, int k) { return vec4(0.0, 0.0, 0.5, 1.0); }\n"},
    {"read", "void main() {\n"
             "    float s = aob_view_z(aob_pixel);\n"
             "    if ((aob_pixel.x & 1) == 0) s += aob_normal(aob_pixel).z;\n"
             "    o = clamp(s * 1e-6, 0.0, 0.25);\n}\n"},
    {NULL, NULL}};

static const char *vertex;

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex out = aob_texture(graph, .name = "o", .format = AOB_R32F);
    aob_pass(graph, .name = "drawn", .draw = AOB_TRIANGLES, .vertex = vertex, .shader = "read",
             .per_triangle = 3, .reach = 100, .reads = AOB_DEPTH | AOB_NORMAL,
             .out = {{.name = "o", .tex = out}});
    return aob_output(graph, AOB_OUT_VISIBILITY, out);
}
AOB_TECHNIQUE(known, .title = "t", .citation = "c", .params = params, .param_count = 1,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);

static const char *const backends[] = {"vulkan", "gl-egl", "gl-osmesa"};

struct fixture {
    struct aob_rig rig;
    struct aob_gpu *gpu;
    struct traced traced;
    struct taken taken;
};

static struct fixture *fixture_create(const char *backend, const char *placed)
{
    struct fixture *f = AOB_NEW(struct fixture);
    vertex = placed;
    aob_rig_plane(&f->rig, &(struct aob_rig_plane){.width = W, .height = H});
    f->gpu = aob_rig_gpu(backend);
    return f;
}

static void fixture_destroy(struct fixture *f)
{
    aob_gpu_close(f->gpu);
    aob_rig_finish(&f->rig);
    free(f);
}

/* `room`: fragments that fit on the device; 0: all. */
static void open_trace(struct fixture *f, size_t room)
{
    const struct aob_options options = {0};
    traced_init(&f->traced, &f->rig, f->gpu,
                &(struct traced_desc){.technique = &aob_technique_known,
                                      .values = &(struct values){0},
                                      .options = &options,
                                      .device_bytes = room ? 32 + room * ENTRY : 0});
}

/* Triangle by triangle, each row by row. */
static void check_fragments(const struct fixture *f)
{
    const struct taken_pass *pass = &f->taken.passes[0];
    const struct aob_trace_plane *planes = pass->pass.planes;
    assert_int_equal(f->taken.pass_count, 1);
    assert_int_equal(pass->pass.plane_count, 2);
    assert_int_equal(pass->count, f->rig.geometry.count * PIXELS);
    assert_int_equal(pass->slots, SLOTS);
    for (uint32_t i = 0; i < pass->count; i++) {
        uint32_t texel = i % PIXELS, x = texel % W, y = texel / W;
        assert_int_equal(pass->pixels[i], x | y << 16);
        assert_int_equal(pass->words[i * SLOTS], planes[0].first + texel);
        assert_int_equal(pass->words[i * SLOTS + 1], x % 2 ? AOB_TRACE_NONE : planes[1].first + texel);
    }
}

/* As many draws come as bands as fit: `bands` for each triangle, or one for all where it is 0. */
static void check_room(struct fixture *f, size_t room, size_t bands)
{
    open_trace(f, room);
    take(&f->traced, &f->taken);
    check_fragments(f);
    assert_int_equal(f->taken.passes[0].bands, bands ? bands * f->rig.geometry.count : 1);
    taken_finish(&f->taken);
    traced_finish(&f->traced);
}

/* A triangle that does not fit is drawn in rows, half as many until they do: of 14 rows 4, 4, 4 and 2, or 7 times 2, or one
 * at a time. */
static void test_known_fragments(void **state)
{
    (void)state;
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct fixture *f = fixture_create(backends[b], "cover");
        assert_true(f->rig.geometry.count > 1);
        check_room(f, 0, 0);
        check_room(f, PIXELS, 1);
        check_room(f, 6 * W, 4);
        check_room(f, 3 * W, 7);
        check_room(f, W, H);
        fixture_destroy(f);
    }
}

static void expect_refusal(struct fixture *f, size_t device_bytes, size_t host_bytes, const char *text)
{
    struct aob_error error = {""};
    const struct aob_options options = {0};
    struct aob_geometry geometry = f->rig.geometry;
    struct aob_screen screen;
    struct aob_trace *trace = AOB_NEW(struct aob_trace);
    assert_true(aob_geometry_upload(&geometry, f->gpu, &error) &&
                aob_screen_init(&screen, f->gpu, &f->rig.gbuffer, &options, &error));
    screen.geometry = &geometry;
    const struct aob_trace_desc desc = {.screen = &screen,
                                        .technique = &aob_technique_known,
                                        .values = &(struct values){0},
                                        .device_bytes = device_bytes,
                                        .host_bytes = host_bytes};
    assert_false(aob_trace_init(trace, &desc, &error));
    assert_string_equal(error.text, text);
    assert_true(trace->unfit);
    aob_screen_finish(&screen);
    aob_gpu_texture_destroy(f->gpu, geometry.texture);
    free(trace);
}

static void test_ceilings_too_low(void **state)
{
    (void)state;
    struct fixture *f = fixture_create("gl-egl", "cover");
    expect_refusal(f, 32 + (W - 1) * ENTRY, 0,
                   "known: pass 'drawn': the 24 fragments of a row of one triangle take 16 bytes of trace "
                   "each, and 23 of them fit: use a smaller image or a higher ceiling");
    expect_refusal(f, 0, 44,
                   "known: pass 'drawn': a fragment takes 16 bytes of trace on the device and 48 here, which "
                   "does not fit into 134217696 and 44: use a higher ceiling");
    fixture_destroy(f);
}

/* --- A device whose runs differ: what it counts is changed on the way. --------------------------------------------- */

static const struct aob_gpu_fns *original;
static uint32_t fewer_fragments, more_slots;

static bool read_changed(struct aob_gpu *gpu, const struct aob_gpu_buffer *buffer, size_t offset, size_t size,
                         void *bytes, struct aob_error *error)
{
    bool ok = original->buffer_read(gpu, buffer, offset, size, bytes, error);
    if (ok && offset == 0) { /* the head of trace.glsl */
        uint32_t *head = bytes;
        head[3] += more_slots;
        head[4] -= fewer_fragments;
    }
    return ok;
}

static void expect_difference(struct fixture *f, uint32_t fragments, uint32_t slots, const char *text)
{
    struct aob_error error = {""};
    const struct aob_trace_sink sink = {&f->taken, taken_begin, taken_band, taken_end};
    struct aob_gpu_fns fns = *f->gpu->fns;
    open_trace(f, 0);
    original = f->gpu->fns;
    fns.buffer_read = read_changed;
    f->gpu->fns = &fns;
    fewer_fragments = fragments;
    more_slots = slots;
    f->taken = (struct taken){0};
    assert_false(aob_trace_run(&f->traced.trace, &sink, &error));
    assert_string_equal(error.text, text);
    f->gpu->fns = original;
    taken_finish(&f->taken);
    traced_finish(&f->traced);
}

static void test_runs_that_differ(void **state)
{
    (void)state;
    struct fixture *f = fixture_create("gl-egl", "cover");
    char text[256];
    size_t all = f->rig.geometry.count * PIXELS;
    snprintf(text, sizeof text,
             "known: pass 'drawn' drew %zu fragments where it had drawn %zu: the device gives other results "
             "from run to run",
             all - 1, all);
    expect_difference(f, 1, 0, text);
    expect_difference(f, 0, 1,
                      "known: pass 'drawn' read 3 texels where it had read 2 at most: the device gives other "
                      "results from run to run");
    fixture_destroy(f);
}

/* Triangles without area cover no pixel: a capture of nothing, whose cost is known. */
static void test_no_fragments(void **state)
{
    (void)state;
    for (size_t b = 0; b < AOB_COUNT(backends); b++) {
        struct fixture *f = fixture_create(backends[b], "nothing");
        open_trace(f, 0);
        assert_true(isfinite(f->traced.trace.cost.seconds));
        assert_true(f->traced.trace.cost.words == 0);
        take(&f->traced, &f->taken);
        assert_int_equal(f->taken.ended, 1);
        assert_int_equal(f->taken.passes[0].count, 0);
        taken_finish(&f->taken);
        traced_finish(&f->traced);
        fixture_destroy(f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_known_fragments), cmocka_unit_test(test_ceilings_too_low),
        cmocka_unit_test(test_runs_that_differ), cmocka_unit_test(test_no_fragments)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
