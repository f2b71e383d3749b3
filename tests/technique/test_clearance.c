/* What thrift lays in front of a technique's passes. */
#include "technique/clearance.h"
#include <math.h>
#include <string.h>
#include "base/memory.h"
#include "trial.h"

static bool read_clearance(struct aob_graph *g, uint32_t reads, int inputs)
{
    aob_tex raw = RAW(g), done = aob_texture(g, .name = "done");
    struct aob_pass pass = {.name = "last", .shader = "two", .reads = reads, .out = OUT(done)};
    static const char *const names[] = {"a", "b", "c", "d", "e", "f", "g", "h"};
    for (int i = 0; i < inputs; i++)
        pass.in[i] = (struct aob_bind){.name = names[i], .tex = raw};
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(raw)) && aob_pass_add(g, &pass) &&
           aob_output(g, AOB_OUT_VISIBILITY, done);
}

static bool build_thrifty(struct aob_graph *g, const void *values)
{
    (void)values;
    return read_clearance(g, AOB_DEPTH | AOB_CLEARANCE, 1);
}

static bool build_spendthrift(struct aob_graph *g, const void *values)
{
    (void)values;
    return read_clearance(g, AOB_DEPTH, 1);
}

static bool build_crowded(struct aob_graph *g, const void *values)
{
    (void)values;
    return read_clearance(g, AOB_DEPTH | AOB_CLEARANCE, AOB_MAX_IN);
}

static struct aob_clearance told;
static struct aob_clearance clearance(const void *values)
{
    (void)values;
    return told;
}

static const struct aob_graph_pass *pass_of(const struct aob_pass_graph *graph, const char *name)
{
    for (int p = 0; p < graph->pass_count; p++)
        if (strcmp(graph->passes[p].name, name) == 0)
            return &graph->passes[p];
    return NULL;
}

static void test_wanted(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    told = (struct aob_clearance){.sine = 0.0123456f};
    assert_true(try_build_wanted(&graph, build_thrifty, AOB_WANT_THRIFT, &error));
    const struct aob_graph_pass *last = pass_of(&graph, "last");
    assert_int_equal(graph.pass_count, 5);
    assert_true(graph.clear >= 0 && pass_of(&graph, "clearance_tiles")->live &&
                pass_of(&graph, "clearance")->live);
    assert_true(aob_graph_leaves_out(&graph));
    assert_int_equal(last->in_count, 2);
    assert_string_equal(last->in[1].name, "clearance");
    assert_int_equal(last->in[1].texture, graph.clear);
    assert_int_equal(graph.textures[graph.clear].divisor, AOB_CLEARANCE_TILE);
    assert_int_equal(pass_of(&graph, "clearance")->defines[0].value, 12345);
}

/* Without the option nothing is laid, and the pass reads no more than its own. */
static void test_unwanted(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    assert_true(try_build_wanted(&graph, build_thrifty, 0, &error));
    assert_int_equal(graph.pass_count, 2);
    assert_int_equal(graph.clear, -1);
    assert_false(aob_graph_leaves_out(&graph));
    assert_int_equal(pass_of(&graph, "last")->in_count, 1);
}

/* Nobody reads it: its passes are laid and dead. */
static void test_unread(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    assert_true(try_build_wanted(&graph, build_spendthrift, AOB_WANT_THRIFT, &error));
    assert_false(pass_of(&graph, "clearance_tiles")->live);
    assert_false(pass_of(&graph, "clearance")->live);
    assert_false(aob_graph_leaves_out(&graph));
}

static void test_crowded(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    assert_true(try_build_wanted(&graph, build_crowded, 0, &error));
    assert_false(try_build_wanted(&graph, build_crowded, AOB_WANT_THRIFT, &error));
    assert_contains(error.text, "no input is left for the clearance");
}

/* A technique that can say nothing of its values leaves nothing out. */
static void test_no_sine(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    told = (struct aob_clearance){.because = "of the rain"};
    assert_true(try_build_wanted(&graph, build_thrifty, AOB_WANT_THRIFT, &error));
    assert_int_equal(graph.clear, -1);
    assert_string_equal(graph.unclear, "of the rain");
    told.sine = 0.01f;
}

/* A rise is a share: one below a millionth leaves nothing out, and what is none is refused. */
static void test_rises(void **state)
{
    static const struct {
        float rise;
        const char *says; /* NULL: it is taken */
        bool left_out;
    } rows[] = {{0, NULL, true},
                {1e-3f, NULL, true},
                {2, NULL, true},
                {5e-7f, NULL, false},
                {-1e-3f, "a rise of -0.001", false},
                {NAN, "which must be 0 or more", false}};
    (void)state;
    for (size_t i = 0; i < AOB_COUNT(rows); i++) {
        struct aob_pass_graph graph;
        struct aob_error error = {{0}};
        told = (struct aob_clearance){.occluders = AOB_OCCLUDERS_IN_FRONT, .sine = 1, .rise = rows[i].rise};
        assert_int_equal(try_build_wanted(&graph, build_thrifty, AOB_WANT_THRIFT, &error), !rows[i].says);
        if (rows[i].says)
            assert_contains(error.text, rows[i].says);
        else
            assert_int_equal(graph.clear >= 0, rows[i].left_out);
    }
    told = (struct aob_clearance){.sine = 0.01f};
}

static bool build_taken(struct aob_graph *g, const void *values)
{
    (void)values;
    aob_tex raw = RAW(g), done = aob_texture(g, .name = "done");
    return aob_pass(g, .name = "first", .shader = "one", .out = OUT(raw)) &&
           aob_pass(g, .name = "last", .shader = "two", .reads = AOB_DEPTH | AOB_CLEARANCE,
                    .in = {{.name = "clearance", .tex = raw}}, .out = OUT(done)) &&
           aob_output(g, AOB_OUT_VISIBILITY, done);
}

static void test_taken_name(void **state)
{
    struct aob_pass_graph graph;
    struct aob_error error;
    (void)state;
    assert_false(try_build_wanted(&graph, build_taken, AOB_WANT_THRIFT, &error));
    assert_contains(error.text, "the bind 'clearance' is the harness's");
}

/* A radius is what it needs: without one nothing is laid. */
static void test_no_radius(void **state)
{
    static const struct aob_param other[] = {
        AOB_PARAM(struct values, taps, .stage = AOB_CONSTANT, .min = 0, .max = 9, .doc = ".")};
    const struct aob_technique technique = {.abi = AOB_ABI,
                                            .size = sizeof technique,
                                            .name = "trial",
                                            .shaders = shaders,
                                            .params = other,
                                            .param_count = 1,
                                            .values_size = sizeof(struct values),
                                            .clearance = clearance,
                                            .build = build_thrifty};
    struct aob_pass_graph graph;
    struct aob_error error = {{0}};
    (void)state;
    assert_true(aob_graph_build(&graph, &technique, &(struct values){3, 1}, AOB_WANT_THRIFT, &error));
    assert_int_equal(graph.clear, -1);
    assert_int_equal(graph.pass_count, 2);
}

int main(void)
{
    trial_clearance = clearance;
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_wanted),     cmocka_unit_test(test_unwanted),  cmocka_unit_test(test_unread),
        cmocka_unit_test(test_crowded),    cmocka_unit_test(test_no_radius), cmocka_unit_test(test_no_sine),
        cmocka_unit_test(test_taken_name), cmocka_unit_test(test_rises),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
