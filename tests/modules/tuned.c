/* A technique whose image is the truth of the scene `corner` at known values: radius is the target's, strength 2.5, lift 0.4. Its views
 * look from (x, 2, 4) to (x, 0.8, 0). What a wall within the radius r takes of the floor at a distance d is a segment of the unit disc,
 * (acos u - u sqrt(1 - u^2)) / pi with u = d / r, and the other way round. `lift` comes out of a table, `idle` changes nothing, and
 * `rough` above 1 makes the image worse by samples of its own. */
#include <aobudget/technique.h>

struct values {
    float radius, strength, lift, idle, seed, host;
    int32_t rough, mode;
};
static const char *const modes[] = {"plain", "black", NULL};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, radius, .unit = AOB_UNIT_LENGTH, .scale = AOB_LOG2, .min = 1e-3, .max = 1e3,
              .initial = 0.5, .doc = "Radius of the segment."),
    AOB_PARAM(struct values, strength, .min = 0, .max = 100, .initial = 1,
              .doc = "2.5 is right; more darkens."),
    AOB_PARAM(struct values, lift, .min = 0, .max = 2, .initial = 1, .doc = "0.4 is right."),
    AOB_PARAM(struct values, idle, .min = 0, .max = 1, .initial = 0.25, .doc = "Has no part in it."),
    AOB_PARAM(struct values, seed, .min = 0, .max = 1e6, .initial = 0, .doc = "Has none either."),
    AOB_PARAM(struct values, host, .stage = AOB_HOST, .min = 0.1, .max = 1, .initial = 1,
              .doc = "A factor of the strength, for its definition and table alone."),
    AOB_PARAM(struct values, rough, .stage = AOB_CONSTANT, .min = 1, .max = 8, .initial = 1,
              .doc = "1 is right; more shifts pixels."),
    AOB_PARAM(struct values, mode, .stage = AOB_CONSTANT, .choices = modes, .doc = "Black is 0 throughout."),
};
static const struct aob_shader shaders[] = {
    {"tuned", "void main() {\n"
              "    vec3 p = aob_surface(aob_pixel);\n"
              "    vec3 back = normalize(vec3(0.0, 1.2, 4.0)), up = vec3(0.0, back.z, -back.y);\n"
              "    vec3 world = vec3(0.0, 2.0, 4.0) + p.y * up + p.z * back;\n"
              "    bool wall = dot(aob_surface_normal(aob_pixel), up) < 0.5;\n"
              "    float u = clamp((wall ? world.y : world.z) / param.radius, 0.0, 1.0);\n"
              "    float segment = (acos(u) - u * sqrt(1.0 - u * u)) / 3.14159265;\n"
              "    vec2 table = aob_fetch_table(ivec2(0, 0)).xy;\n"
              "    float open = clamp(1.0 - segment * param.strength * table.y / 2.5, 0.0, 1.0);\n"
              "    visibility = clamp(open - 0.5 * (table.x - 0.4) * u * (1.0 - u), 0.0, 1.0);\n"
              "    if (ROUGH > 1 && (aob_pixel.x + aob_pixel.y) % ROUGH != 0) visibility = 1.0;\n"
              "    if (MODE == 1) visibility = 2.0 * visibility - 2.0;\n"
              "}\n"},
    {NULL, NULL}};

static void fill(const void *values, void *texels)
{
    const struct values *v = values;
    float *table = texels;
    table[0] = v->lift;
    table[1] = v->host;
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex table =
        aob_texture(graph, .name = "table", .format = AOB_RG32F, .width = 1, .height = 1, .fill = fill);
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R32F);
    return aob_pass(graph, .name = "tuned", .shader = "tuned", .reads = AOB_DEPTH | AOB_NORMAL,
                    .in = {{.name = "table", .tex = table}},
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(tuned, .title = "The truth at known values", .citation = "tests", .params = params,
              .param_count = 8, .values_size = sizeof(struct values), .shaders = shaders,
              .definition = {.weight = AOB_WEIGHT_COSINE}, .build = build);
AOB_MODULE(&aob_technique_tuned);
