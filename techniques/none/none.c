/* The cost floor: reads the depth, writes 1. */
#include <aobudget/technique.h>
#include "shaders.h"

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    return aob_pass(graph, .name = "floor", .shader = "none", .reads = AOB_DEPTH,
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

static const struct aob_by_definition by_definition[] = {
    {"drawn_at_all", "No ambient occlusion is what it is for: it writes 1 everywhere."}, {0}};

AOB_TECHNIQUE(none, .title = "No ambient occlusion", .revision = 1, .shaders = aob_shaders_none,
              .build = build, .by_definition = by_definition,
              .summary = "Writes 1 everywhere after one depth read: what no technique can be cheaper than.",
              .citation = "the row 'No AO' of Bavoil and Sainz, ShaderX7 (2009), table 6.2.1",
              .values_size = sizeof(int32_t));
