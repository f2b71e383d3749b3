/* A technique whose image, bent normals and claim are known: the image rises from left to right and from top to bottom,
 * whatever the scene, and what it claims is a share of the visibility. So each part of its error has a closed form. */
#include <aobudget/technique.h>

struct values {
    float radius, claim;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .min = 0.01, .max = 10, .initial = 0.5,
              .doc = "Radius of what it claims."),
    AOB_PARAM(struct values, claim, .stage = AOB_HOST, .min = 0.1, .max = 1, .initial = 1,
              .doc = "Share of the visibility that it claims."),
};
static const struct aob_shader shaders[] = {{"known",
                                             "void main() {\n"
                                             "    vec2 part = (vec2(aob_pixel) + 0.5) / vec2(aob_size);\n"
                                             "    visibility = 0.25 + 0.5 * part.x + 0.125 * part.y;\n"
                                             "    bent = vec4(0.5 * part.x, -0.5 * part.y, 0.25, 0.0);\n"
                                             "}\n"},
                                            {NULL, NULL}};

static float map(const void *values, float visibility)
{
    return ((const struct values *)values)->claim * visibility;
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R32F);
    aob_tex bent = aob_texture(graph, .name = "bent", .format = AOB_RGBA32F);
    return aob_pass(graph, .name = "known", .shader = "known", .reads = AOB_DEPTH,
                    .out = {{.name = "visibility", .tex = visibility}, {.name = "bent", .tex = bent}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility) && aob_output(graph, AOB_OUT_BENT_NORMAL, bent);
}

AOB_TECHNIQUE(known, .title = "A known image", .citation = "tests", .params = params, .param_count = 2,
              .values_size = sizeof(struct values), .shaders = shaders,
              .definition = {.weight = AOB_WEIGHT_COSINE, .map = map}, .build = build);
AOB_MODULE(&aob_technique_known);
