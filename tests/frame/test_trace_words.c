/* The words of built-in techniques: they address what the shaders fetched, strips do not show in them, and the fragments
 * of drawn triangles come once each. */
#include "traced.h"
#include "base/half.h"
#include "base/text.h"
#include "frame/trace_draw.h"
#include "technique/registry.h"

enum { W = 96, H = 54 };

static const struct aob_technique *find(const char *name)
{
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        if (strcmp((*t)->name, name) == 0)
            return *t;
    fail_msg("no technique %s", name);
    return NULL;
}

struct ceilings {
    size_t device, host;
};

static void start(struct traced *traced, const struct aob_rig *rig, struct aob_gpu *gpu, const char *name,
                  const char *params, struct ceilings ceilings)
{
    const struct aob_technique *technique = find(name);
    struct aob_options options;
    unsigned char values[4 * AOB_MAX_PARAM];
    aob_rig_params(technique, params, values, &options);
    traced_init(traced, rig, gpu,
                &(struct traced_desc){technique, values, &options, ceilings.device, ceilings.host});
}

static void capture(const struct aob_rig *rig, const char *backend, const char *name,
                    struct ceilings ceilings, struct taken *taken)
{
    struct traced *traced = AOB_NEW(struct traced);
    struct aob_gpu *gpu = aob_rig_gpu(backend);
    start(traced, rig, gpu, name, "", ceilings);
    take(traced, taken);
    traced_finish(traced);
    aob_gpu_close(gpu);
    free(traced);
}

/* Of gtao at its defaults a row takes 96 x 45 words at most: strips of one row, of an odd number, across bands' ends. */
static void test_strips_do_not_show(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct taken *whole = AOB_NEW(struct taken), *strips = AOB_NEW(struct taken);
    aob_rig_scene(&rig, "cornell", "blocks", W, H, 10); /* 74 rows: two bands */
    static const size_t rows[] = {1, 3, 7, 65};
    capture(&rig, "gl-egl", "gtao", (struct ceilings){0}, whole);
    size_t slots = 0;
    for (size_t i = 0; i < whole->pass_count; i++)
        slots = whole->passes[i].slots > slots ? whole->passes[i].slots : slots;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        size_t device = AOB_TRACE_HEAD_BYTES + 4 * rows[i] * (W + 20) * slots;
        capture(&rig, "gl-egl", "gtao", (struct ceilings){device, 4 * 64 * (W + 20) * slots}, strips);
        assert_same_words(whole, strips);
        taken_finish(strips);
    }
    taken_finish(whole);
    free(whole);
    free(strips);
    aob_rig_finish(&rig);
}

static const struct taken_pass *fragments_of(const struct taken *taken)
{
    for (size_t i = 0; i < taken->pass_count; i++)
        if (taken->passes[i].pass.fragments)
            return &taken->passes[i];
    fail_msg("no pass of triangles");
    return NULL;
}

/* Pixels rise within a triangle, and a triangle covers none twice: so a pixel that is not above the one before begins
 * another triangle, and there are no more of them than are drawn. What each fragment reads, it reads at its own pixel. */
static void check_fragments(const struct taken *taken, const struct aob_rig *rig)
{
    const struct taken_pass *pass = fragments_of(taken);
    size_t begun = 0;
    assert_true(pass->count > 1000);
    for (size_t i = 0; i < pass->count; i++) {
        uint32_t x = pass->pixels[i] & 0xffff, y = pass->pixels[i] >> 16;
        assert_true(x < (uint32_t)pass->pass.width && y < (uint32_t)pass->pass.height);
        if (i == 0 || (pass->pixels[i - 1] >> 16) * 65536 + (pass->pixels[i - 1] & 0xffff) >= y * 65536 + x)
            begun++;
        const struct aob_trace_plane *plane = &pass->pass.planes[0]; /* the depth, four times as wide */
        assert_int_equal(pass->words[i * pass->slots], plane->first + 4 * y * (uint32_t)plane->width + 4 * x);
    }
    assert_true(begun <= 2 * rig->geometry.count);
}

/* The same fragments on every driver, in the same order, whatever fits: all at once, or few triangles. That not even one
 * fits is tested with triangles that are known (trace_fragments). */
static void test_fragments(void **state)
{
    (void)state;
    struct aob_rig rig;
    struct taken *first = AOB_NEW(struct taken), *other = AOB_NEW(struct taken);
    static const char *const others[] = {"vulkan", "gl-osmesa"};
    static const size_t room[] = {1000, 400};
    aob_rig_scene(&rig, "cornell", "blocks", W, H, 0);
    capture(&rig, "gl-egl", "ao_volumes", (struct ceilings){0}, first);
    check_fragments(first, &rig);
    for (size_t i = 0; i < AOB_COUNT(others); i++) {
        capture(&rig, others[i], "ao_volumes", (struct ceilings){0}, other);
        const struct taken_pass *a = fragments_of(first), *b = fragments_of(other);
        assert_int_equal(a->count, b->count);
        assert_memory_equal(a->pixels, b->pixels, 4 * a->count);
        taken_finish(other);
    }
    size_t entry = 4 * (2 + fragments_of(first)->slots);
    for (size_t i = 0; i < AOB_COUNT(room); i++) {
        capture(&rig, "gl-egl", "ao_volumes", (struct ceilings){AOB_TRACE_HEAD_BYTES + room[i] * entry, 0},
                other);
        assert_same_words(first, other);
        taken_finish(other);
    }
    taken_finish(first);
    free(first);
    free(other);
    aob_rig_finish(&rig);
}

