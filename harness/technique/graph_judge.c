#include "graph_judge.h"

static int writer_of(const struct aob_pass_graph *graph, int texture, int level, int before)
{
    for (int p = 0; p < before; p++)
        for (int o = 0; o < graph->passes[p].out_count; o++)
            if (graph->passes[p].out[o].texture == texture && graph->passes[p].out[o].level == level)
                return p;
    return -1;
}

/* Levels from `level` on that passes before this one have written without a gap; of a table its one. */
static int count_levels(const struct aob_pass_graph *graph, int texture, int level, int before)
{
    int count = 0;
    if (graph->textures[texture].fill)
        return 1;
    while (level + count < graph->textures[texture].levels &&
           writer_of(graph, texture, level + count, before) >= 0)
        count++;
    return count;
}

static bool judge_depth(struct aob_pass_graph *graph, int index)
{
    struct aob_graph_pass *pass = &graph->passes[index];
    if (pass->depth < 0)
        return true;
    const struct aob_graph_texture *depth = &graph->textures[pass->depth];
    if (!(pass->reads & AOB_DEPTH))
        return aob_fail(graph->error, "pass '%s' has a depth and does not read it", pass->name);
    if ((depth->format != AOB_R16F && depth->format != AOB_R32F) || depth->fill)
        return aob_fail(graph->error, "pass '%s': its depth '%s' is not a target of r16f or r32f", pass->name,
                        depth->name);
    pass->depth_levels = count_levels(graph, pass->depth, 0, index);
    return pass->depth_levels > 0 ||
           aob_fail(graph->error, "pass '%s' reads depth '%s', which no earlier pass writes", pass->name,
                    depth->name);
}

static bool judge_output(const struct aob_pass_graph *graph, int index, const struct aob_graph_bind *out)
{
    const struct aob_graph_pass *pass = &graph->passes[index];
    const struct aob_graph_texture *texture = &graph->textures[out->texture];
    if (texture->fill)
        return aob_fail(graph->error, "pass '%s' writes the table '%s'", pass->name, texture->name);
    if (aob_graph_bind_divisor(graph, out) != aob_graph_target_divisor(graph, pass))
        return aob_fail(graph->error, "pass '%s': its outputs have different sizes", pass->name);
    for (const struct aob_graph_bind *other = pass->out; other < out; other++)
        if (other->texture == out->texture)
            return aob_fail(graph->error, "pass '%s' writes texture '%s' twice", pass->name, texture->name);
    if (writer_of(graph, out->texture, out->level, index) < 0)
        return true;
    if (texture->levels > 1)
        return aob_fail(graph->error,
                        "pass '%s': level %d of texture '%s' is already written by an earlier pass",
                        pass->name, out->level, texture->name);
    return aob_fail(graph->error, "pass '%s': texture '%s' is already written by an earlier pass", pass->name,
                    texture->name);
}

static bool judge_input(const struct aob_pass_graph *graph, int index, struct aob_graph_bind *in)
{
    const char *pass = graph->passes[index].name;
    const struct aob_graph_texture *texture = &graph->textures[in->texture];
    in->level_count = count_levels(graph, in->texture, in->level, in->previous ? graph->pass_count : index);
    if (in->one_level && in->level_count > 1)
        in->level_count = 1;
    if (in->level_count > 0)
        return true;
    if (in->previous)
        return aob_fail(graph->error, "pass '%s' reads the previous texture '%s', which no pass writes", pass,
                        texture->name);
    if (texture->levels > 1)
        return aob_fail(graph->error,
                        "pass '%s' reads level %d of texture '%s', which no earlier pass writes", pass,
                        in->level, texture->name);
    return aob_fail(graph->error, "pass '%s' reads texture '%s', which no earlier pass writes", pass,
                    texture->name);
}

static bool judge_pass(struct aob_pass_graph *graph, int index)
{
    struct aob_graph_pass *pass = &graph->passes[index];
    if (pass->out_count == 0)
        return aob_fail(graph->error, "pass '%s' writes nothing", pass->name);
    for (int o = 0; o < pass->out_count; o++)
        if (!judge_output(graph, index, &pass->out[o]))
            return false;
    for (int i = 0; i < pass->in_count; i++)
        if (!judge_input(graph, index, &pass->in[i]))
            return false;
    return judge_depth(graph, index);
}

static void mark_live(struct aob_pass_graph *graph, int texture, int level, int count);

static void mark_input(struct aob_pass_graph *graph, const struct aob_graph_bind *in)
{
    graph->textures[in->texture].kept = graph->textures[in->texture].kept || in->previous;
    mark_live(graph, in->texture, in->level, in->level_count);
}

static void mark_live(struct aob_pass_graph *graph, int texture, int level, int count)
{
    graph->textures[texture].used = true;
    for (int l = level; l < level + count; l++) {
        int writer = writer_of(graph, texture, l, graph->pass_count);
        if (writer < 0 || graph->passes[writer].live)
            continue;
        struct aob_graph_pass *pass = &graph->passes[writer];
        pass->live = true;
        for (int o = 0; o < pass->out_count; o++)
            graph->textures[pass->out[o].texture].used = true;
        for (int i = 0; i < pass->in_count; i++)
            mark_input(graph, &pass->in[i]);
        if (pass->depth >= 0)
            mark_live(graph, pass->depth, 0, pass->depth_levels);
    }
}

static bool judge_outputs(struct aob_pass_graph *graph)
{
    for (int which = 0; which < AOB_OUTPUT_COUNT; which++) {
        const char *name = aob_output_name((enum aob_output)which);
        if (AOB_OUTPUTS_REQUIRED >> which & 1 && graph->outputs[which] < 0)
            return aob_fail(graph->error, "the graph gives no output %s", name);
        if (graph->outputs[which] < 0)
            continue;
        if (writer_of(graph, graph->outputs[which], 0, graph->pass_count) < 0)
            return aob_fail(graph->error, "no pass writes texture '%s' of the output %s",
                            graph->textures[graph->outputs[which]].name, name);
        if (graph->wanted >> which & 1)
            mark_live(graph, graph->outputs[which], 0, 1);
    }
    return true;
}

/* One turn of align_textures; whether it changed anything. */
static bool align_targets(struct aob_pass_graph *graph, const struct aob_graph_pass *pass)
{
    bool changed = false;
    int below = 0; /* halvings that the pass's targets must still bear */
    for (int o = 0; pass->live && o < pass->out_count; o++) {
        int left = graph->textures[pass->out[o].texture].align - pass->out[o].level;
        below = left > below ? left : below;
    }
    for (int o = 0; pass->live && o < pass->out_count; o++) {
        int *align = &graph->textures[pass->out[o].texture].align;
        changed = changed || *align < pass->out[o].level + below;
        *align = pass->out[o].level + below;
    }
    return changed;
}

/* The targets of a pass are of one size, so what is drawn together is allocated alike. It ends: all levels of one pass have
 * one divisor, so the greatest align + log2(divisor) among textures that are so joined is all that can be reached. */
static void align_textures(struct aob_pass_graph *graph)
{
    for (bool changed = true; changed;) {
        changed = false;
        for (int p = 0; p < graph->pass_count; p++)
            changed = align_targets(graph, &graph->passes[p]) || changed;
    }
}

bool aob_graph_judge(struct aob_pass_graph *graph)
{
    for (int p = 0; p < graph->pass_count; p++)
        if (!judge_pass(graph, p))
            return false;
    if (!judge_outputs(graph))
        return false;
    align_textures(graph);
    return true;
}
