#include "trace_draw.h"
#include "base/clock.h"

enum { HEAD = 8 }; /* words: the block's members of trace.glsl before its array */
_Static_assert(AOB_TRACE_HEAD_BYTES == 4 * HEAD, "the head of trace.glsl");

/* A device that sees other counts than when it counted would write beside the slots. */
static bool check_counts(const struct aob_trace *trace, int pass, const struct aob_trace_draw *draw,
                         struct aob_error *error)
{
    return !draw->slots || draw->saw.slots <= draw->slots ||
           aob_fail(error,
                    "pass '%s' read %u texels where it had read %u at most: the device gives other results "
                    "from run to run",
                    trace->frame.graph.passes[pass].name, draw->saw.slots, draw->slots);
}

bool aob_trace_draw(struct aob_trace *trace, int pass, struct aob_trace_draw *draw, struct aob_error *error)
{
    struct aob_gpu *gpu = trace->frame.screen->gpu;
    struct aob_gpu_buffer *buffer = trace->capture->buffer;
    struct aob_gpu_pass *const list[] = {trace->frame.passes[pass]};
    uint32_t head[HEAD] = {(uint32_t)draw->part.row, draw->slots, draw->room};
    int64_t start = aob_clock_wall_ns();
    if (!aob_gpu_buffer_write(gpu, buffer, 0, sizeof head, head, error) ||
        !aob_gpu_pass_set_part(gpu, list[0], &draw->part, error) ||
        !aob_gpu_run(gpu, &(struct aob_gpu_run_desc){list, 1, 1}, NULL, NULL, error) ||
        !aob_gpu_buffer_read(gpu, buffer, 0, sizeof head, head, error))
        return false;
    draw->saw = (struct aob_trace_counts){head[3], head[4], (double)(aob_clock_wall_ns() - start) * 1e-9};
    return check_counts(trace, pass, draw, error);
}

bool aob_trace_read(const struct aob_trace *trace, size_t first, size_t count, uint32_t *words,
                    struct aob_error *error)
{
    return aob_gpu_buffer_read(trace->frame.screen->gpu, trace->capture->buffer, 4 * (HEAD + first),
                               4 * count, words, error);
}

bool aob_trace_check(const struct aob_trace_pass *pass, const uint32_t *words, size_t count,
                     struct aob_error *error)
{
    uint32_t texels = aob_planes_texels(pass);
    size_t wrong = 0;
    for (size_t i = 0; i < count; i++)
        wrong += words[i] != AOB_TRACE_NONE && aob_trace_texel(words[i]) >= texels;
    return !wrong || aob_fail(error,
                              "pass '%s' read %zu texels outside its textures: its text must use the "
                              "names of technique.h only",
                              pass->name, wrong);
}
