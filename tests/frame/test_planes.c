/* What a trace tells of a frame's textures, and how it numbers the texels of a pass. No device is needed. */
#include "check.h"
#include <stdlib.h>
#include "base/memory.h"
#include "frame/planes.h"
#include "profile/layout.h"

enum { W = 70, H = 67 };

struct values {
    int32_t unused;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, unused, .min = 0, .max = 9, .stage = AOB_HOST, .doc = ".")};
static const struct aob_shader shaders[] = {{"any", "void main() {}\n"}, {NULL, NULL}};

static void fill(const void *values, void *texels)
{
    (void)values;
    (void)texels;
}

/* A technique may call its textures what the screen calls its own. */
static bool build_namesakes(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex depth = aob_texture(graph, .name = "depth", .format = AOB_RG16F),
            normal = aob_texture(graph, .name = "normal", .format = AOB_R8),
            out = aob_texture(graph, .name = "out", .format = AOB_R32F);
    aob_pass(graph, .name = "make", .shader = "any", .reads = AOB_DEPTH,
             .out = {{.name = "d", .tex = depth}, {.name = "n", .tex = normal}});
    aob_pass(graph, .name = "show", .shader = "any", .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = "d", .tex = depth}, {.name = "n", .tex = normal}},
             .out = {{.name = "o", .tex = out}});
    return aob_output(graph, AOB_OUT_VISIBILITY, out);
}

static uint32_t table_width;

static bool build_table(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex table = aob_texture(graph, .name = "table", .format = AOB_R8, .width = table_width, .height = 1,
                                .fill = fill),
            out = aob_texture(graph, .name = "out", .format = AOB_R32F);
    aob_pass(graph, .name = "show", .shader = "any", .reads = AOB_DEPTH | AOB_NORMAL,
             .in = {{.name = "t", .tex = table}}, .out = {{.name = "o", .tex = out}});
    return aob_output(graph, AOB_OUT_VISIBILITY, out);
}

static struct aob_gpu_texture depth_texture, normal_texture;

struct rig {
    struct aob_technique technique;
    struct aob_pass_graph graph;
    struct aob_gbuffer gbuffer;
    struct aob_screen screen;
    struct aob_planes planes;
};

static struct rig *rig_create(bool (*build)(struct aob_graph *, const void *), int width, int height)
{
    struct aob_error error = {""};
    struct rig *rig = AOB_NEW(struct rig);
    rig->technique = (struct aob_technique){.abi = AOB_ABI,
                                            .size = sizeof rig->technique,
                                            .name = "planes",
                                            .shaders = shaders,
                                            .params = params,
                                            .param_count = 1,
                                            .values_size = sizeof(struct values),
                                            .build = build};
    if (!aob_graph_build(&rig->graph, &rig->technique, &(struct values){0}, 0, &error))
        fail_msg("%s", error.text);
    rig->gbuffer.projection.width = width;
    rig->gbuffer.projection.height = height;
    rig->screen =
        (struct aob_screen){.gbuffer = &rig->gbuffer, .depth = &depth_texture, .normal = &normal_texture};
    return rig;
}

/* The only one of that role, which must be one of the screen's. */
static int find_role(const struct rig *rig, enum aob_trace_role role, enum aob_format format)
{
    int found = -1;
    for (int t = 0; t < rig->planes.frame.texture_count; t++)
        if (rig->planes.frame.textures[t].role == role) {
            assert_int_equal(found, -1);
            found = t;
        }
    assert_int_not_equal(found, -1);
    assert_int_equal(rig->planes.frame.textures[found].format, format);
    return found;
}

/* A profile's bytes of depth and normal are those of the screen's. */
static void test_roles(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct rig *rig = rig_create(build_namesakes, W, H);
    struct aob_placed_frame *placed = AOB_NEW(struct aob_placed_frame);
    const struct aob_profile profile = {.layout = AOB_LAYOUT_LINEAR, .depth_bytes = 8, .normal_bytes = 2};
    assert_true(aob_planes_init(&rig->planes, &rig->graph, &rig->screen, &error));
    assert_int_equal(rig->planes.frame.texture_count, 5);
    int depth = find_role(rig, AOB_TRACE_ROLE_DEPTH, AOB_R32F),
        normal = find_role(rig, AOB_TRACE_ROLE_NORMAL, AOB_RGBA32F);
    assert_true(aob_layout_place(&profile, &rig->planes.frame, placed, &error));
    for (int t = 0; t < 5; t++) {
        const struct aob_trace_texture *texture = &rig->planes.frame.textures[t];
        int own = (int)aob_gpu_texel_size(texture->format);
        assert_int_equal(placed->bytes[t], t == depth ? 8 : t == normal ? 2 : own);
    }
    free(placed);
    free(rig);
}

/* Packed together they are one texture, which counts as the depth. */
static void test_a_shared_texture(void **state)
{
    (void)state;
    struct aob_error error = {""};
    struct rig *rig = rig_create(build_namesakes, W, H);
    rig->screen.encoding.depth = AOB_DEPTH_PACKED16;
    rig->screen.encoding.normal = AOB_NORMAL_PACKED8;
    rig->screen.normal = rig->screen.depth;
    assert_true(aob_planes_init(&rig->planes, &rig->graph, &rig->screen, &error));
    assert_int_equal(rig->planes.frame.texture_count, 4);
    find_role(rig, AOB_TRACE_ROLE_DEPTH, AOB_RGBA8);
    free(rig);
}

static bool numbers_fit(int width, int height, uint32_t table, struct aob_error *error)
{
    table_width = table;
    struct rig *rig = rig_create(build_table, width, height);
    bool fit = aob_planes_init(&rig->planes, &rig->graph, &rig->screen, error);
    if (fit)
        assert_int_equal(aob_planes_texels(&rig->planes.passes[0]), 2u * (uint32_t)(width * height) + table);
    free(rig);
    return fit;
}

/* 16383 x 16385 = 2^28 - 1 texels of depth and as many of normals: one more is the last that can be numbered, so that no
 * word has all bits set. */
static void test_most_texels(void **state)
{
    (void)state;
    struct aob_error error = {""};
    assert_true(numbers_fit(16383, 16385, 1, &error));
    assert_false(numbers_fit(16383, 16385, 2, &error));
    assert_string_equal(error.text,
                        "pass 'show' reads textures of more than 536870911 texels together, which "
                        "a trace cannot number: use a smaller image");
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_roles), cmocka_unit_test(test_a_shared_texture),
                                       cmocka_unit_test(test_most_texels)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
