/* A module that dies where it lays out its passes. */
#include <aobudget/technique.h>
#include <stdlib.h>

static const struct aob_shader shaders[] = {{NULL, NULL}};

static bool build(struct aob_graph *graph, const void *values)
{
    (void)graph;
    (void)values;
    abort();
}

AOB_TECHNIQUE(crash_build, .title = "Crashes in build()", .citation = "tests", .shaders = shaders,
              .build = build, .values_size = 4);
AOB_MODULE(&aob_technique_crash_build);
