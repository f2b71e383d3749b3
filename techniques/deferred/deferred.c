/* The two passes of a deferred renderer that ambient occlusion stands between: what a frame's budget takes off first. It is
 * no technique for ambient occlusion, so it is built as a module only and listed nowhere. */
#include <aobudget/technique.h>
#include "shaders.h"

static bool build(struct aob_graph *graph, const void *values)
{
    (void)values;
    aob_tex normal = aob_texture(graph, .name = "normal", .format = AOB_RGBA16F);
    aob_tex lit = aob_texture(graph, .name = "lit", .format = AOB_RGBA8);
    aob_tex colour = aob_texture(graph, .name = "colour", .format = AOB_RGBA8);
    aob_tex visibility = aob_texture(graph, .name = "visibility", .format = AOB_R8);
    /* The scene's triangles as they are: the reach only has to be above 0. */
    aob_pass(graph, .name = "gbuffer", .draw = AOB_TRIANGLES, .vertex = "corners", .shader = "surface",
             .per_triangle = 3, .reach = 1e-6F, .reads = AOB_DEPTH,
             .out = {{.name = "normal", .tex = normal}, {.name = "lit", .tex = lit}});
    return aob_pass(graph, .name = "composite", .shader = "composite", .reads = AOB_DEPTH,
                    .in = {{.name = "lit", .tex = lit}},
                    .out = {{.name = "colour", .tex = colour}, {.name = "visibility", .tex = visibility}}) &&
           aob_output(graph, AOB_OUT_VISIBILITY, visibility);
}

AOB_TECHNIQUE(
    deferred, .title = "G-buffer and composite of a deferred renderer", .revision = 1,
    .shaders = aob_shaders_deferred, .build = build,
    .summary =
        "Draws the scene's triangles into a normal and a lit colour, behind a depth that is there already, "
        "and "
        "multiplies that colour with a visibility: what a frame takes before and after ambient occlusion.",
    .notes = "The image is 1 where the G-buffer has the surface that the depth shows. Every fragment "
             "compares itself "
             "with the depth in its text, so hidden ones cost a read: there is no early test. The vertices' "
             "work is in "
             "measured times only. The composite reads eight bytes a pixel and writes five; one with a "
             "visibility of "
             "its own reads five and writes four.",
    .citation = "no text: a frame of the usual kind", .values_size = sizeof(int32_t));
