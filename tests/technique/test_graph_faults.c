/* Graphs that are wrong, each in one thing: each is named in a line. */
#include "base/memory.h"
#include "trial.h"

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

static bool build_byte_irradiance(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_IRRADIANCE, AOB_RGBA8);
}

static bool build_half_bounces(struct aob_graph *g, const void *values)
{
    (void)values;
    return give(g, AOB_OUT_VISIBILITY_RGB, AOB_R16F);
}

static bool build_unknown_read(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .reads = AOB_DEPTH | 1u << 6, .out = OUT(RAW(g)));
}

static bool build_unwritten_bent_normal(struct aob_graph *g, const void *values)
{
    aob_tex more = aob_texture(g, .name = "more", .format = AOB_RGBA32F);
    return build_chain(g, values) && aob_output(g, AOB_OUT_BENT_NORMAL, more);
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
    return aob_pass(g, .name = "first", .shader = "one", .reads = AOB_VELOCITY, .out = OUT(RAW(g)));
}

static bool build_previous_of_nothing(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_previous(g, (aob_tex){7}).id;
}

static bool build_previous_table(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_previous(g, aob_texture(g, .name = "table", .width = 2, .height = 2, .fill = fill)).id;
}

static bool build_written_previous(struct aob_graph *g, const void *values)
{
    (void)values;
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(aob_previous(g, RAW(g))));
}

static bool build_unwritten_previous(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g), more = aob_texture(g, .name = "more");
    aob_pass(g, .name = "first", .shader = "one", .in = {{.name = "i", .tex = aob_previous(g, more)}},
             .out = OUT(raw));
    return aob_output(g, AOB_OUT_VISIBILITY, raw);
}

static bool build_previous_output(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g);
    aob_pass(g, .name = "first", .shader = "one", .out = OUT(raw));
    return aob_output(g, AOB_OUT_VISIBILITY, aob_previous(g, raw));
}

static bool build_previous_depth(struct aob_graph *g, const void *values)
{
    (void)values;
    return depth_pass(g, aob_previous(g, aob_texture(g, .name = "low", .format = AOB_R32F)), AOB_DEPTH);
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

static const struct {
    bool (*build)(struct aob_graph *, const void *);
    const char *says;
} cases[] = {
    {build_loop, "no earlier pass writes"},
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
    {build_byte_irradiance, "irradiance: texture 'more' is rgba8: must be rgba16f or rgba32f"},
    {build_half_bounces, "visibility_rgb: texture 'more' is r16f: must be rgba8, rgba16f or rgba32f"},
    {build_unknown_read, "unknown bits in reads"},
    {build_unwritten_bent_normal, "no pass writes texture 'more' of the output bent_normal"},
    {build_velocity, "reads the velocity, which takes the depth as well"},
    {build_two_faults, "two textures are named 'twin'"},
    {build_previous_of_nothing, "previous of what is no texture of this graph"},
    {build_previous_table, "a table has no previous texture: 'table'"},
    {build_written_previous, "output 'o' is a previous texture, which can only be read"},
    {build_unwritten_previous, "reads the previous texture 'more', which no pass writes"},
    {build_previous_output, "an output is unknown or has no texture of this graph"},
    {build_previous_depth, "its depth is no texture of this graph"},
    {build_lower_define, "define 'wide'"},
    {build_prelude_define, "define 'AOB_DIVISOR'"}};

static void test_broken_graphs_are_named(void **state)
{
    (void)state;
    struct aob_pass_graph graph;
    struct aob_error error;
    for (size_t i = 0; i < AOB_COUNT(cases); i++) {
        assert_false(try_build(&graph, cases[i].build, &error));
        assert_contains(error.text, cases[i].says);
        assert_contains(error.text, "trial: ");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_broken_graphs_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
