/* For the tests: visibility and a bent normal from one pass, both upsampled by the same shared text. */
#include <aobudget/steps.h>
#include "shaders.h"

struct values {
    float radius;
    int32_t taps, divisor;
};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .min = 1e-3, .max = 10, .initial = 0.5,
              .doc = "Radius of the truth that it is compared with."),
    AOB_PARAM(struct values, taps, .unit = AOB_UNIT_COUNT, .stage = AOB_CONSTANT, .min = 0, .max = 9,
              .rule = AOB_ODD, .initial = 3, .doc = "Normals in a row that are averaged; more smooths more."),
    AOB_PARAM_DIVISOR(struct values, divisor),
};

static bool build(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    uint32_t divisor = (uint32_t)v->divisor;
    bool wanted = aob_wants(graph, AOB_OUT_BENT_NORMAL);
    aob_tex bent = {0},
            visibility = aob_texture(graph, .name = "visibility", .format = AOB_R16F, .divisor = divisor);
    if (wanted)
        bent = aob_texture(graph, .name = "bent", .format = AOB_RGBA16F, .divisor = divisor);
    aob_pass(
        graph, .name = "cone", .shader = "cone", .reads = AOB_DEPTH | AOB_NORMAL,
        .defines = {{"WANTED", wanted}},
        .out = {{.name = "visibility", .tex = visibility}, {.name = wanted ? "bent" : NULL, .tex = bent}});
    if (wanted)
        bent = aob_step_upsample(graph, .tex = bent, .divisor = v->divisor, .output = AOB_OUT_BENT_NORMAL);
    return (!wanted || aob_output(graph, AOB_OUT_BENT_NORMAL, bent)) &&
           aob_output(graph, AOB_OUT_VISIBILITY,
                      aob_step_upsample(graph, .tex = visibility, .divisor = v->divisor));
}

AOB_TECHNIQUE(two_outputs, .title = "Two outputs", .citation = "tests", .revision = 1, .params = params,
              .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
              .shaders = aob_shaders_two_outputs, .build = build);
AOB_MODULE(&aob_technique_two_outputs);
