/* A module that does what the variable MEDDLE says, a line for the shell, wherever it lays out its passes. */
#include <aobudget/technique.h>
#include <stdlib.h>

static const struct aob_shader shaders[] = {{"open", "void main() { visibility = 1.0; }\n"}, {NULL, NULL}};

static bool build(struct aob_graph *graph, const void *values)
{
    const char *line = getenv("MEDDLE");
    (void)values;
    if (line && system(line) != 0)
        return false;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    return aob_pass(graph, .name = "open", .shader = "open",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(meddle, .title = "Meddles", .citation = "tests", .shaders = shaders, .build = build,
              .values_size = 4);
AOB_MODULE(&aob_technique_meddle);
