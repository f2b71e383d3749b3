/* A technique whose cost is one loop, and whose image does not depend on how long it is. It is built several times, each
 * build with another number of trips or another image and all with one technique name, so that tests know by how much
 * one build is dearer than another:
 *   LOOP_TRIPS, LOOP_WORK  the loop turns LOOP_TRIPS * LOOP_WORK times in each pixel
 *   LOOP_SHIFT             hundredths by which the image is darker */
#include <aobudget/technique.h>

struct values {
    float growth;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, growth, .min = 3, .max = 3.999, .initial = 3.9,
              .doc = "Growth of the sequence that the loop computes; no image depends on it."),
};

/* The sequence stays below 1, which no compiler can know; each step needs the one before. */
static const struct aob_shader shaders[] = {
    {"loop",
     "void main() {\n"
     "    vec2 part = (vec2(aob_pixel) + 0.5) / vec2(aob_target_size);\n"
     "    float x = 0.25 + 0.5 * part.x * part.y;\n"
     "    for (int i = 0; i < TURNS; i++)\n"
     "        x = param.growth * x * (1.0 - x);\n"
     "    visibility = 0.25 + 0.5 * part.x + 0.125 * part.y - 0.01 * float(SHIFT) + (x > 1.0 ? 1.0 : 0.0);\n"
     "}\n"},
    {NULL, NULL}};

/* Every build has these two functions under the same global names, and each must find its own. */
int loop_turns(void);
int loop_shift(void);

__attribute__((noinline)) int loop_turns(void)
{
    return LOOP_TRIPS * LOOP_WORK;
}

__attribute__((noinline)) int loop_shift(void)
{
    return LOOP_SHIFT;
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R32F);
    return aob_pass(graph, .name = "loop", .shader = "loop",
                    .defines = {{"TURNS", loop_turns()}, {"SHIFT", loop_shift()}},
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(loop, .title = "A loop", .citation = "tests", .params = params, .param_count = 1,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);
AOB_MODULE(&aob_technique_loop);
