/* A technique whose text has an instruction that no operations are known of: it can be traced, and cannot be modelled. */
#include <aobudget/technique.h>

struct values {
    float radius;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .min = 0.01, .max = 10, .initial = 0.5,
              .doc = "Nothing depends on it."),
};
static const struct aob_shader shaders[] = {
    {"bend", "void main() {\n"
             "    vec2 part = (vec2(aob_pixel) + 0.5) / vec2(aob_size);\n"
             "    float bent = refract(vec2(0.0, -1.0), normalize(part), 0.5).x;\n"
             "    visibility = aob_is_sky(aob_pixel) ? 1.0 : clamp(bent, 0.0, 1.0);\n"
             "}\n"},
    {NULL, NULL}};

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R32F);
    return aob_pass(graph, .name = "bend", .shader = "bend", .reads = AOB_DEPTH,
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(uncounted, .title = "A bent line", .citation = "tests", .params = params, .param_count = 1,
              .values_size = sizeof(struct values), .shaders = shaders,
              .definition = {.weight = AOB_WEIGHT_COSINE}, .build = build);
AOB_MODULE(&aob_technique_uncounted);
