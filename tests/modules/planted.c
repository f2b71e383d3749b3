/* Techniques with a fault that few frames show, for the fuzzer. One gives NaN where a surface has sky to its left, if one
 * parameter is at its upper bound and another at its lower one. The other takes its process away if both are. */
#include <aobudget/technique.h>
#include <stdlib.h>

struct values {
    float radius, strength, bias, width;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-3, .max = 1e3,
              .initial = 0.5, .doc = "Has no part in it."),
    AOB_PARAM(struct values, strength, .min = 0, .max = 4, .initial = 1,
              .doc = "At 4 it has a part in the fault."),
    AOB_PARAM(struct values, bias, .min = 0.25, .max = 1, .initial = 0.5, .doc = "So has this one at 0.25."),
    AOB_PARAM(struct values, width, .min = 0, .max = 8, .initial = 3, .doc = "Has no part in it either."),
};
static const struct aob_shader shaders[] = {
    {"planted",
     "void main() {\n"
     "    bool rare = param.strength == 4.0 && param.bias == 0.25 && !aob_surface_is_sky(aob_pixel);\n"
     "    bool beside = aob_pixel.x > 0 && aob_surface_is_sky(aob_pixel - ivec2(1, 0));\n"
     "    float zero = param.width < 0.0 ? 1.0 : 0.0;\n"
     "    visibility = rare && beside ? zero / zero : 1.0;\n"
     "}\n"},
    {NULL, NULL}};

static bool lay(struct aob_graph *graph)
{
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R32F);
    return aob_pass(graph, .name = "only", .shader = "planted", .reads = AOB_DEPTH,
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    return lay(graph);
}

static bool build_or_die(struct aob_graph *graph, const void *values)
{
    const struct values *v = values;
    if (v->strength == 4 && v->bias == 0.25f)
        abort();
    return lay(graph);
}

AOB_TECHNIQUE(planted, .title = "A rare NaN", .citation = "tests", .params = params, .param_count = 4,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);
AOB_TECHNIQUE(planted_death, .title = "A rare death", .citation = "tests", .params = params, .param_count = 4,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build_or_die);
AOB_MODULE(&aob_technique_planted, &aob_technique_planted_death);
