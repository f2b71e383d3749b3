/* A module that ends its worker in build(), with a good code: no answer is missing but those that nobody gives. */
#include <aobudget/technique.h>
#include <stdlib.h>

static bool build(struct aob_graph *graph, const void *values)
{
    (void)graph;
    (void)values;
    exit(0);
}

static const struct aob_shader shaders[] = {{"open", "void main() { visibility = 1.0; }\n"}, {NULL, NULL}};
AOB_TECHNIQUE(leaver, .title = "Ends the process with a good code", .citation = "none", .revision = 1,
              .shaders = shaders, .build = build);
AOB_MODULE(&aob_technique_leaver);
