/* A module that writes out of its own buffer. */
#include <aobudget/technique.h>
#include <stdlib.h>

static const struct aob_shader shaders[] = {{NULL, NULL}};

static bool build(struct aob_graph *graph, const void *values)
{
    (void)graph;
    (void)values;
    volatile size_t size = 16; /* the compiler must not see what is coming */
    volatile char *block = malloc(size);
    block[size] = 1;
    free((void *)block);
    return false;
}

AOB_TECHNIQUE(overflow, .title = "Writes out of its buffer", .citation = "tests", .shaders = shaders,
              .build = build, .values_size = 4);
AOB_MODULE(&aob_technique_overflow);
