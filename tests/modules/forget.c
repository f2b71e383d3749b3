/* A module whose worker takes the whole cache away when it ends, as a user may at any time. */
#include <aobudget/technique.h>
#include <stdlib.h>

static const struct aob_shader shaders[] = {{"one", "void main() { visibility = 0.5; }\n"}, {NULL, NULL}};

static float radius(const void *values)
{
    (void)values;
    return 1;
}

static void __attribute__((destructor)) forget(void)
{
    if (system("rm -rf \"$AOBUDGET_CACHE\"") != 0)
        abort();
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    return aob_pass(graph, .name = "one", .shader = "one",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(forget, .title = "Removes the cache", .citation = "tests", .shaders = shaders,
              .definition = {.radius = radius}, .build = build);
AOB_MODULE(&aob_technique_forget);
