#include "graph.h"
#include <math.h>
#include <string.h>
#include "clearance.h"
#include "composite.h"
#include "graph_judge.h"

enum { MAX_TABLE = 8192 };
static const uint32_t PREVIOUS = 1u << 31; /* in the id of a texture that the frame before left */

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
    /* Whether its outputs are composed is hidden from a module: it has to draw them alike. */
    return (unsigned)which < AOB_OUT_LIT && own(graph)->wanted >> which & 1;
}

static bool judge_texture(const struct aob_pass_graph *graph, const struct aob_tex_desc *desc)
{
    if (graph->texture_count == AOB_MAX_TEXTURE)
        return aob_fail(graph->error, "texture '%s': more than %d textures", desc->name, AOB_MAX_TEXTURE);
    if ((unsigned)desc->format >= AOB_FORMAT_COUNT || desc->divisor > 64 || desc->levels > AOB_MAX_LEVEL)
        return aob_fail(graph->error,
                        "texture '%s': unknown format, a divisor over 64 or more than %d levels", desc->name,
                        AOB_MAX_LEVEL);
    if (desc->fill ? desc->divisor || desc->levels || !desc->width || !desc->height ||
                         desc->width > MAX_TABLE || desc->height > MAX_TABLE
                   : desc->width || desc->height)
        return aob_fail(
            graph->error,
            "texture '%s': a table has fill, width and height (1..%d), no divisor and no levels; a "
            "target none of the three",
            desc->name, MAX_TABLE);
    for (int i = 0; i < graph->texture_count; i++)
        if (strcmp(graph->textures[i].name, desc->name) == 0)
            return aob_fail(graph->error, "two textures are named '%s'", desc->name);
    return true;
}

/* Once a step has failed, what build() goes on to lay is not looked at: the first reason is the one to mend. */
static bool has_failed(const struct aob_graph *interface)
{
    return *own(interface)->error->text;
}

static aob_tex graph_texture(struct aob_graph *interface, const struct aob_tex_desc *desc)
{
    struct aob_pass_graph *graph = own(interface);
    struct aob_graph_texture texture = {.format = desc->format,
                                        .divisor = desc->divisor ? (int)desc->divisor : 1,
                                        .levels = desc->levels ? (int)desc->levels : 1,
                                        .align = desc->levels ? (int)desc->levels - 1 : 0,
                                        .width = (int)desc->width,
                                        .height = (int)desc->height,
                                        .fill = desc->fill};
    if (has_failed(interface) || !copy_name(graph, "texture", desc->name, texture.name) ||
        !judge_texture(graph, desc))
        return (aob_tex){0};
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
        copy->previous = bind->tex.id & PREVIOUS;
        uint32_t id = bind->tex.id & ~PREVIOUS;
        if (id == 0 || id > (uint32_t)graph->texture_count)
            return aob_fail(graph->error, "pass '%s': bind '%s' has no texture of this graph", pass->name,
                            bind->name);
        if (copy->previous && binds == pass->out)
            return aob_fail(graph->error,
                            "pass '%s': output '%s' is a previous texture, which can only be read",
                            pass->name, bind->name);
        if (bind->filter != AOB_NEAREST && bind->filter != AOB_BILINEAR)
            return aob_fail(graph->error, "pass '%s': bind '%s' has an unknown filter", pass->name,
                            bind->name);
        copy->texture = (int)id - 1;
        copy->filter = bind->filter;
        if (bind->level >= (uint32_t)graph->textures[copy->texture].levels)
            return aob_fail(graph->error, "pass '%s': bind '%s' has level %u, its texture '%s' has %d",
                            pass->name, bind->name, bind->level, graph->textures[copy->texture].name,
                            graph->textures[copy->texture].levels);
        copy->level = (int)bind->level;
        for (int i = 0; i < *count; i++)
            if (strcmp(into[i].name, copy->name) == 0)
                return aob_fail(graph->error, "pass '%s': two binds are named '%s'", pass->name, bind->name);
    }
    return true;
}

