/* A technique of PASSES passes, each of which reads the one before. On the null backend, whose clock gives each pass the
 * same time, one pass more is so much dearer to the last digit. It is built twice, with one technique name. */
#include <aobudget/technique.h>

static const struct aob_shader shaders[] = {
    {"first", "void main() { visibility = 0.5; }\n"},
    {"next", "void main() { visibility = aob_fetch_before(aob_pixel).x; }\n"},
    {NULL, NULL}};

/* Textures of a graph have names of their own. */
static const char *const names[] = {"a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k"};

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex before = aob_texture(graph, .name = names[0], .format = AOB_R8);
    bool ok =
        aob_pass(graph, .name = "first", .shader = "first", .out = {{.name = "visibility", .tex = before}});
    for (int i = 1; ok && i < PASSES; i++) {
        aob_tex next = aob_texture(graph, .name = names[i], .format = AOB_R8);
        ok = aob_pass(graph, .name = names[i], .shader = "next", .in = {{.name = "before", .tex = before}},
                      .out = {{.name = "visibility", .tex = next}});
        before = next;
    }
    return ok && aob_output(graph, AOB_OUT_VISIBILITY, before);
}

AOB_TECHNIQUE(passes, .title = "Passes", .citation = "tests", .shaders = shaders, .build = build,
              .values_size = sizeof(int32_t));
AOB_MODULE(&aob_technique_passes);
