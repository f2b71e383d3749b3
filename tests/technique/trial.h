/* A technique made for the purpose of one build(), for the tests of the graph. */
#ifndef AOB_TESTS_TRIAL_H
#define AOB_TESTS_TRIAL_H
#include "check.h"
#include "technique/graph.h"

static const struct aob_shader shaders[] = {{"one", "text one"}, {"two", "text two"}, {NULL, NULL}};

struct values {
    int32_t taps;
    float radius;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, taps, .stage = AOB_CONSTANT, .min = 0, .max = 9, .doc = "."),
    AOB_PARAM(struct values, radius, .min = 0, .max = 9, .doc = "."),
};

#define RAW(g) aob_texture(g, .name = "raw", .format = AOB_R16F)
#define OUT(t)                                                                                               \
    {                                                                                                        \
        {                                                                                                    \
            .name = "o", .tex = t                                                                            \
        }                                                                                                    \
    }

static inline bool build_chain(struct aob_graph *g, const void *values)
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

static inline void fill(const void *values, void *texels)
{
    (void)values;
    (void)texels;
}

static inline bool depth_pass(struct aob_graph *g, aob_tex depth, uint32_t reads)
{
    return aob_pass(g, .name = "last", .shader = "two", .reads = reads, .depth = depth, .out = OUT(RAW(g)));
}

static inline bool triangles_pass(struct aob_graph *g, const char *vertex, uint32_t count, float reach)
{
    aob_tex raw = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one", .draw = AOB_TRIANGLES, .vertex = vertex,
                    .per_triangle = count, .reach = reach, .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}

static inline bool give(struct aob_graph *g, enum aob_output which, enum aob_format format)
{
    aob_tex raw = RAW(g), more = aob_texture(g, .name = "more", .format = format);
    aob_pass(g, .name = "first", .shader = "one", .out = OUT(raw));
    aob_pass(g, .name = "second", .shader = "two", .out = OUT(more));
    return aob_output(g, AOB_OUT_VISIBILITY, raw) && aob_output(g, which, more);
}

static inline bool defines_pass(struct aob_graph *g, const char *name)
{
    aob_tex raw = RAW(g);
    return aob_pass(g, .name = "first", .shader = "one", .defines = {{"A", -2}, {name, 7}},
                    .out = OUT(raw)) &&
           aob_output(g, AOB_OUT_VISIBILITY, raw);
}

static struct aob_clearance (*trial_clearance)(
    const void *); /* of the technique; NULL: it leaves nothing out */

static bool try_build_wanted(struct aob_pass_graph *graph, bool (*build)(struct aob_graph *, const void *),
                             uint32_t wanted, struct aob_error *error)
{
    static struct aob_technique technique;
    technique = (struct aob_technique){.abi = AOB_ABI,
                                       .size = sizeof technique,
                                       .name = "trial",
                                       .shaders = shaders,
                                       .params = params,
                                       .param_count = 2,
                                       .values_size = sizeof(struct values),
                                       .clearance = trial_clearance,
                                       .build = build};
    *error = (struct aob_error){{0}};
    return aob_graph_build(graph, &technique, &(struct values){3, 1}, wanted, error);
}

static inline bool try_build(struct aob_pass_graph *graph, bool (*build)(struct aob_graph *, const void *),
                             struct aob_error *error)
{
    return try_build_wanted(graph, build, 1u << AOB_OUT_BENT_NORMAL, error);
}
#endif