/* --- What was fetched: the driver of a test is told to add up the bits of all that a traced pass fetches. ---------- */

static const struct aob_gpu_fns *original;
static const struct aob_pass_graph *summed; /* NULL: programs are compiled as they are */
static int next_pass;

static const char summing[] =
    "uint aob_sum = 0u;\n"
    "float aob_add(float v, float s) { aob_sum += s > 0.0 ? uint(v * s + 0.5) : floatBitsToUint(v); return "
    "v; }\n"
    "vec2 aob_add(vec2 v, float s) { aob_add(v.x, s); aob_add(v.y, s); return v; }\n"
    "vec4 aob_add(vec4 v, float s) { aob_add(v.xy, s); aob_add(v.zw, s); return v; }\n"
    "void aob_note(uint word) {";

/* Of a format's codes, where they are whole numbers; 0: floats. */
static double scale_of(enum aob_format format)
{
    return format == AOB_R16 ? 65535 : format == AOB_R8 || format == AOB_RG8 || format == AOB_RGBA8 ? 255 : 0;
}

static double scale_of_image(const struct aob_graph_pass *pass, const char *name, size_t size)
{
    for (int i = 0; i < pass->in_count; i++)
        if (strlen(pass->in[i].name) == size && strncmp(pass->in[i].name, name, size) == 0)
            return scale_of(summed->textures[pass->in[i].texture].format);
    return 0; /* the screen's own are floats by default */
}

/* The text with each fetch in aob_add, and the sum added to the buffer's first spare word at the end. */
static void write_summing(const char *text, struct aob_text *out)
{
    static const char fetch[] = "return texelFetch(aob_image_", open[] = "void aob_note(uint word) {",
                      close[] = "atomicMax(aob_trace.most, aob_slot);";
    const struct aob_graph_pass *pass = &summed->passes[next_pass];
    while (*text) {
        if (strncmp(text, open, strlen(open)) == 0) {
            aob_text_add(out, "%s", summing);
            text += strlen(open);
        } else if (strncmp(text, close, strlen(close)) == 0) {
            aob_text_add(out, "%s atomicAdd(aob_trace.spare[0], aob_sum);", close);
            text += strlen(close);
        } else if (strncmp(text, fetch, strlen(fetch)) == 0) {
            const char *name = text + strlen(fetch);
            int size = (int)strcspn(text, ";");
            aob_text_add(out, "return aob_add(%.*s, %.1f);", size - 7, text + 7,
                         scale_of_image(pass, name, strcspn(name, ",")));
            text += size + 1;
        } else {
            aob_text_add(out, "%c", *text++);
        }
    }
}

static bool create_summing(struct aob_gpu *gpu, const struct aob_gpu_program_desc *desc,
                           struct aob_gpu_program **program, struct aob_error *error)
{
    struct aob_text text = {0};
    if (!strstr(desc->fragment, "AobTrace"))
        return original->program_create(gpu, desc, program, error);
    while (!summed->passes[next_pass].live)
        next_pass++;
    write_summing(desc->fragment, &text);
    next_pass++;
    const struct aob_gpu_program_desc summing_desc = {.vertex = desc->vertex, .fragment = text.data};
    bool ok = original->program_create(gpu, &summing_desc, program, error);
    aob_text_finish(&text);
    return ok;
}

static uint32_t sum_of_texel(const unsigned char *texel, enum aob_format format)
{
    uint32_t sum = 0;
    for (int c = 0; c < aob_gpu_texel_components(format); c++) {
        uint16_t half;
        uint32_t bits;
        float value;
        switch (aob_gpu_texel_size(format) / (size_t)aob_gpu_texel_components(format)) {
        case 1:
            sum += texel[c];
            break;
        case 2:
            memcpy(&half, texel + 2 * c, 2);
            value = aob_half_to_float(half);
            memcpy(&bits, &value, 4);
            sum += format == AOB_R16 ? half : bits;
            break;
        default:
            memcpy(&bits, texel + 4 * c, 4);
            sum += bits;
        }
    }
    return sum;
}

