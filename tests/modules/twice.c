/* A module that has one name twice: an address could mean either. */
#include <aobudget/technique.h>

static const struct aob_shader shaders[] = {{"open", "void main() { visibility = 1.0; }\n"}, {NULL, NULL}};

static bool build(struct aob_graph *graph, const void *values)
{
    (void)graph;
    (void)values;
    return false;
}

AOB_TECHNIQUE(twice, .title = "Twice", .citation = "tests", .shaders = shaders, .build = build,
              .values_size = 4);
AOB_MODULE(&aob_technique_twice, &aob_technique_twice);
