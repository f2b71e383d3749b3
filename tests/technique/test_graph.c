#include "check.h"
#include "trial.h"

static bool build_chain(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g), done = aob_texture(g, .name = "done"),
            unused = aob_texture(g, .name = "unused", .divisor = 2);
    return aob_pass(g, .name = "first", .shader = "one", .reads = AOB_DEPTH, .out = OUT(raw)) &&
           aob_pass(g, .name = "extra", .shader = "two", .in = {{.name = "i", .tex = raw}},
                    .out = OUT(unused)) &&
           aob_pass(g, .name = "last", .shader = "two", .in = {{.name = "i", .tex = raw}},
                    .out = OUT(done)) &&
           aob_output(g, AOB_OUT_VISIBILITY, done);
}
static bool build_loop(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one", .in = {{.name = "i", .tex = raw}},
                    .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
static bool build_no_output(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(RAW(g)));
}
static bool build_unwritten(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_output(g, AOB_OUT_VISIBILITY, RAW(g));
}
static bool build_twice_written(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(raw)) &&
           aob_pass(g, .name = "again", .shader = "one", .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
static bool build_no_shader(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "three", .out = OUT(RAW(g)));
}
static bool build_same_names(struct aob_graph *g, const void *values)
{
    (void)values;
    return RAW(g).id && RAW(g).id;
}
static bool build_half_output(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex half = aob_texture(g, .name = "half", .divisor = 2);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(half)) &&
           aob_output(g, AOB_OUT_VISIBILITY, half);
}
static bool build_mixed_sizes(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex half = aob_texture(g, .name = "half", .divisor = 2), full = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one",
                    .out = {{.name = "a", .tex = half}, {.name = "b", .tex = full}}) &&
           aob_output(g, AOB_OUT_VISIBILITY, full);
}
static void fill(const void *values, void *texels)
{
    (void)values;
    (void)texels;
}
static bool build_table(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex table = aob_texture(g, .name = "table", .format = AOB_R8, .width = 4, .height = 2, .fill = fill);
    aob_tex low = aob_texture(g, .name = "low", .format = AOB_R32F, .divisor = 4), raw = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one", .reads = AOB_DEPTH, .out = OUT(low)) &&
           aob_pass(g, .name = "last", .shader = "two", .reads = AOB_DEPTH, .depth = low,
                    .in = {{.name = "i", .tex = table}}, .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
static bool build_written_table(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex table = aob_texture(g, .name = "table", .format = AOB_R8, .width = 4, .height = 2, .fill = fill);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(table)) &&
           aob_output(g, AOB_OUT_VISIBILITY, RAW(g));
}
static bool build_divided_table(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_texture(g, .name = "table", .width = 4, .height = 2, .divisor = 2, .fill = fill).id;
}
static bool build_sized_target(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_texture(g, .name = "target", .width = 4, .height = 2).id;
}
static bool depth_pass(struct aob_graph *g, aob_tex depth, uint32_t reads)
{
    return aob_pass(g, .name = "last", .shader = "two", .reads = reads, .depth = depth, .out = OUT(RAW(g)));
}
static bool build_byte_depth(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex low = aob_texture(g, .name = "low", .format = AOB_R8, .divisor = 4);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(low)) && depth_pass(g, low, AOB_DEPTH);
}
static bool build_unread_depth(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex low = aob_texture(g, .name = "low", .format = AOB_R32F);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(low)) && depth_pass(g, low, 0);
}
static bool build_unwritten_depth(struct aob_graph *g, const void *values)
{
    (void)values;
    return depth_pass(g, aob_texture(g, .name = "low", .format = AOB_R32F), AOB_DEPTH);
}
static bool triangles_pass(struct aob_graph *g, const char *vertex, uint32_t count, float reach)
{
    aob_tex raw = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one", .draw = AOB_TRIANGLES, .vertex = vertex,
                    .per_triangle = count, .reach = reach, .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
static bool build_triangles(struct aob_graph *g, const void *values)
{
    (void)values;
    return triangles_pass(g, "two", 6, 1);
}
static bool build_no_vertex_shader(struct aob_graph *g, const void *values)
{
    (void)values;
    return triangles_pass(g, "three", 6, 1);
}
static bool build_unnamed_vertex_shader(struct aob_graph *g, const void *values)
{
    (void)values;
    return triangles_pass(g, NULL, 6, 1);
}
static bool build_four_vertices(struct aob_graph *g, const void *values)
{
    (void)values;
    return triangles_pass(g, "two", 4, 1);
}
static bool build_too_many_vertices(struct aob_graph *g, const void *values)
{
    (void)values;
    return triangles_pass(g, "two", 39, 1);
}
static bool build_no_reach(struct aob_graph *g, const void *values)
{
    (void)values;
    return triangles_pass(g, "two", 6, 0);
}
static bool build_screen_with_vertex(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .vertex = "two", .out = OUT(RAW(g)));
}
static bool build_unknown_draw(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .draw = (enum aob_draw)7, .out = OUT(RAW(g)));
}
static bool give(struct aob_graph *g, enum aob_output which, enum aob_format format)
{
    aob_tex raw = RAW(g), more = aob_texture(g, .name = "more", .format = format);
    aob_pass(g, .name = "first", .shader = "one", .out = OUT(raw));
    aob_pass(g, .name = "second", .shader = "two", .out = OUT(more));
    return aob_output(g, AOB_OUT_VISIBILITY, raw) && aob_output(g, which, more);
}
static bool build_bent_normal(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_wants(g, AOB_OUT_BENT_NORMAL) ? give(g, AOB_OUT_BENT_NORMAL, AOB_RGBA16F)
                                             : give(g, AOB_OUT_VISIBILITY, AOB_R16F);
}
static bool build_always_bent_normal(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_BENT_NORMAL, AOB_RGBA16F);
}
static bool build_byte_bent_normal(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_BENT_NORMAL, AOB_RGBA8);
}
static bool build_output_twice(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_VISIBILITY, AOB_R16F);
}
static bool build_specular(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_SPECULAR, AOB_R16F);
}
static bool build_unwritten_bent_normal(struct aob_graph *g, const void *values)
{
    aob_tex more = aob_texture(g, .name = "more", .format = AOB_RGBA32F);
    return build_chain(g, values) && aob_output(g, AOB_OUT_BENT_NORMAL, more);
}
static bool build_material(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .reads = AOB_DEPTH | AOB_MATERIAL,
                    .out = OUT(RAW(g)));
}

