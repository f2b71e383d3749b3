#include "graph.h"
#include <string.h>

void aob_graph_divided(int width, int height, int divisor, int *w, int *h)
{
    *w = (width + divisor - 1) / divisor;
    *h = (height + divisor - 1) / divisor;
}

void aob_graph_texture_size(const struct aob_graph_texture *texture, int width, int height, int *w, int *h)
{
    *w = texture->width;
    *h = texture->height;
    if (texture->fill)
        return;
    aob_graph_divided(width, height, texture->divisor << texture->align, w, h);
    *w <<= texture->align;
    *h <<= texture->align;
}

size_t aob_graph_texture_texels(const struct aob_graph_texture *texture, int width, int height)
{
    int w, h;
    size_t texels = 0;
    aob_graph_texture_size(texture, width, height, &w, &h);
    for (int level = 0; level < texture->levels; level++)
        texels += (size_t)(w >> level) * (size_t)(h >> level);
    return texels;
}

int aob_graph_depth_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass)
{
    return pass->depth < 0 ? 1 : graph->textures[pass->depth].divisor;
}

int aob_graph_bind_divisor(const struct aob_pass_graph *graph, const struct aob_graph_bind *bind)
{
    return graph->textures[bind->texture].divisor << bind->level;
}

int aob_graph_target_divisor(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass)
{
    return aob_graph_bind_divisor(graph, &pass->out[0]);
}

bool aob_graph_gives(const struct aob_pass_graph *graph, enum aob_output which)
{
    return graph->wanted >> which & 1 && graph->outputs[which] >= 0;
}

bool aob_graph_leaves_out(const struct aob_pass_graph *graph)
{
    return graph->clear >= 0 && graph->textures[graph->clear].used;
}

int aob_graph_output_component(const struct aob_pass_graph *graph, enum aob_output which)
{
    return which == AOB_OUT_VISIBILITY && graph->outputs[which] == graph->outputs[AOB_OUT_BENT_NORMAL] ? 3
                                                                                                       : 0;
}

const char *aob_output_name(enum aob_output which)
{
    static const char *const names[AOB_OUTPUT_COUNT] = {
        [AOB_OUT_VISIBILITY] = "visibility",         [AOB_OUT_BENT_NORMAL] = "bent_normal",
        [AOB_OUT_VISIBILITY_RGB] = "visibility_rgb", [AOB_OUT_SPECULAR] = "specular",
        [AOB_OUT_IRRADIANCE] = "irradiance",         [AOB_OUT_LIT] = "lit",
    };
    return names[which];
}

int aob_output_components(enum aob_output which)
{
    return which == AOB_OUT_VISIBILITY || which == AOB_OUT_SPECULAR ? 1 : 3;
}

uint32_t aob_graph_reads(const struct aob_pass_graph *graph)
{
    uint32_t reads = 0;
    for (int p = 0; p < graph->pass_count; p++)
        if (graph->passes[p].live)
            reads |= graph->passes[p].reads;
    return reads;
}

bool aob_graph_keeps_history(const struct aob_pass_graph *graph)
{
    for (int i = 0; i < graph->texture_count; i++)
        if (graph->textures[i].kept)
            return true;
    return false;
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

static void add_binds(const struct aob_pass_graph *graph, const struct aob_graph_bind *binds, int count,
                      struct aob_text *text)
{
    for (int i = 0; i < count; i++) {
        const struct aob_graph_texture *texture = &graph->textures[binds[i].texture];
        aob_text_add(text, " %s=%s:%s/%d*%d,%dx%d~%d@%d+%d%s", binds[i].name, texture->name,
                     aob_format_name(texture->format), texture->divisor, texture->levels, texture->width,
                     texture->height, binds[i].filter, binds[i].level, binds[i].level_count,
                     binds[i].previous ? " before" : "");
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
        aob_text_add(&text, "%s %s [", pass->name, pass->shader);
        for (int d = 0; d < pass->define_count; d++)
            aob_text_add(&text, " %s=%d", pass->defines[d].name, pass->defines[d].value);
        aob_text_add(&text, "] %u /%d*%d %d in", pass->reads, aob_graph_depth_divisor(graph, pass),
                     pass->depth_levels, pass->border);
        add_binds(graph, pass->in, pass->in_count, &text);
        aob_text_add(&text, " out");
        add_binds(graph, pass->out, pass->out_count, &text);
        aob_text_add(&text, "\n%s\n", pass->text);
        if (pass->draw == AOB_TRIANGLES)
            aob_text_add(&text, "%u of %s\n%s\n", pass->per_triangle, pass->vertex, pass->vertex_text);
    }
    aob_hash_text(text.data ? text.data : "", key);
    aob_text_finish(&text);
}

/* What a pass reads of a texture. */
struct read {
    int texture, level, count;
    bool previous;
};

/* From each pass that writes one of these levels; from earlier ones unless it is the frame before that they are of. A table comes
 * from itself. */
static void add_edges(const struct aob_pass_graph *graph, int pass, struct read read, struct aob_text *text)
{
    const struct aob_graph_texture *texture = &graph->textures[read.texture];
    const char *from = texture->name, *to = graph->passes[pass].name;
    for (int q = 0; q < (read.previous ? graph->pass_count : pass); q++)
        for (int o = 0; o < graph->passes[q].out_count; o++) {
            const struct aob_graph_bind *out = &graph->passes[q].out[o];
            if (out->texture != read.texture || out->level < read.level ||
                out->level >= read.level + read.count)
                continue;
            aob_text_add(text, "  %s -> %s [label=\"%s", graph->passes[q].name, to, from);
            if (texture->levels > 1)
                aob_text_add(text, " %d", out->level);
            aob_text_add(text, read.previous ? "\", style=dotted];\n" : "\"];\n");
        }
    if (texture->fill)
        aob_text_add(text, "  %s [shape=cylinder];\n  %s -> %s;\n", from, from, to);
}

static void add_outputs(const struct aob_pass_graph *graph, const struct aob_graph_pass *pass,
                        struct aob_text *text)
{
    for (int o = 0; o < pass->out_count; o++)
        for (int which = 0; which < AOB_OUTPUT_COUNT; which++)
            if (pass->out[o].texture == graph->outputs[which] && pass->out[o].level == 0)
                aob_text_add(text, "  %s -> %s;\n", pass->name, aob_output_name((enum aob_output)which));
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
            add_edges(graph, p, (struct read){pass->depth, 0, pass->depth_levels, false}, text);
        for (int i = 0; i < pass->in_count; i++) {
            const struct aob_graph_bind *in = &pass->in[i];
            add_edges(graph, p, (struct read){in->texture, in->level, in->level_count, in->previous}, text);
        }
        add_outputs(graph, pass, text);
    }
    aob_text_add(text, "}\n");
}
