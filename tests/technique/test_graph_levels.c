#include "trial.h"

/* A pyramid of `taps` levels below a first one of divisor 2, read as a depth and as an input of its third level. */
static bool build_pyramid(struct aob_graph *g, const void *values)
{
    uint32_t levels = (uint32_t)((const struct values *)values)->taps + 1;
    aob_tex pyramid = aob_texture(g, .name = "pyramid", .format = AOB_R32F, .divisor = 2, .levels = levels),
            raw = RAW(g);
    aob_pass(g, .name = "level_0", .shader = "one", .reads = AOB_DEPTH, .out = OUT(pyramid));
    for (uint32_t l = 1; l < levels; l++) {
        char name[] = "level_0";
        name[6] = (char)('0' + l);
        aob_pass(g, .name = name, .shader = "two", .in = {{.name = "finer", .tex = pyramid, .level = l - 1}},
                 .out = {{.name = "o", .tex = pyramid, .level = l}});
    }
    return aob_pass(g, .name = "last", .shader = "two", .reads = AOB_DEPTH, .depth = pyramid,
                    .in = {{.name = "i", .tex = pyramid, .level = 2}}, .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
/* Level 2 is written after it is read, so the reader sees levels 0 and 1 only, and level 2 is for nobody. */
static bool build_late_level(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex t = aob_texture(g, .name = "t", .levels = 3), raw = RAW(g);
    aob_pass(g, .name = "first", .shader = "one", .out = OUT(t));
    aob_pass(g, .name = "second", .shader = "one", .out = {{.name = "o", .tex = t, .level = 1}});
    aob_pass(g, .name = "reader", .shader = "one", .in = {{.name = "i", .tex = t}}, .out = OUT(raw));
    return aob_pass(g, .name = "late", .shader = "one", .out = {{.name = "o", .tex = t, .level = 2}}) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
/* Level 1 of three is drawn together with a texture of half size; the third level is nobody's, and counts. */
static bool build_together(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex t = aob_texture(g, .name = "t", .levels = 3), half = aob_texture(g, .name = "half", .divisor = 2),
            raw = RAW(g);
    aob_pass(g, .name = "first", .shader = "one",
             .out = {{.name = "a", .tex = t, .level = 1}, {.name = "b", .tex = half}});
    return aob_pass(g, .name = "last", .shader = "two", .in = {{.name = "i", .tex = half}},
                    .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}
static bool level_pass(struct aob_graph *g, aob_tex t, uint32_t from, uint32_t to)
{
    return aob_pass(g, .name = "next", .shader = "one", .in = {{.name = "i", .tex = t, .level = from}},
                    .out = {{.name = "o", .tex = t, .level = to}});
}
static bool build_level_of_its_own(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex t = aob_texture(g, .name = "t", .levels = 2);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(t)) && level_pass(g, t, 1, 1);
}
static bool build_level_twice(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex t = aob_texture(g, .name = "t", .levels = 2);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(t)) && level_pass(g, t, 0, 1) &&
           aob_pass(g, .name = "again", .shader = "one", .out = {{.name = "o", .tex = t, .level = 1}});
}
static bool build_level_beyond(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex t = aob_texture(g, .name = "t", .levels = 2);
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(t)) && level_pass(g, t, 0, 2);
}
static bool build_mixed_levels(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex t = aob_texture(g, .name = "t", .levels = 2);
    return aob_pass(g, .name = "first", .shader = "one",
                    .out = {{.name = "a", .tex = RAW(g)}, {.name = "b", .tex = t, .level = 1}});
}
static bool build_many_levels(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_texture(g, .name = "t", .levels = 13).id;
}
static bool build_table_with_levels(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_texture(g, .name = "table", .width = 4, .height = 2, .levels = 2, .fill = fill).id;
}
static bool build_unwritten_first_level(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex t = aob_texture(g, .name = "t", .levels = 2);
    return aob_pass(g, .name = "first", .shader = "one", .out = {{.name = "o", .tex = t, .level = 1}}) &&
           aob_output(g, AOB_OUT_VISIBILITY, t);
}

static void test_levels(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    struct aob_text dot = {0};
    int w, h;
    assert_true(try_build(&graph, build_pyramid, &error));
    const struct aob_graph_pass *last = &graph.passes[graph.pass_count - 1];
    assert_int_equal(graph.pass_count, 5);
    for (int p = 0; p < 4; p++) {
        assert_true(graph.passes[p].live);
        assert_int_equal(aob_graph_target_divisor(&graph, &graph.passes[p]), 2 << p);
    }
    assert_int_equal(graph.passes[3].in[0].level_count, 1);
    assert_int_equal(aob_graph_bind_divisor(&graph, &graph.passes[3].in[0]), 8);
    assert_int_equal(last->depth_levels, 4);
    assert_int_equal(last->in[0].level_count, 2);
    /* 101x7 halved is 51x4, then 26x2, 13x1, 7x1: APIs, which round down, get there from 56x8. */
    aob_graph_texture_size(&graph.textures[0], 101, 7, &w, &h);
    assert_int_equal(w, 56);
    assert_int_equal(h, 8);
    assert_int_equal(aob_graph_texture_texels(&graph.textures[0], 101, 7), 56 * 8 + 28 * 4 + 14 * 2 + 7);
    assert_int_equal(aob_graph_texture_texels(&graph.textures[1], 101, 7), 101 * 7);
    aob_graph_dot(&graph, &dot);
    assert_contains(dot.data, "level_1 -> level_2 [label=\"pyramid 1\"]");
    assert_contains(dot.data, "level_3 -> last [label=\"pyramid 3\"]");
    aob_text_finish(&dot);
    /* Drawn together with level 1 of three: 51x4 pixels lie in 52x4, which can be halved once more. */
    assert_true(try_build(&graph, build_together, &error));
    aob_graph_texture_size(&graph.textures[1], 101, 7, &w, &h);
    assert_int_equal(w, 52);
    assert_int_equal(h, 4);
    assert_true(try_build(&graph, build_late_level, &error));
    assert_int_equal(graph.passes[2].in[0].level_count, 2);
    assert_true(graph.passes[1].live);
    assert_false(graph.passes[3].live);
}

/* Which level is read decides what a pass computes, where all else is the same and all passes live. */
static bool build_digest(struct aob_graph *g, const void *values)
{
    uint32_t level = (uint32_t)((const struct values *)values)->radius;
    aob_tex t = aob_texture(g, .name = "t", .levels = 3), raw = RAW(g);
    for (uint32_t l = 0; l < 3; l++) {
        char name[] = "level_0";
        name[6] = (char)('0' + l);
        aob_pass(g, .name = name, .shader = "one", .out = {{.name = "o", .tex = t, .level = l}});
    }
    return aob_pass(g, .name = "last", .shader = "two",
                    .in = {{.name = "all", .tex = t}, {.name = "i", .tex = t, .level = level}},
                    .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}

static void test_digest_follows_levels(void **state)
{
    (void)state;
    char keys[2][AOB_KEY_SIZE];
    for (int i = 0; i < 2; i++) {
        struct aob_pass_graph graph;
        struct aob_error error;
        const struct aob_technique technique = {.abi = AOB_ABI,
                                                .size = sizeof technique,
                                                .name = "trial",
                                                .shaders = shaders,
                                                .build = build_digest};
        assert_true(aob_graph_build(&graph, &technique, &(struct values){.radius = (float)i}, 0, &error));
        aob_graph_digest(&graph, NULL, keys[i]);
    }
    assert_string_not_equal(keys[0], keys[1]);
}

static void test_broken_levels_are_named(void **state)
{
    (void)state;
    const struct {
        bool (*build)(struct aob_graph *, const void *);
        const char *says;
    } cases[] = {{build_level_of_its_own, "reads level 1 of texture 't', which no earlier pass writes"},
                 {build_level_twice, "level 1 of texture 't' is already written"},
                 {build_level_beyond, "bind 'o' has level 2, its texture 't' has 2"},
                 {build_mixed_levels, "different sizes"},
                 {build_many_levels, "more than 12 levels"},
                 {build_table_with_levels, "no levels"},
                 {build_unwritten_first_level, "no pass writes texture 't' of the output visibility"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        struct aob_pass_graph graph;
        struct aob_error error;
        assert_false(try_build(&graph, cases[i].build, &error));
        assert_contains(error.text, cases[i].says);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_levels),
                                       cmocka_unit_test(test_digest_follows_levels),
                                       cmocka_unit_test(test_broken_levels_are_named)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
