#include "clearance.h"
#include <math.h>
#include "clearance/shaders.h"
#include "param.h"

static bool has_radius(const struct aob_technique *technique)
{
    const struct aob_param *param = aob_param_find(technique->params, technique->param_count, "radius");
    return param && param->type == AOB_FLOAT && param->stage == AOB_UNIFORM;
}

struct aob_clearance aob_clearance_of(const struct aob_technique *technique, const void *values)
{
    struct aob_clearance none = {0};
    return technique->clearance && has_radius(technique) ? technique->clearance(values) : none;
}

/* What a define holds of a share. */
static int millionths(float share)
{
    return share > 0 ? (int)floor(1e6 * fmin((double)share, 1)) : 0;
}

void aob_clearance_identify(struct aob_text *text)
{
    struct aob_text all = {0};
    char hash[AOB_KEY_SIZE];
    for (const struct aob_shader *s = aob_shaders_clearance; s->name; s++)
        aob_text_add(&all, "%s\n%s\n", s->name, s->text);
    aob_hash_text(all.data, hash);
    aob_text_add(text, "%s", hash);
    aob_text_finish(&all);
}

bool aob_clearance_lay(struct aob_pass_graph *graph, const void *values)
{
    const struct aob_clearance way = aob_clearance_of(graph->technique, values);
    const bool in_front = way.occluders == AOB_OCCLUDERS_IN_FRONT;
    struct aob_graph *g = &graph->interface;
    if (!(way.rise >= 0))
        return aob_fail(graph->error, "clearance() says a rise of %g, which must be 0 or more",
                        (double)way.rise);
    if (millionths(way.sine) == 0 || (way.rise > 0 && millionths(way.rise) == 0)) {
        graph->unclear = way.because;
        return true;
    }
    graph->shaders = aob_shaders_clearance;
    aob_tex plane = aob_texture(g, .name = "clearance_plane", .format = AOB_RGBA32F,
                                .divisor = AOB_CLEARANCE_TILE),
            ends = aob_texture(g, .name = "clearance_ends", .format = AOB_RGBA32F,
                               .divisor = AOB_CLEARANCE_TILE),
            group_plane = aob_texture(g, .name = "clearance_group_plane", .format = AOB_RGBA32F,
                                      .divisor = AOB_CLEARANCE_GROUP),
            group_ends = aob_texture(g, .name = "clearance_group_ends", .format = AOB_RGBA32F,
                                     .divisor = AOB_CLEARANCE_GROUP),
            clear = aob_texture(g, .name = "clearance", .format = AOB_R8, .divisor = AOB_CLEARANCE_TILE);
    aob_pass(g, .name = "clearance_tiles", .shader = "tiles", .reads = AOB_DEPTH | AOB_NORMAL,
             .defines = {{"IN_FRONT", in_front}},
             .out = {{.name = "plane", .tex = plane}, {.name = "ends", .tex = ends}});
    aob_pass(g, .name = "clearance_groups", .shader = "groups", .reads = AOB_DEPTH,
             .in = {{.name = "tile_plane", .tex = plane}, {.name = "tile_ends", .tex = ends}},
             .out = {{.name = "plane", .tex = group_plane}, {.name = "ends", .tex = group_ends}});
    aob_pass(g, .name = "clearance", .shader = "clear", .reads = AOB_DEPTH,
             .defines = {{"SINE_MILLIONTHS", millionths(way.sine)},
                         {"IN_FRONT", in_front},
                         {"RISE_MILLIONTHS", in_front ? millionths(way.rise) : 0},
                         {"LEAST_PIXELS", in_front ? way.least_pixels : 0},
                         {"INSIDE", in_front && way.inside}},
             .in = {{.name = "tile_plane", .tex = plane},
                    {.name = "tile_ends", .tex = ends},
                    {.name = "group_plane", .tex = group_plane},
                    {.name = "group_ends", .tex = group_ends}},
             .out = {{.name = "clear", .tex = clear}});
    graph->clear = (int)clear.id - 1;
    graph->shaders = graph->technique->shaders;
    return !*graph->error->text;
}