static bool build_light(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .reads = AOB_DEPTH | AOB_LIGHT, .out = OUT(RAW(g)));
}

/* The second texture of one name is the fault; the pass and the output after it only follow from it. */
static bool build_two_faults(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex first = aob_texture(g, .name = "twin", .format = AOB_R16F);
    aob_tex second = aob_texture(g, .name = "twin", .format = AOB_R16F);
    (void)first;
    aob_pass(g, .name = "first", .shader = "none of that name", .out = OUT(second));
    return aob_output(g, AOB_OUT_VISIBILITY, second);
}

static bool build_velocity(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .reads = AOB_DEPTH | AOB_VELOCITY,
                    .out = OUT(RAW(g)));
}
static bool build_previous(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_previous(g, RAW(g)).id;
}
static bool defines_pass(struct aob_graph *g, const char *name)
{
    aob_tex raw = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one", .defines = {{"A", -2}, {name, 7}},
                    .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
static bool build_defines(struct aob_graph *g, const void *values)
{
    char name[] = "WIDE_2"; /* gone when the prelude is written */
    (void)values;
    return defines_pass(g, name);
}
static bool build_lower_define(struct aob_graph *g, const void *values)
{
    (void)values;
    return defines_pass(g, "wide");
}
static bool build_prelude_define(struct aob_graph *g, const void *values)
{
    (void)values;
    return defines_pass(g, "AOB_DIVISOR");
}
static bool build_ignores_failure(struct aob_graph *g, const void *values)
{
    aob_texture(g, .name = "Bad Name");
    return build_chain(g, values);
}
static bool build_too_many(struct aob_graph *g, const void *values)
{
    (void)values;
    char name[16];
    for (int i = 0; i < 100; i++) {
        snprintf(name, sizeof name, "t%d", i);
        if (!aob_texture(g, .name = name).id)
            return false;
    }
    return true;
}

static void test_prunes_what_nobody_wants(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    assert_true(try_build(&graph, build_chain, &error));
    assert_true(graph.passes[0].live);
    assert_false(graph.passes[1].live);
    assert_true(graph.passes[2].live);
    assert_false(graph.textures[2].used);
    int w, h;
    aob_graph_texture_size(&graph.textures[2], 101, 7, &w, &h);
    assert_int_equal(w, 51);
    assert_int_equal(h, 4);
}

static void test_broken_graphs_are_named(void **state)
{
    (void)state;
    const struct {
        bool (*build)(struct aob_graph *, const void *);
        const char *says;
    } cases[] = {{build_loop, "no earlier pass writes"},
                 {build_no_output, "gives no output visibility"},
                 {build_unwritten, "no pass writes texture 'raw'"},
                 {build_twice_written, "already written"},
                 {build_no_shader, "no shader text 'three'"},
                 {build_same_names, "two textures are named 'raw'"},
                 {build_half_output, "not full size"},
                 {build_mixed_sizes, "different sizes"},
                 {build_ignores_failure, "lower-case"},
                 {build_too_many, "more than 64 textures"},
                 {build_written_table, "writes the table"},
                 {build_divided_table, "no divisor"},
                 {build_sized_target, "a target none of the three"},
                 {build_byte_depth, "not a target of r16f or r32f"},
                 {build_unread_depth, "does not read it"},
                 {build_unwritten_depth, "no earlier pass writes"},
                 {build_no_vertex_shader, "no shader text 'three'"},
                 {build_unnamed_vertex_shader, "a vertex shader has no name"},
                 {build_four_vertices, "per_triangle is 4"},
                 {build_too_many_vertices, "per_triangle is 39"},
                 {build_no_reach, "reach is 0"},
                 {build_screen_with_vertex, "of AOB_TRIANGLES only"},
                 {build_unknown_draw, "unknown draw"},
                 {build_byte_bent_normal, "bent_normal: texture 'more' is rgba8: must be rgba16f or rgba32f"},
                 {build_output_twice, "output visibility is given twice"},
                 {build_specular, "output specular is reserved"},
                 {build_unwritten_bent_normal, "no pass writes texture 'more' of the output bent_normal"},
                 {build_velocity, "velocity, material or light: they are reserved"},
                 {build_material, "velocity, material or light: they are reserved"},
                 {build_light, "velocity, material or light: they are reserved"},
                 {build_two_faults, "two textures are named 'twin'"},
                 {build_previous, "previous textures are reserved"},
                 {build_lower_define, "define 'wide'"},
                 {build_prelude_define, "define 'AOB_DIVISOR'"}};
    struct aob_pass_graph graph;
    struct aob_error error;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        assert_false(try_build(&graph, cases[i].build, &error));
        assert_contains(error.text, cases[i].says);
        assert_contains(error.text, "trial: ");
    }
}