/* Of the texels of a plane, by the graph's texture or the screen's. */
static uint32_t *plane_sums(struct traced *traced, const struct taken *taken,
                            const struct aob_trace_plane *plane)
{
    const struct aob_trace_texture *texture = &taken->frame.textures[plane->texture];
    const struct aob_pass_graph *graph = &traced->trace.frame.graph;
    const struct aob_gpu_texture *found = NULL;
    size_t count = (size_t)plane->width * (size_t)plane->height, size = aob_gpu_texel_size(texture->format);
    struct aob_error error = {""};
    for (int i = 0; i < graph->texture_count; i++)
        if (texture->role == AOB_TRACE_ROLE_GRAPH && graph->textures[i].used &&
            strcmp(graph->textures[i].name, texture->name) == 0)
            found = traced->trace.frame.textures[i];
    unsigned char *texels = texture->role == AOB_TRACE_ROLE_DEPTH
                                ? aob_encoding_depth_texels(&traced->screen.encoding, traced->screen.gbuffer)
                            : texture->role == AOB_TRACE_ROLE_NORMAL
                                ? aob_encoding_normal_texels(&traced->screen.encoding, traced->screen.gbuffer)
                                : aob_alloc(count, size);
    if (found && !aob_gpu_texture_read(traced->gpu, found, plane->level, texels, &error))
        fail_msg("%s", error.text);
    uint32_t *sums = AOB_NEW_ARRAY(uint32_t, count);
    for (size_t i = 0; i < count; i++)
        sums[i] = sum_of_texel(texels + i * size, texture->format);
    free(texels);
    return sums;
}

static uint32_t sum_of_words(struct traced *traced, const struct taken *taken, const struct taken_pass *pass)
{
    uint32_t sum = 0;
    for (int p = 0; p < pass->pass.plane_count; p++) {
        const struct aob_trace_plane *plane = &pass->pass.planes[p];
        uint32_t *sums = plane_sums(traced, taken, plane), count = (uint32_t)(plane->width * plane->height);
        for (size_t i = 0; i < pass->count * pass->slots; i++)
            if (pass->words[i] - plane->first < count)
                sum += sums[pass->words[i] - plane->first];
        free(sums);
    }
    return sum;
}

/* What the pass adds up when it is drawn once more. */
static uint32_t sum_of_fetches(struct traced *traced, int index)
{
    struct aob_error error = {""};
    struct aob_trace_draw draw = {.slots = 0};
    uint32_t head[8];
    if (!aob_trace_draw(&traced->trace, index, &draw, &error) ||
        !aob_gpu_buffer_read(traced->gpu, traced->trace.capture->buffer, 0, sizeof head, head, &error))
        fail_msg("%s", error.text);
    return head[5];
}

static void check_sums(struct aob_gpu *gpu, const struct aob_rig *rig, const char *name, const char *params)
{
    struct traced *traced = AOB_NEW(struct traced);
    struct taken *taken = AOB_NEW(struct taken);
    struct aob_pass_graph *graph = AOB_NEW(struct aob_pass_graph);
    struct aob_options options;
    struct aob_error error = {""};
    unsigned char values[4 * AOB_MAX_PARAM];
    aob_rig_params(find(name), params, values, &options);
    assert_true(aob_graph_build(graph, find(name), values, 0, &error));
    summed = graph;
    next_pass = 0;
    start(traced, rig, gpu, name, params, (struct ceilings){0});
    take(traced, taken);
    for (size_t i = 0; i < taken->pass_count; i++) {
        const struct taken_pass *pass = &taken->passes[i];
        uint32_t fetched = sum_of_fetches(traced, pass->pass.index),
                 addressed = sum_of_words(traced, taken, pass);
        if (fetched != addressed || (pass->slots && !fetched))
            fail_msg("%s, pass %s: fetched %x, words %x", name, pass->pass.name, fetched, addressed);
    }
    taken_finish(taken);
    traced_finish(traced);
    free(graph);
    free(taken);
    free(traced);
}

static void check_backend(const struct aob_rig *rig, const char *backend)
{
    struct aob_gpu *gpu = aob_rig_gpu(backend);
    struct aob_gpu_fns fns = *gpu->fns;
    original = gpu->fns;
    fns.program_create = create_summing;
    gpu->fns = &fns;
    for (const struct aob_technique *const *t = aob_builtin_techniques; *t; t++)
        check_sums(gpu, rig, (*t)->name, "");
    check_sums(gpu, rig, "gtao", "divisor=2 depth_divisor=2");
    check_sums(gpu, rig, "starcraft2_ssao", "blocker=table");
    gpu->fns = original;
    aob_gpu_close(gpu);
}

/* An integer sum over the bits of all that was fetched: one wrong texel changes it, and there is no rounding. A unorm's
 * code is a whole number. */
static void test_words_address_what_was_fetched(void **state)
{
    (void)state;
    struct aob_rig rig;
    aob_rig_scene(&rig, "cornell", "blocks", W, H, 0);
    check_backend(&rig, "vulkan");
    check_backend(&rig, "gl-egl");
    aob_rig_finish(&rig);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_strips_do_not_show),
                                       cmocka_unit_test(test_fragments),
                                       cmocka_unit_test(test_words_address_what_was_fetched)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
