/* For the tests: the nearest depth of each block of pixels, by a pyramid of five levels and a pass a level. */
#include <aobudget/technique.h>
#include "shaders.h"

struct values {
    float scale;
};

static const struct aob_param params[] = {
    AOB_PARAM(struct values, scale, .unit = AOB_UNIT_LENGTH, .min = 1, .max = 1e6, .initial = 100,
              .doc = "Depth that is written as 1."),
};

enum { LEVELS = 5 };

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex pyramid = aob_texture(graph, .name = "pyramid", .format = AOB_R32F, .levels = LEVELS),
            nearest = aob_texture(graph, .name = "nearest", .format = AOB_R32F);
    aob_pass(graph, .name = "level_0", .shader = "first", .reads = AOB_DEPTH,
             .out = {{.name = "depth", .tex = pyramid}});
    for (uint32_t l = 1; l < LEVELS; l++)
        aob_pass(graph, .name = (const char[]){'l', 'e', 'v', 'e', 'l', '_', (char)('0' + l), '\0'},
                 .shader = "coarser", .in = {{.name = "finer", .tex = pyramid, .level = l - 1}},
                 .out = {{.name = "depth", .tex = pyramid, .level = l}});
    return aob_pass(graph, .name = "show", .shader = "show", .reads = AOB_DEPTH, .depth = pyramid,
                    .defines = {{"LAST", LEVELS - 1}}, .out = {{.name = "visibility", .tex = nearest}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, nearest);
}

AOB_TECHNIQUE(pyramid, .title = "Pyramid of depths", .citation = "tests", .revision = 1, .params = params,
              .param_count = sizeof params / sizeof *params, .values_size = sizeof(struct values),
              .shaders = aob_shaders_pyramid, .build = build);
AOB_MODULE(&aob_technique_pyramid);
