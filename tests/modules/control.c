/* A module whose texts hold control characters, and whose shader, which has one in its name, does not compile. */
#include <aobudget/technique.h>

struct values {
    int32_t mode;
};
static const char *const modes[] = {"a\033[2J", "b\302\233m", NULL};
static const struct aob_param params[] = {
    AOB_PARAM(struct values, mode, .choices = modes, .stage = AOB_HOST,
              .doc = "One line\nand\033]0;title\007 more."),
};
static const struct aob_shader shaders[] = {{"dim\033[2J", "#error \033[2J is a bad token\n"}, {NULL, NULL}};

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    return aob_pass(graph, .name = "broken", .shader = "dim\033[2J",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(control, .title = "Clears\033[2J the screen", .citation = "tests\r", .summary = "\177",
              .notes = "\302\205", .params = params, .param_count = 1, .values_size = sizeof(struct values),
              .shaders = shaders, .build = build);
AOB_MODULE(&aob_technique_control);
