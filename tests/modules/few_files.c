/* A module that leaves its process no file to open, so that what the cache holds can be read no longer. */
#include <aobudget/technique.h>
#include <sys/resource.h>

static const struct aob_shader shaders[] = {{"one", "void main() { visibility = 0.5; }\n"}, {NULL, NULL}};

static float radius(const void *values)
{
    (void)values;
    return 1;
}

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    struct rlimit limit = {3, 3};
    setrlimit(RLIMIT_NOFILE, &limit);
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    return aob_pass(graph, .name = "one", .shader = "one",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(few_files, .title = "Leaves no file to open", .citation = "tests", .shaders = shaders,
              .definition = {.radius = radius}, .build = build);
AOB_MODULE(&aob_technique_few_files);
