#include "planes.h"
#include <stdio.h>

/* Indices into frame.textures; -1: not there. */
struct textures {
    int graph[AOB_MAX_TEXTURE], earlier[AOB_MAX_TEXTURE], depth, normal, velocity, albedo, shine;
};

static int add_texture(struct aob_planes *planes, const char *name, enum aob_format format, int width,
                       int height, int levels)
{
    struct aob_trace_texture *texture = &planes->frame.textures[planes->frame.texture_count];
    *texture =
        (struct aob_trace_texture){.format = format, .width = width, .height = height, .levels = levels};
    snprintf(texture->name, sizeof texture->name, "%s", name);
    return planes->frame.texture_count++;
}

static void add_screen(struct aob_planes *planes, const struct aob_pass_graph *graph,
                       const struct aob_screen *screen, struct textures *textures)
{
    const struct aob_projection *view = &screen->gbuffer->projection;
    textures->depth = add_texture(planes, "depth", aob_encoding_depth_format(&screen->encoding), view->width,
                                  view->height, 1);
    textures->normal = screen->normal == screen->depth
                           ? textures->depth
                           : add_texture(planes, "normal", aob_encoding_normal_format(&screen->encoding),
                                         view->width, view->height, 1);
    planes->frame.textures[textures->normal].role = AOB_TRACE_ROLE_NORMAL;
    planes->frame.textures[textures->depth].role = AOB_TRACE_ROLE_DEPTH;
    if (aob_graph_reads(graph) & AOB_VELOCITY)
        textures->velocity = add_texture(planes, "velocity", AOB_RGBA16F, view->width, view->height, 1);
    if (aob_graph_reads(graph) & AOB_MATERIAL) {
        textures->albedo = add_texture(planes, "albedo", AOB_RGBA8, view->width, view->height, 1);
        textures->shine = add_texture(planes, "shine", AOB_RG8, view->width, view->height, 1);
    }
    if (aob_graph_needs_triangles(graph))
        add_texture(planes, "triangles", AOB_RGBA32F, screen->geometry->texture->width,
                    screen->geometry->texture->height, 1);
}

static void add_textures(struct aob_planes *planes, const struct aob_pass_graph *graph,
                         const struct aob_screen *screen, struct textures *textures)
{
    const struct aob_projection *view = &screen->gbuffer->projection;
    for (int i = 0; i < graph->texture_count; i++) {
        const struct aob_graph_texture *texture = &graph->textures[i];
        int w, h;
        aob_graph_texture_size(texture, view->width, view->height, &w, &h);
        textures->graph[i] =
            texture->used ? add_texture(planes, texture->name, texture->format, w, h, texture->levels) : -1;
        char name[AOB_NAME_SIZE + 16];
        snprintf(name, sizeof name, "%s before", texture->name);
        textures->earlier[i] =
            texture->kept ? add_texture(planes, name, texture->format, w, h, texture->levels) : -1;
    }
    add_screen(planes, graph, screen, textures);
}

/* One plane for a level of a texture, by however many bindings it is read. */
static int plane_of(const struct aob_trace_frame *frame, struct aob_trace_pass *pass, int texture, int level)
{
    int i = 0;
    while (i < pass->plane_count && (pass->planes[i].texture != texture || pass->planes[i].level != level))
        i++;
    if (i == pass->plane_count)
        pass->planes[pass->plane_count++] =
            (struct aob_trace_plane){.width = aob_gpu_level_side(frame->textures[texture].width, level),
                                     .height = aob_gpu_level_side(frame->textures[texture].height, level),
                                     .texture = texture,
                                     .level = level};
    return i;
}

static void add_reads(struct aob_planes *planes, int pass, int binding, int texture, int first, int count)
{
    for (int l = 0; l < count; l++)
        planes->reads[pass][binding][l] =
            (unsigned char)plane_of(&planes->frame, &planes->passes[pass], texture, first + l);
}

