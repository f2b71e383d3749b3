#include "trial.h"

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

static bool build_triangles(struct aob_graph *g, const void *values)
{
    (void)values;
    return triangles_pass(g, "two", 6, 1);
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

static bool build_defines(struct aob_graph *g, const void *values)
{
    char name[] = "WIDE_2"; /* gone when the prelude is written */
    (void)values;
    return defines_pass(g, name);
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
    assert_true(aob_graph_build(&graph, &technique, &(struct values){0}, 0, &error));
    assert_false(aob_graph_gives(&graph, AOB_OUT_BENT_NORMAL) || graph.passes[1].live);
}

/* A sum over the frames: what the first pass reads is written by the second. */
static bool build_history(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g), sum = aob_texture(g, .name = "sum", .format = AOB_R32F),
            unread = aob_texture(g, .name = "unread");
    return aob_pass(g, .name = "first", .shader = "one",
                    .in = {{.name = "before", .tex = aob_previous(g, sum)}}, .out = OUT(raw)) &&
           aob_pass(g, .name = "second", .shader = "two", .in = {{.name = "i", .tex = raw}},
                    .out = OUT(sum)) &&
           aob_pass(g, .name = "idle", .shader = "two", .in = {{.name = "i", .tex = aob_previous(g, unread)}},
                    .out = OUT(unread)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}

static bool build_without_history(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g), sum = aob_texture(g, .name = "sum", .format = AOB_R32F);
    return aob_pass(g, .name = "second", .shader = "two", .out = OUT(sum)) &&
           aob_pass(g, .name = "first", .shader = "one", .in = {{.name = "before", .tex = sum}},
                    .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}

static void test_history_keeps_its_writer_alive(void **state)
{
    (void)state;
    struct aob_pass_graph graph, other;
    struct aob_error error;
    struct aob_text dot = {0};
    char key[AOB_KEY_SIZE], other_key[AOB_KEY_SIZE];
    assert_true(try_build(&graph, build_history, &error));
    assert_true(aob_graph_keeps_history(&graph));
    assert_true(graph.passes[0].live && graph.passes[1].live && !graph.passes[2].live);
    assert_true(!graph.textures[0].kept && graph.textures[1].kept && !graph.textures[2].kept);
    aob_graph_dot(&graph, &dot);
    assert_contains(dot.data, "second -> first [label=\"sum\", style=dotted];");
    aob_text_finish(&dot);
    assert_true(try_build(&other, build_without_history, &error));
    assert_false(aob_graph_keeps_history(&other));
    aob_graph_digest(&graph, &(struct values){3, 1}, key);
    aob_graph_digest(&other, &(struct values){3, 1}, other_key);
    assert_string_not_equal(key, other_key);
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
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_prunes_what_nobody_wants),
        cmocka_unit_test(test_triangles),
        cmocka_unit_test(test_tables_and_depths),
        cmocka_unit_test(test_outputs_beside_visibility),
        cmocka_unit_test(test_history_keeps_its_writer_alive),
        cmocka_unit_test(test_defines_are_kept),
        cmocka_unit_test(test_digest_follows_constants_only),
        cmocka_unit_test(test_dot_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
