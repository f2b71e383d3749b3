#include "trace.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "trace_draw.h"

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static bool create_buffer(struct aob_trace *trace, const struct aob_trace_desc *desc, struct aob_error *error)
{
    struct aob_trace_capture *capture = trace->capture;
    const struct aob_gpu_info *info = &desc->screen->gpu->info;
    const char *lacks = aob_gpu_storage_lacks(desc->screen->gpu);
    trace->unfit = lacks;
    if (lacks)
        return aob_fail(error, "%s: no trace: %s %s: use another device or backend", info->backend,
                        info->device, lacks);
    size_t bytes = desc->device_bytes ? desc->device_bytes : AOB_TRACE_DEVICE_BYTES;
    bytes = least(bytes < 2 * AOB_TRACE_HEAD_BYTES ? 2 * AOB_TRACE_HEAD_BYTES : bytes, info->storage_bytes) /
            4 * 4;
    capture->words = (bytes - AOB_TRACE_HEAD_BYTES) / 4;
    capture->host_words = (desc->host_bytes ? desc->host_bytes : AOB_TRACE_HOST_BYTES) / 4;
    capture->buffer = aob_gpu_buffer_create(desc->screen->gpu, bytes, error);
    return capture->buffer;
}

/* Draws the pass whole: nothing is written down, and its targets are as in a frame that is not traced. */
static bool draw_whole(struct aob_trace *trace, int pass, struct aob_trace_draw *draw,
                       struct aob_error *error)
{
    *draw = (struct aob_trace_draw){0};
    return aob_trace_draw(trace, pass, draw, error);
}

/* A pass of triangles adds to its targets, so parts of it leave them unfinished. */
static bool restore(struct aob_trace *trace, int pass, struct aob_error *error)
{
    struct aob_trace_draw again;
    return !trace->capture->planes.passes[pass].fragments || draw_whole(trace, pass, &again, error);
}

static bool learn_pass(struct aob_trace *trace, int pass, struct aob_error *error)
{
    struct aob_trace_draw whole;
    if (!draw_whole(trace, pass, &whole, error))
        return false;
    trace->capture->counts[pass] = whole.saw;
    bool fragments = trace->capture->planes.passes[pass].fragments;
    if (fragments) /* the last draw of a capture */
        trace->cost.seconds += whole.saw.seconds;
    return (fragments ? aob_trace_fragments_cost : aob_trace_screen_cost)(trace, pass, error) &&
           restore(trace, pass, error);
}

static bool learn(struct aob_trace *trace, struct aob_error *error)
{
    for (int i = 0; i < trace->frame.graph.pass_count; i++)
        if (trace->frame.passes[i] && !learn_pass(trace, i, error))
            return false;
    return true;
}

static bool create_frame(struct aob_trace *trace, const struct aob_trace_desc *desc, struct aob_error *error)
{
    struct aob_first *first = &trace->capture->first;
    struct aob_frame_desc frame = {.technique = desc->technique,
                                   .values = desc->values,
                                   .fetch = desc->fetch,
                                   .wanted = desc->wanted,
                                   .readable = true,
                                   .past = desc->past,
                                   .planes = &trace->capture->planes,
                                   .storage = trace->capture->buffer};
    if (!frame.past && !aob_first_init(first, desc->screen, &frame, error)) {
        trace->unfit = first->unfit;
        return false;
    }
    frame.past = frame.past ? frame.past : aob_first_past(first);
    bool ok = aob_frame_init_desc(&trace->frame, desc->screen, &frame, error);
    trace->unfit = trace->frame.unfit;
    trace->textures = trace->capture->planes.frame;
    return ok;
}

bool aob_trace_init(struct aob_trace *trace, const struct aob_trace_desc *desc, struct aob_error *error)
{
    *trace = (struct aob_trace){.capture = AOB_NEW(struct aob_trace_capture)};
    trace->capture->gpu = desc->screen->gpu;
    if (create_buffer(trace, desc, error) && create_frame(trace, desc, error)) {
        if (learn(trace, error))
            return true;
        aob_fail_in(error, "%s", desc->technique->name);
    }
    bool unfit = trace->unfit;
    aob_trace_finish(trace);
    trace->unfit = unfit;
    return false;
}

void aob_trace_finish(struct aob_trace *trace)
{
    if (!trace->capture)
        return;
    aob_frame_finish(&trace->frame);
    aob_first_finish(&trace->capture->first);
    aob_gpu_buffer_destroy(trace->capture->gpu, trace->capture->buffer);
    free(trace->capture);
    *trace = (struct aob_trace){0};
}

static bool capture_pass(struct aob_trace *trace, int pass, const struct aob_trace_sink *sink,
                         struct aob_error *error)
{
    const struct aob_trace_pass *described = &trace->capture->planes.passes[pass];
    return sink->begin(sink->self, &trace->textures, described, error) &&
           (described->fragments ? aob_trace_fragments : aob_trace_screen)(trace, pass, sink, error) &&
           restore(trace, pass, error) && sink->end(sink->self, error);
}

bool aob_trace_run(struct aob_trace *trace, const struct aob_trace_sink *sink, struct aob_error *error)
{
    for (int i = 0; i < trace->frame.graph.pass_count; i++)
        if (trace->frame.passes[i] && !capture_pass(trace, i, sink, error))
            return aob_fail_in(error, "%s", trace->frame.graph.technique->name);
    return true;
}

/* Texels that differ within the pass's area. */
static size_t differences(const struct aob_gpu_texture *texture, int level, const struct aob_trace_pass *area,
                          const unsigned char *a, const unsigned char *b)
{
    size_t size = aob_gpu_texel_size(texture->format), count = 0;
    size_t stride = (size_t)aob_gpu_level_side(texture->width, level);
    for (size_t y = 0; y < (size_t)area->height; y++)
        for (size_t x = 0; x < (size_t)area->width; x++)
            count += memcmp(a + (y * stride + x) * size, b + (y * stride + x) * size, size) != 0;
    return count;
}

static bool compare_target(struct aob_trace *trace, const struct aob_frame *plain, int pass,
                           const struct aob_graph_bind *out, size_t *differ, struct aob_error *error)
{
    struct aob_gpu *gpu = trace->frame.screen->gpu;
    const struct aob_gpu_texture *a = trace->frame.textures[out->texture],
                                 *b = aob_frame_texture(plain, out->texture);
    if (!(b->uses & AOB_GPU_USE_READ_BACK))
        return true;
    size_t size = aob_gpu_level_bytes(a, out->level);
    unsigned char *texels = aob_alloc(2, size);
    bool ok = aob_gpu_texture_read(gpu, a, out->level, texels, error) &&
              aob_gpu_texture_read(gpu, b, out->level, texels + size, error);
    if (ok)
        *differ += differences(a, out->level, &trace->capture->planes.passes[pass], texels, texels + size);
    free(texels);
    return ok;
}

bool aob_trace_compare(struct aob_trace *trace, const struct aob_frame *plain, size_t *differ,
                       struct aob_error *error)
{
    const struct aob_pass_graph *graph = &trace->frame.graph;
    *differ = 0;
    for (int i = 0; i < graph->pass_count; i++)
        for (int o = 0; graph->passes[i].live && o < graph->passes[i].out_count; o++)
            if (!compare_target(trace, plain, i, &graph->passes[i].out[o], differ, error))
                return false;
    return true;
}
