/* A module whose cases are laid out well, and which takes the worker down when it is unloaded. */
#include <aobudget/technique.h>
#include <signal.h>

static bool built;

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    built = true;
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R16F);
    return aob_pass(graph, .name = "open", .shader = "open",
                    .out = {{.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

static __attribute__((destructor)) void leave(void)
{
    if (built)
        raise(SIGKILL);
}

static const struct aob_shader shaders[] = {{"open", "void main() { visibility = 1.0; }\n"}, {NULL, NULL}};
AOB_TECHNIQUE(crash_exit, .title = "Ends the process when it is unloaded", .citation = "none", .revision = 1,
              .shaders = shaders, .build = build);
AOB_MODULE(&aob_technique_crash_exit);
