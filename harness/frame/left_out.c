#include "left_out.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "technique/clearance.h"
#include "technique/param.h"

static double radius_of(const struct aob_frame *frame)
{
    const struct aob_technique *t = frame->graph.technique;
    float radius;
    memcpy(&radius, frame->values + aob_param_find(t->params, t->param_count, "radius")->offset,
           sizeof radius);
    return (double)radius;
}

/* Whether the pass that leaves out reads the whole depth. */
static bool reads_whole_depth(const struct aob_pass_graph *graph)
{
    for (int p = 0; p < graph->pass_count; p++)
        if (graph->passes[p].live && graph->passes[p].reads & AOB_CLEARANCE &&
            aob_graph_depth_divisor(graph, &graph->passes[p]) > 1)
            return false;
    return true;
}

/* As aob_is_clear: no sample in the ball of the radius about the surface of a pixel leaves it. */
static bool is_small(const struct aob_projection *view, double radius, size_t x, size_t y, double z)
{
    double along = ((double)x + 0.5 - view->cx) * view->sx, up = ((double)y + 0.5 - view->cy) * view->sy;
    double longer = view->perspective ? sqrt(1 + along * along + up * up) : 1;
    double nearest = view->perspective ? z - radius * longer : 1;
    return nearest > 0 && radius / (view->sy * nearest) * longer < 0.5;
}

bool aob_frame_left_out(const struct aob_frame *frame, double *share, struct aob_error *error)
{
    const struct aob_gbuffer *gbuffer = frame->screen->gbuffer;
    size_t width = (size_t)gbuffer->projection.width, height = (size_t)gbuffer->projection.height,
           guard = (size_t)gbuffer->guard, surfaces = 0, left = 0;
    *share = 0;
    if (!aob_graph_leaves_out(&frame->graph))
        return true;
    const struct aob_gpu_texture *clear = frame->textures[frame->graph.clear];
    unsigned char *texels = aob_alloc((size_t)clear->width * (size_t)clear->height, 1);
    bool ok = aob_gpu_texture_read(frame->screen->gpu, clear, 0, texels, error);
    double radius = reads_whole_depth(&frame->graph) ? radius_of(frame) : INFINITY;
    for (size_t y = guard; ok && y < height - guard; y++)
        for (size_t x = guard; x < width - guard; x++) {
            float z = gbuffer->depth[y * width + x];
            size_t tile = y / AOB_CLEARANCE_TILE * (size_t)clear->width + x / AOB_CLEARANCE_TILE;
            if (!(z >= 1e-15f && z < 0.5f * AOB_GBUFFER_SKY))
                continue;
            surfaces++;
            left += texels[tile] || is_small(&gbuffer->projection, radius, x, y, (double)z);
        }
    free(texels);
    *share = surfaces ? (double)left / (double)surfaces : NAN;
    return ok;
}
