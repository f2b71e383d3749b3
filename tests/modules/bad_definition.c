/* A module whose definition makes no sense: a radius that is not one, or a falloff that is not finite. */
#include <aobudget/technique.h>
#include <math.h>

struct values {
    int32_t fault;
};
static const char *const faults[] = {"radius", "falloff", NULL};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, fault, .choices = faults, .stage = AOB_HOST, .doc = "Which part is wrong."),
};
static const struct aob_shader shaders[] = {{"one", "void main() { visibility = 1.0; }\n"}, {NULL, NULL}};

static float radius(const void *values)
{
    return ((const struct values *)values)->fault == 0 ? -1.0f : 1.0f;
}

static float falloff(const void *values, float t)
{
    (void)values;
    return t > 0.5f ? NAN : 1.0f;
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    return aob_pass(graph, .name = "one", .shader = "one",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(bad_definition, .title = "Claims nonsense", .citation = "tests", .params = params,
              .param_count = 1, .values_size = sizeof(struct values), .shaders = shaders,
              .definition = {.radius = radius, .falloff = falloff}, .build = build);
AOB_MODULE(&aob_technique_bad_definition);