static void test_triangles(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    struct aob_text dot = {0};
    assert_true(try_build(&graph, build_chain, &error));
    assert_false(aob_graph_needs_triangles(&graph));
    assert_true(try_build(&graph, build_triangles, &error));
    assert_true(aob_graph_needs_triangles(&graph));
    assert_int_equal(graph.passes[0].per_triangle, 6);
    aob_graph_dot(&graph, &dot);
    assert_contains(dot.data, "triangles -> first");
    aob_text_finish(&dot);
}

static void test_tables_and_depths(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    struct aob_text text = {0};
    assert_true(try_build(&graph, build_table, &error));
    assert_true(graph.passes[0].live && graph.textures[0].used && graph.textures[1].used);
    assert_int_equal(aob_graph_depth_divisor(&graph, &graph.passes[0]), 1);
    assert_int_equal(aob_graph_target_divisor(&graph, &graph.passes[0]), 4);
    assert_int_equal(aob_graph_depth_divisor(&graph, &graph.passes[1]), 4);
    int w, h;
    aob_graph_texture_size(&graph.textures[0], 101, 7, &w, &h);
    assert_int_equal(w, 4);
    assert_int_equal(h, 2);
    aob_graph_dot(&graph, &text);
    assert_contains(text.data, "first -> last [label=\"low\"]");
    assert_contains(text.data, "table -> last");
    aob_text_finish(&text);
}

