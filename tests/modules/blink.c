/* A technique whose image changes from frame to frame by a known amount, up and down, and is no visibility in one of them. */
#include <aobudget/technique.h>

struct values {
    float amplitude;
    int bad;
};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, amplitude, .min = 0, .max = 0.5, .initial = 0.125,
              .doc = "By which odd frames are above one half, and even ones below."),
    AOB_PARAM(struct values, bad, .min = -1, .max = 127, .initial = -1,
              .doc = "Number of the frame that holds 2; -1: none does."),
};
static const struct aob_shader shaders[] = {
    {"blink", "void main() {\n"
              "    visibility = 0.5 + (aob_frame % 2 == 1 ? param.amplitude : -param.amplitude);\n"
              "    if (aob_frame == param.bad)\n"
              "        visibility = 2.0;\n"
              "}\n"},
    {NULL, NULL}};

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R32F);
    return aob_pass(graph, .name = "blink", .shader = "blink", .reads = AOB_DEPTH,
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(blink, .title = "A blinking image", .citation = "tests", .params = params, .param_count = 2,
              .values_size = sizeof(struct values), .shaders = shaders, .build = build);
AOB_MODULE(&aob_technique_blink);
