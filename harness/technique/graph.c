#include "graph.h"
#include <math.h>
#include <string.h>

enum { MAX_TABLE = 8192 };

static struct aob_pass_graph *own(const struct aob_graph *graph)
{
    return (struct aob_pass_graph *)(uintptr_t)graph;
}

static bool copy_name(struct aob_pass_graph *graph, const char *what, const char *name,
                      char into[AOB_NAME_SIZE])
{
    if (!name || !*name)
        return aob_fail(graph->error, "a %s has no name", what);
    if (strlen(name) >= AOB_NAME_SIZE)
        return aob_fail(graph->error, "%s '%.60s': the name is longer than %d characters", what, name,
                        AOB_NAME_SIZE - 1);
    for (const char *c = name; *c; c++)
        if (!((*c >= 'a' && *c <= 'z') || (*c >= '0' && *c <= '9' && c > name) || *c == '_'))
            return aob_fail(graph->error, "%s '%s': a name is lower-case letters, digits and _", what, name);
    strcpy(into, name);
    return true;
}

static bool graph_wants(const struct aob_graph *graph, enum aob_output which)
{
    return which < AOB_OUTPUT_COUNT && own(graph)->wanted >> which & 1;
}

static aob_tex graph_texture(struct aob_graph *interface, const struct aob_tex_desc *desc)
{
    struct aob_pass_graph *graph = own(interface);
    struct aob_graph_texture texture = {.format = desc->format,
                                        .divisor = desc->divisor ? (int)desc->divisor : 1,
                                        .width = (int)desc->width,
                                        .height = (int)desc->height,
                                        .fill = desc->fill};
    if (!copy_name(graph, "texture", desc->name, texture.name))
        return (aob_tex){0};
    if (graph->texture_count == AOB_MAX_TEXTURE)
        return aob_fail(graph->error, "texture '%s': more than %d textures", desc->name, AOB_MAX_TEXTURE),
               (aob_tex){0};
    if ((unsigned)desc->format >= AOB_FORMAT_COUNT || desc->divisor > 64)
        return aob_fail(graph->error, "texture '%s': unknown format or a divisor over 64", desc->name),
               (aob_tex){0};
    if (desc->fill ? desc->divisor || !desc->width || !desc->height || desc->width > MAX_TABLE ||
                         desc->height > MAX_TABLE
                   : desc->width || desc->height)
        return aob_fail(
                   graph->error,
                   "texture '%s': a table has fill, width and height (1..%d) and no divisor; a target none",
                   desc->name, MAX_TABLE),
               (aob_tex){0};
    for (int i = 0; i < graph->texture_count; i++)
        if (strcmp(graph->textures[i].name, texture.name) == 0)
            return aob_fail(graph->error, "two textures are named '%s'", desc->name), (aob_tex){0};
    graph->textures[graph->texture_count++] = texture;
    return (aob_tex){(uint32_t)graph->texture_count};
}

static bool copy_binds(struct aob_pass_graph *graph, const struct aob_pass *pass,
                       const struct aob_bind *binds, int max, struct aob_graph_bind *into, int *count)
{
    for (*count = 0; *count < max && binds[*count].name; (*count)++) {
        const struct aob_bind *bind = &binds[*count];
        struct aob_graph_bind *copy = &into[*count];
        if (!copy_name(graph, "bind", bind->name, copy->name))
            return false;
        if (bind->tex.id == 0 || bind->tex.id > (uint32_t)graph->texture_count)
            return aob_fail(graph->error, "pass '%s': bind '%s' has no texture of this graph", pass->name,
                            bind->name);
        if (bind->filter != AOB_NEAREST && bind->filter != AOB_BILINEAR)
            return aob_fail(graph->error, "pass '%s': bind '%s' has an unknown filter", pass->name,
                            bind->name);
        copy->texture = (int)bind->tex.id - 1;
        copy->filter = bind->filter;
        for (int i = 0; i < *count; i++)
            if (strcmp(into[i].name, copy->name) == 0)
                return aob_fail(graph->error, "pass '%s': two binds are named '%s'", pass->name, bind->name);
    }
    return true;
}

static bool has_shader(const struct aob_technique *technique, const char *name)
{
    for (const struct aob_shader *s = technique->shaders; s && s->name; s++)
        if (strcmp(s->name, name) == 0)
            return true;
    return false;
}