static void test_outputs_beside_visibility(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    struct aob_text dot = {0};
    assert_true(try_build(&graph, build_chain, &error));
    assert_true(aob_graph_gives(&graph, AOB_OUT_VISIBILITY));
    assert_false(aob_graph_gives(&graph, AOB_OUT_BENT_NORMAL));
    assert_true(try_build(&graph, build_bent_normal, &error));
    assert_true(aob_graph_gives(&graph, AOB_OUT_BENT_NORMAL) && graph.passes[1].live);
    aob_graph_dot(&graph, &dot);
    assert_contains(dot.data, "first -> visibility");
    assert_contains(dot.data, "second -> bent_normal");
    aob_text_finish(&dot);
    struct aob_technique technique = {.name = "trial", .shaders = shaders, .build = build_always_bent_normal};
    assert_true(aob_graph_build(&graph, &technique, &(struct values){0}, AOB_OUTPUTS_REQUIRED, 0, &error));
    assert_false(aob_graph_gives(&graph, AOB_OUT_BENT_NORMAL) || graph.passes[1].live);
    technique.build = build_chain;
    assert_false(
        aob_graph_build(&graph, &technique, &(struct values){0}, 1 << AOB_OUT_BENT_NORMAL, 0, &error));
    assert_contains(error.text, "gives no output bent_normal");
    technique.frames = 2;
    assert_false(aob_graph_build(&graph, &technique, &(struct values){0}, AOB_OUTPUTS_REQUIRED, 0, &error));
    assert_contains(error.text, "frames is 2: it is reserved");
}

static void test_defines_are_kept(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    assert_true(try_build(&graph, build_defines, &error));
    assert_int_equal(graph.passes[0].define_count, 2);
    assert_string_equal(graph.passes[0].defines[1].name, "WIDE_2");
    assert_int_equal(graph.passes[0].defines[0].value, -2);
}

static void test_digest_follows_constants_only(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    char a[AOB_KEY_SIZE], b[AOB_KEY_SIZE], c[AOB_KEY_SIZE];
    assert_true(try_build(&graph, build_chain, &error));
    aob_graph_digest(&graph, &(struct values){3, 1}, a);
    aob_graph_digest(&graph, &(struct values){3, 2}, b);
    aob_graph_digest(&graph, &(struct values){4, 1}, c);
    assert_string_equal(a, b);
    assert_string_not_equal(a, c);
}

static void test_dot_picture(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    struct aob_text text = {0};
    assert_true(try_build(&graph, build_chain, &error));
    aob_graph_dot(&graph, &text);
    assert_contains(text.data, "digraph trial {");
    assert_contains(text.data, "extra [style=dashed]");
    assert_contains(text.data, "gbuffer -> first");
    assert_contains(text.data, "first -> last [label=\"raw\"]");
    assert_contains(text.data, "last -> visibility");
    aob_text_finish(&text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_prunes_what_nobody_wants),
                                       cmocka_unit_test(test_broken_graphs_are_named),
                                       cmocka_unit_test(test_triangles),
                                       cmocka_unit_test(test_tables_and_depths),
                                       cmocka_unit_test(test_outputs_beside_visibility),
                                       cmocka_unit_test(test_defines_are_kept),
                                       cmocka_unit_test(test_digest_follows_constants_only),
                                       cmocka_unit_test(test_dot_picture)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