static void describe_reads(struct aob_planes *planes, const struct aob_pass_graph *graph,
                           const struct aob_screen *screen, const struct textures *textures, int index)
{
    const struct aob_graph_pass *pass = &graph->passes[index];
    bool derived = screen->encoding.normals == AOB_NORMALS_FROM_DEPTH;
    if (pass->reads & AOB_DEPTH || (pass->reads && derived))
        add_reads(planes, index, AOB_BINDING_DEPTH, textures->depth, 0, 1);
    if (pass->depth >= 0)
        add_reads(planes, index, AOB_BINDING_OWN_DEPTH, textures->graph[pass->depth], 0, pass->depth_levels);
    if (pass->reads & AOB_NORMAL && !derived)
        add_reads(planes, index, AOB_BINDING_NORMAL, textures->normal, 0, 1);
    if (pass->reads & AOB_VELOCITY)
        add_reads(planes, index, AOB_BINDING_VELOCITY, textures->velocity, 0, 1);
    if (pass->reads & AOB_MATERIAL) {
        add_reads(planes, index, AOB_BINDING_ALBEDO, textures->albedo, 0, 1);
        add_reads(planes, index, AOB_BINDING_SHINE, textures->shine, 0, 1);
    }
    for (int i = 0; i < pass->in_count; i++) {
        const struct aob_graph_bind *in = &pass->in[i];
        const int *from = in->previous ? textures->earlier : textures->graph;
        add_reads(planes, index, AOB_BINDING_FIRST_INPUT + i, from[in->texture], in->level, in->level_count);
    }
}

static void describe_pass(struct aob_planes *planes, const struct aob_pass_graph *graph,
                          const struct aob_screen *screen, const struct textures *textures, int index)
{
    const struct aob_projection *view = &screen->gbuffer->projection;
    const struct aob_graph_pass *pass = &graph->passes[index];
    struct aob_trace_pass *described = &planes->passes[index];
    described->index = index;
    described->fragments = pass->draw == AOB_TRIANGLES;
    snprintf(described->name, sizeof described->name, "%s", pass->name);
    aob_graph_divided(view->width, view->height, aob_graph_target_divisor(graph, pass), &described->width,
                      &described->height);
    for (int o = 0; o < pass->out_count; o++)
        described->writes[described->write_count++] =
            (struct aob_trace_write){textures->graph[pass->out[o].texture], pass->out[o].level};
    describe_reads(planes, graph, screen, textures, index);
}

static bool number_planes(struct aob_trace_pass *pass, struct aob_error *error)
{
    uint64_t next = 0;
    for (int i = 0; i < pass->plane_count; i++) {
        struct aob_trace_plane *plane = &pass->planes[i];
        plane->first = (uint32_t)next;
        next += (uint64_t)plane->width * (uint64_t)plane->height;
        if (next > AOB_TRACE_MAX_TEXEL)
            return aob_fail(error,
                            "pass '%s' reads textures of more than %u texels together, which a trace cannot "
                            "number: use a smaller image",
                            pass->name, AOB_TRACE_MAX_TEXEL);
    }
    return true;
}

bool aob_planes_init(struct aob_planes *planes, const struct aob_pass_graph *graph,
                     const struct aob_screen *screen, struct aob_error *error)
{
    struct textures textures = {.velocity = -1, .albedo = -1, .shine = -1};
    *planes = (struct aob_planes){0};
    add_textures(planes, graph, screen, &textures);
    for (int i = 0; i < graph->pass_count; i++) {
        if (!graph->passes[i].live)
            continue;
        describe_pass(planes, graph, screen, &textures, i);
        if (!number_planes(&planes->passes[i], error))
            return false;
    }
    return true;
}

uint32_t aob_planes_texels(const struct aob_trace_pass *pass)
{
    if (!pass->plane_count)
        return 0;
    const struct aob_trace_plane *last = &pass->planes[pass->plane_count - 1];
    return last->first + (uint32_t)last->width * (uint32_t)last->height;
}