static bool copy_draw(struct aob_pass_graph *graph, const struct aob_pass *desc, struct aob_graph_pass *pass)
{
    bool triangles = desc->draw == AOB_TRIANGLES;
    if ((unsigned)desc->draw > AOB_TRIANGLES)
        return aob_fail(graph->error, "pass '%s': unknown draw", pass->name);
    if (!triangles && (desc->vertex || desc->per_triangle || desc->reach != 0))
        return aob_fail(graph->error, "pass '%s': vertex, per_triangle and reach are of AOB_TRIANGLES only",
                        pass->name);
    if (!triangles)
        return true;
    if (!copy_name(graph, "vertex shader", desc->vertex, pass->vertex))
        return false;
    if (!has_shader(graph->technique, pass->vertex))
        return aob_fail(graph->error, "pass '%s': the module has no shader text '%s'", pass->name,
                        pass->vertex);
    if (desc->per_triangle < 3 || desc->per_triangle > AOB_MAX_VERTICES || desc->per_triangle % 3)
        return aob_fail(graph->error, "pass '%s': per_triangle is %u: must be 3, 6, ... %d", pass->name,
                        desc->per_triangle, AOB_MAX_VERTICES);
    if (!(desc->reach > 0) || isinf(desc->reach))
        return aob_fail(graph->error, "pass '%s': reach is %g: must be above 0 and finite", pass->name,
                        (double)desc->reach);
    pass->draw = AOB_TRIANGLES;
    pass->per_triangle = desc->per_triangle;
    pass->reach = desc->reach;
    return true;
}

static bool graph_pass(struct aob_graph *interface, const struct aob_pass *desc)
{
    struct aob_pass_graph *graph = own(interface);
    if (graph->pass_count == AOB_MAX_PASS)
        return aob_fail(graph->error, "more than %d passes", AOB_MAX_PASS);
    struct aob_graph_pass *pass = &graph->passes[graph->pass_count];
    *pass = (struct aob_graph_pass){
        .reads = desc->reads, .border = desc->border, .depth = (int)desc->depth.id - 1};
    if (!copy_name(graph, "pass", desc->name, pass->name) ||
        !copy_name(graph, "shader", desc->shader, pass->shader))
        return false;
    for (int i = 0; i < graph->pass_count; i++)
        if (strcmp(graph->passes[i].name, pass->name) == 0)
            return aob_fail(graph->error, "two passes are named '%s'", pass->name);
    if (!has_shader(graph->technique, pass->shader))
        return aob_fail(graph->error, "pass '%s': the module has no shader text '%s'", pass->name,
                        pass->shader);
    if (desc->defines && strlen(desc->defines) >= sizeof pass->defines)
        return aob_fail(graph->error, "pass '%s': defines are longer than %zu characters", pass->name,
                        sizeof pass->defines - 1);
    strcpy(pass->defines, desc->defines ? desc->defines : "");
    if ((desc->reads & ~(uint32_t)(AOB_DEPTH | AOB_NORMAL)) || (unsigned)desc->border > AOB_FAR)
        return aob_fail(graph->error, "pass '%s': unknown bits in reads or border", pass->name);
    if (desc->depth.id > (uint32_t)graph->texture_count)
        return aob_fail(graph->error, "pass '%s': its depth is no texture of this graph", pass->name);
    if (!copy_draw(graph, desc, pass) ||
        !copy_binds(graph, desc, desc->in, AOB_MAX_IN, pass->in, &pass->in_count) ||
        !copy_binds(graph, desc, desc->out, AOB_MAX_OUT, pass->out, &pass->out_count))
        return false;
    graph->pass_count++;
    return true;
}

static bool graph_output(struct aob_graph *interface, enum aob_output which, aob_tex tex)
{
    struct aob_pass_graph *graph = own(interface);
    if (which >= AOB_OUTPUT_COUNT || tex.id == 0 || tex.id > (uint32_t)graph->texture_count)
        return aob_fail(graph->error, "an output is unknown or has no texture of this graph");
    if (graph->textures[tex.id - 1].divisor != 1 || graph->textures[tex.id - 1].fill)
        return aob_fail(graph->error,
                        "output texture '%s' is not full size: upsampling is part of the technique",
                        graph->textures[tex.id - 1].name);
    graph->outputs[which] = (int)tex.id - 1;
    return true;
}

static const struct aob_graph_ops graph_ops = {graph_wants, graph_texture, graph_pass, graph_output};

static int writer_of(const struct aob_pass_graph *graph, int texture, int before)
{
    for (int p = 0; p < before; p++)
        for (int o = 0; o < graph->passes[p].out_count; o++)
            if (graph->passes[p].out[o].texture == texture)
                return p;
    return -1;
}

