#include "graph.h"
#include <string.h>

void aob_graph_texture_size(const struct aob_graph_texture *texture, int width, int height, int *w, int *h)
{
    *w = texture->width;
    *h = texture->height;
    if (texture->fill)
        return;
    *w = (width + texture->divisor - 1) / texture->divisor;
    *h = (height + texture->divisor - 1) / texture->divisor;
}

int aob_graph_depth_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass)
{
    return pass->depth < 0 ? 1 : graph->textures[pass->depth].divisor;
}

int aob_graph_target_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass)
{
    return graph->textures[pass->out[0].texture].divisor;
}

bool aob_graph_needs_triangles(const struct aob_pass_graph *graph)
{
    for (int p = 0; p < graph->pass_count; p++)
        if (graph->passes[p].live && graph->passes[p].draw == AOB_TRIANGLES)
            return true;
    return false;
}

const char *aob_format_name(enum aob_format format)
{
    static const char *const names[AOB_FORMAT_COUNT] = {
        [AOB_R8] = "r8",           [AOB_R16] = "r16",        [AOB_R16F] = "r16f",   [AOB_R32F] = "r32f",
        [AOB_RG8] = "rg8",         [AOB_RG16F] = "rg16f",    [AOB_RG32F] = "rg32f", [AOB_RGBA8] = "rgba8",
        [AOB_RGBA16F] = "rgba16f", [AOB_RGBA32F] = "rgba32f"};
    return names[format];
}

static const char *shader_text(const struct aob_technique *technique, const char *name)
{
    for (const struct aob_shader *s = technique->shaders; s->name; s++)
        if (strcmp(s->name, name) == 0)
            return s->text;
    return "";
}

static void add_binds(const struct aob_pass_graph *graph, const struct aob_graph_bind *binds, int count,
                      struct aob_text *text)
{
    for (int i = 0; i < count; i++) {
        const struct aob_graph_texture *texture = &graph->textures[binds[i].texture];
        aob_text_add(text, " %s=%s:%s/%d,%dx%d~%d", binds[i].name, texture->name,
                     aob_format_name(texture->format), texture->divisor, texture->width, texture->height,
                     binds[i].filter);
    }
}

void aob_graph_digest(const struct aob_pass_graph *graph, const void *values, char key[AOB_KEY_SIZE])
{
    struct aob_text text = {0};
    for (uint32_t i = 0; i < graph->technique->param_count; i++) {
        const struct aob_param *param = &graph->technique->params[i];
        int32_t bits;
        memcpy(&bits, (const char *)values + param->offset, sizeof bits);
        if (param->stage == AOB_CONSTANT)
            aob_text_add(&text, "%s=%d\n", param->name, bits);
    }
    for (int p = 0; p < graph->pass_count; p++) {
        const struct aob_graph_pass *pass = &graph->passes[p];
        if (!pass->live)
            continue;
        aob_text_add(&text, "%s %s [%s] %u /%d %d in", pass->name, pass->shader, pass->defines, pass->reads,
                     aob_graph_depth_divisor(graph, pass), pass->border);
        add_binds(graph, pass->in, pass->in_count, &text);
        aob_text_add(&text, " out");
        add_binds(graph, pass->out, pass->out_count, &text);
        aob_text_add(&text, "\n%s\n", shader_text(graph->technique, pass->shader));
        if (pass->draw == AOB_TRIANGLES)
            aob_text_add(&text, "%u of %s\n%s\n", pass->per_triangle, pass->vertex,
                         shader_text(graph->technique, pass->vertex));
    }
    aob_hash_text(text.data ? text.data : "", key);
    aob_text_finish(&text);
}

/* From whichever earlier pass writes the texture; a table comes from itself. */
static void add_edge(const struct aob_pass_graph *graph, int pass, int texture, struct aob_text *text)
{
    const char *from = graph->textures[texture].name, *to = graph->passes[pass].name;
    for (int q = 0; q < pass; q++)
        for (int o = 0; o < graph->passes[q].out_count; o++)
            if (graph->passes[q].out[o].texture == texture)
                aob_text_add(text, "  %s -> %s [label=\"%s\"];\n", graph->passes[q].name, to, from);
    if (graph->textures[texture].fill)
        aob_text_add(text, "  %s [shape=cylinder];\n  %s -> %s;\n", from, from, to);
}

void aob_graph_dot(const struct aob_pass_graph *graph, struct aob_text *text)
{
    aob_text_add(text, "digraph %s {\n  rankdir=LR;\n  node [shape=box, fontname=\"sans-serif\"];\n",
                 graph->technique->name);
    for (int p = 0; p < graph->pass_count; p++) {
        const struct aob_graph_pass *pass = &graph->passes[p];
        aob_text_add(text, "  %s [style=%s];\n", pass->name, pass->live ? "solid" : "dashed");
        if (pass->reads)
            aob_text_add(text, "  gbuffer -> %s;\n", pass->name);
        if (pass->draw == AOB_TRIANGLES)
            aob_text_add(text, "  triangles -> %s;\n", pass->name);
        if (pass->depth >= 0)
            add_edge(graph, p, pass->depth, text);
        for (int i = 0; i < pass->in_count; i++)
            add_edge(graph, p, pass->in[i].texture, text);
        for (int o = 0; o < pass->out_count; o++)
            if (pass->out[o].texture == graph->outputs[AOB_OUT_VISIBILITY])
                aob_text_add(text, "  %s -> visibility;\n", pass->name);
    }
    aob_text_add(text, "}\n");
}
