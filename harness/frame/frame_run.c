#include <stdlib.h>
#include <string.h>
#include "base/half.h"
#include "base/memory.h"
#include "frame.h"

/* Whether what one frame writes is what the next one reads as previous. */
static bool takes_turns(const struct aob_frame *frame)
{
    return aob_graph_keeps_history(&frame->graph) && !frame->follows;
}

const struct aob_gpu_texture *aob_frame_texture(const struct aob_frame *frame, int index)
{
    bool turned = takes_turns(frame) && !frame->turn;
    return turned && frame->earlier[index] ? frame->earlier[index] : frame->textures[index];
}

/* The live passes as the next frame has them, or as the one after it. */
static size_t list_passes(const struct aob_frame *frame, bool turned, struct aob_gpu_pass **passes)
{
    size_t count = 0;
    for (int i = 0; i < frame->graph.pass_count; i++)
        if (frame->passes[i])
            passes[count++] = turned && frame->turned[i] ? frame->turned[i] : frame->passes[i];
    return count;
}

static void add_times(const struct aob_frame *frame, const struct aob_gpu_time *times, size_t frames,
                      struct aob_frame_time *sum)
{
    for (size_t f = 0; f < frames; f++)
        for (int i = 0; i < frame->graph.pass_count; i++)
            if (frame->passes[i])
                aob_gpu_time_add(&sum->passes[i], times++);
}

bool aob_frame_run(struct aob_frame *frame, int repeats, struct aob_frame_time *time, struct aob_error *error)
{
    struct aob_gpu_pass *passes[AOB_GPU_MAX_LIST];
    struct aob_gpu_time times[AOB_GPU_MAX_LIST], whole;
    struct aob_frame_time sum = {0};
    bool history = takes_turns(frame);
    int left = repeats;
    do {
        int frames = history && left > 1 ? 2 : 1; /* of the list */
        size_t count = list_passes(frame, frame->turn, passes);
        if (frames == 2)
            count += list_passes(frame, !frame->turn, passes + count);
        const struct aob_gpu_run_desc desc = {passes, count, history && frames == 1 ? 1 : left / frames};
        if (!aob_gpu_run(frame->screen->gpu, &desc, times, &whole, error))
            return aob_fail_in(error, "%s", frame->graph.technique->name);
        aob_gpu_time_add(&sum.whole, &whole);
        add_times(frame, times, (size_t)frames, &sum);
        left -= frames * desc.repeats;
        frame->turn = history && frame->turn == (frames == 2);
    } while (left > 0);
    if (time)
        *time = sum;
    return true;
}

static float component(const unsigned char *texel, enum aob_format format, int c)
{
    uint16_t half;
    float whole;
    switch (format) {
    case AOB_R8:
    case AOB_RG8:
    case AOB_RGBA8:
        return (float)texel[c] / 255.0f;
    case AOB_R16:
        memcpy(&half, texel + 2 * c, sizeof half);
        return (float)half / 65535.0f;
    case AOB_R16F:
    case AOB_RG16F:
    case AOB_RGBA16F:
        memcpy(&half, texel + 2 * c, sizeof half);
        return aob_half_to_float(half);
    default:
        memcpy(&whole, texel + 4 * c, sizeof whole);
        return whole;
    }
}

bool aob_frame_read(struct aob_frame *frame, enum aob_output which, int components, float *pixels,
                    struct aob_error *error)
{
    const struct aob_gpu_texture *texture = aob_frame_texture(frame, frame->graph.outputs[which]);
    const struct aob_projection *view = &frame->screen->gbuffer->projection;
    size_t size = aob_gpu_texel_size(texture->format), stride = (size_t)texture->width;
    size_t guard = (size_t)frame->screen->gbuffer->guard, w = (size_t)view->width, h = (size_t)view->height;
    int first = aob_graph_output_component(&frame->graph, which);
    unsigned char *texels = aob_alloc(stride * (size_t)texture->height, size);
    bool ok = aob_gpu_texture_read(frame->screen->gpu, texture, 0, texels, error);
    for (size_t y = guard; ok && y < h - guard; y++)
        for (size_t x = guard; x < w - guard; x++)
            for (int c = 0; c < components; c++)
                *pixels++ = component(texels + (y * stride + x) * size, texture->format, first + c);
    free(texels);
    return ok;
}