static bool is_written(const struct aob_pass_graph *graph, int texture, int before)
{
    return graph->textures[texture].fill || writer_of(graph, texture, before) >= 0;
}

static bool judge_depth(const struct aob_pass_graph *graph, int index)
{
    const struct aob_graph_pass *pass = &graph->passes[index];
    if (pass->depth < 0)
        return true;
    const struct aob_graph_texture *depth = &graph->textures[pass->depth];
    if (!(pass->reads & AOB_DEPTH))
        return aob_fail(graph->error, "pass '%s' has a depth and does not read it", pass->name);
    if ((depth->format != AOB_R16F && depth->format != AOB_R32F) || depth->fill)
        return aob_fail(graph->error, "pass '%s': its depth '%s' is not a target of r16f or r32f", pass->name,
                        depth->name);
    return writer_of(graph, pass->depth, index) >= 0 ||
           aob_fail(graph->error, "pass '%s' reads depth '%s', which no earlier pass writes", pass->name,
                    depth->name);
}

static bool judge_pass(const struct aob_pass_graph *graph, int index)
{
    const struct aob_graph_pass *pass = &graph->passes[index];
    if (pass->out_count == 0)
        return aob_fail(graph->error, "pass '%s' writes nothing", pass->name);
    for (int o = 0; o < pass->out_count; o++) {
        const struct aob_graph_texture *texture = &graph->textures[pass->out[o].texture];
        if (texture->fill)
            return aob_fail(graph->error, "pass '%s' writes the table '%s'", pass->name, texture->name);
        if (texture->divisor != graph->textures[pass->out[0].texture].divisor)
            return aob_fail(graph->error, "pass '%s': its outputs have different sizes", pass->name);
        if (writer_of(graph, pass->out[o].texture, index) >= 0)
            return aob_fail(graph->error, "pass '%s': texture '%s' is already written by an earlier pass",
                            pass->name, texture->name);
    }
    for (int i = 0; i < pass->in_count; i++)
        if (!is_written(graph, pass->in[i].texture, index))
            return aob_fail(graph->error, "pass '%s' reads texture '%s', which no earlier pass writes",
                            pass->name, graph->textures[pass->in[i].texture].name);
    return judge_depth(graph, index);
}

static void mark_live(struct aob_pass_graph *graph, int texture)
{
    int writer = writer_of(graph, texture, graph->pass_count);
    graph->textures[texture].used = true;
    if (writer < 0 || graph->passes[writer].live)
        return;
    struct aob_graph_pass *pass = &graph->passes[writer];
    pass->live = true;
    for (int o = 0; o < pass->out_count; o++)
        graph->textures[pass->out[o].texture].used = true;
    for (int i = 0; i < pass->in_count; i++)
        mark_live(graph, pass->in[i].texture);
    if (pass->depth >= 0)
        mark_live(graph, pass->depth);
}

static bool judge_outputs(struct aob_pass_graph *graph)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++) {
        if (!(graph->wanted >> which & 1))
            continue;
        if (graph->outputs[which] < 0)
            return aob_fail(graph->error, "the graph gives no visibility output");
        if (writer_of(graph, graph->outputs[which], graph->pass_count) < 0)
            return aob_fail(graph->error, "no pass writes the output texture '%s'",
                            graph->textures[graph->outputs[which]].name);
        mark_live(graph, graph->outputs[which]);
    }
    return true;
}

bool aob_graph_build(struct aob_pass_graph *graph, const struct aob_technique *technique, const void *values,
                     uint32_t wanted, struct aob_error *error)
{
    struct aob_error cause = {{0}};
    const char *why = NULL;
    *graph = (struct aob_pass_graph){
        .interface = {&graph_ops}, .technique = technique, .wanted = wanted, .error = &cause};
    memset(graph->outputs, 0xff, sizeof graph->outputs);
    if (technique->check && !technique->check(values, &why))
        return aob_fail(error, "%s: %s", technique->name, why ? why : "these values do not go together");
    bool ok = technique->build(&graph->interface, values);
    if (!ok && !*cause.text)
        aob_fail(&cause, "build() failed without a reason");
    if (ok && *cause.text) /* a failed call that build() did not look at */
        ok = false;
    for (int p = 0; ok && p < graph->pass_count; p++)
        ok = judge_pass(graph, p);
    ok = ok && judge_outputs(graph);
    graph->error = NULL;
    return ok || aob_fail(error, "%s: %s", technique->name, cause.text);
}
