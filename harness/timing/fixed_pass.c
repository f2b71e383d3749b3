#include "fixed_pass.h"
#include "fixed_pass/shaders.h"

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R16F);
    return aob_pass(graph, .name = "fixed", .shader = "fixed_pass", .reads = AOB_DEPTH,
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(fixed_pass, .title = "Fixed reference pass", .citation = "aobudget", .revision = 1,
              .shaders = aob_shaders_fixed_pass, .build = build, .values_size = sizeof(int32_t));