/* NULL, and a line, if there is none. */
static const char *find_text(struct aob_pass_graph *graph, const char *pass, const char *name)
{
    for (const struct aob_shader *s = graph->shaders; s && s->name; s++)
        if (strcmp(s->name, name) == 0)
            return s->text;
    aob_fail(graph->error, "pass '%s': the module has no shader text '%s'", pass, name);
    return NULL;
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
    pass->vertex_text = find_text(graph, pass->name, pass->vertex);
    if (!pass->vertex_text)
        return false;
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

static bool copy_defines(struct aob_pass_graph *graph, const struct aob_pass *desc,
                         struct aob_graph_pass *pass)
{
    for (int i = 0; i < AOB_MAX_DEFINE && desc->defines[i].name; i++) {
        const char *name = desc->defines[i].name;
        size_t size = strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
        if (size == 0 || size >= AOB_NAME_SIZE || name[size] || (*name >= '0' && *name <= '9') ||
            strncmp(name, "AOB_", 4) == 0)
            return aob_fail(
                graph->error,
                "pass '%s': define '%.60s': a name is at most %d upper-case letters, digits and _, and "
                "does not begin with AOB_",
                pass->name, name, AOB_NAME_SIZE - 1);
        strcpy(pass->defines[i].name, name);
        pass->defines[i].value = desc->defines[i].value;
        pass->define_count++;
    }
    return true;
}

static bool judge_reads(const struct aob_pass_graph *graph, const struct aob_pass *desc)
{
    const uint32_t known = AOB_DEPTH | AOB_NORMAL | AOB_VELOCITY | AOB_MATERIAL | AOB_LIGHT | AOB_CLEARANCE;
    if ((desc->reads & AOB_VELOCITY) && !(desc->reads & AOB_DEPTH))
        return aob_fail(graph->error, "pass '%s' reads the velocity, which takes the depth as well",
                        desc->name);
    if ((desc->reads & ~known) || (unsigned)desc->border > AOB_FAR)
        return aob_fail(graph->error, "pass '%s': unknown bits in reads or border", desc->name);
    if (desc->depth.id > (uint32_t)graph->texture_count)
        return aob_fail(graph->error, "pass '%s': its depth is no texture of this graph", desc->name);
    return true;
}

/* The harness's texture is one input more of a pass that asks for it. */
static bool bind_clearance(struct aob_pass_graph *graph, struct aob_graph_pass *pass)
{
    if (!(pass->reads & AOB_CLEARANCE) || graph->clear < 0)
        return true;
    if (pass->in_count == AOB_MAX_IN)
        return aob_fail(graph->error, "pass '%s': no input is left for the clearance", pass->name);
    for (int i = 0; i < pass->in_count; i++)
        if (strcmp(pass->in[i].name, "clearance") == 0)
            return aob_fail(graph->error, "pass '%s': the bind 'clearance' is the harness's", pass->name);
    struct aob_graph_bind *bind = &pass->in[pass->in_count++];
    *bind = (struct aob_graph_bind){.name = "clearance", .texture = graph->clear};
    return true;
}

static bool graph_pass(struct aob_graph *interface, const struct aob_pass *desc)
{
    struct aob_pass_graph *graph = own(interface);
    if (has_failed(interface))
        return false;
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
    pass->text = find_text(graph, pass->name, pass->shader);
    if (!pass->text)
        return false;
    if (!copy_defines(graph, desc, pass) || !judge_reads(graph, desc) || !copy_draw(graph, desc, pass) ||
        !copy_binds(graph, desc, desc->in, AOB_MAX_IN, pass->in, &pass->in_count) ||
        !bind_clearance(graph, pass) ||
        !copy_binds(graph, desc, desc->out, AOB_MAX_OUT, pass->out, &pass->out_count))
        return false;
    graph->pass_count++;
    return true;
}

/* The formats that hold an output: bits 1 << enum aob_format. A share has any format; directions are signed, and light has
 * no upper bound. */
enum { FLOATS = 1 << AOB_RGBA16F | 1 << AOB_RGBA32F, ANY = (1 << AOB_FORMAT_COUNT) - 1 };
static const uint32_t output_formats[AOB_OUTPUT_COUNT] = {
    [AOB_OUT_VISIBILITY] = ANY,
    [AOB_OUT_BENT_NORMAL] = FLOATS,
    [AOB_OUT_VISIBILITY_RGB] = FLOATS | 1 << AOB_RGBA8,
    [AOB_OUT_SPECULAR] = ANY,
    [AOB_OUT_IRRADIANCE] = FLOATS,
};

static bool graph_output(struct aob_graph *interface, enum aob_output which, aob_tex tex)
{
    struct aob_pass_graph *graph = own(interface);
    if (has_failed(interface))
        return false;
    if (which == AOB_OUT_LIT)
        return aob_fail(graph->error, "output lit is composed by the harness: no technique gives it");
    if ((unsigned)which >= AOB_OUTPUT_COUNT || tex.id == 0 || tex.id > (uint32_t)graph->texture_count)
        return aob_fail(graph->error, "an output is unknown or has no texture of this graph");
    const struct aob_graph_texture *texture = &graph->textures[tex.id - 1];
    const char *name = aob_output_name(which);
    if (graph->outputs[which] >= 0)
        return aob_fail(graph->error, "output %s is given twice", name);
    if (texture->divisor != 1 || texture->fill)
        return aob_fail(graph->error,
                        "output %s: texture '%s' is not full size: upsampling is part of the technique", name,
                        texture->name);
    if (!(output_formats[which] >> texture->format & 1))
        return aob_fail(graph->error, "output %s: texture '%s' is %s: must be %srgba16f or rgba32f", name,
                        texture->name, aob_format_name(texture->format),
                        which == AOB_OUT_VISIBILITY_RGB ? "rgba8, " : "");
    graph->outputs[which] = (int)tex.id - 1;
    return true;
}

static aob_tex graph_previous(struct aob_graph *interface, aob_tex tex)
{
    struct aob_pass_graph *graph = own(interface);
    if (has_failed(interface))
        return (aob_tex){0};
    bool known = tex.id > 0 && tex.id <= (uint32_t)graph->texture_count;
    if (known && !graph->textures[tex.id - 1].fill)
        return (aob_tex){tex.id | PREVIOUS};
    aob_fail(graph->error,
             known ? "a table has no previous texture: '%s'" : "previous of what is no texture of this graph",
             known ? graph->textures[tex.id - 1].name : "");
    return (aob_tex){0};
}

static const struct aob_graph_ops graph_ops = {graph_wants, graph_texture, graph_pass, graph_output,
                                               graph_previous};

bool aob_graph_build(struct aob_pass_graph *graph, const struct aob_technique *technique, const void *values,
                     uint32_t wanted, struct aob_error *error)
{
    struct aob_error cause = {{0}};
    const char *why = NULL;
    *graph = (struct aob_pass_graph){.interface = {&graph_ops},
                                     .technique = technique,
                                     .shaders = technique->shaders,
                                     .wanted = wanted | AOB_OUTPUTS_REQUIRED,
                                     .error = &cause};
    memset(graph->outputs, 0xff, sizeof graph->outputs);
    graph->clear = -1;
    bool ok = true;
    if (technique->check && !technique->check(values, &why))
        ok = aob_fail(&cause, "%s", why ? why : "these values do not go together");
    if (ok && wanted & AOB_WANT_THRIFT)
        ok = aob_clearance_lay(graph, values);
    ok = ok && technique->build(&graph->interface, values);
    if (!ok && !*cause.text)
        aob_fail(&cause, "build() failed without a reason");
    if (ok && *cause.text) /* a failed call that build() did not look at */
        ok = false;
    if (ok && graph->wanted >> AOB_OUT_LIT & 1)
        ok = aob_composite_lay(graph);
    ok = ok && aob_graph_judge(graph);
    graph->error = NULL;
    return ok || aob_fail(error, "%s: %s", technique->name, cause.text);
}
