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

static bool try_build(struct aob_pass_graph *graph, bool (*build)(struct aob_graph *, const void *),
                      struct aob_error *error)
{
    static struct aob_technique technique;
    technique = (struct aob_technique){.abi = AOB_ABI,
                                       .size = sizeof technique,
                                       .name = "trial",
                                       .shaders = shaders,
                                       .params = params,
                                       .param_count = 2,
                                       .values_size = sizeof(struct values),
                                       .build = build};
    *error = (struct aob_error){{0}};
    return aob_graph_build(graph, &technique, &(struct values){3, 1}, AOB_OUTPUTS_REQUIRED,
                           AOB_OUTPUTS_WANTED, error);
}
#endif
