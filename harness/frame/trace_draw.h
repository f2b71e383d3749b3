/* One draw of a part of a traced pass: what the host tells it, and what it tells the host. For frame/trace*.c. */
#ifndef AOB_FRAME_TRACE_DRAW_H
#define AOB_FRAME_TRACE_DRAW_H
#include "past.h"
#include "planes.h"
#include "trace.h"

enum { AOB_TRACE_HEAD_BYTES = 32 }; /* of the buffer: trace.glsl's members before its array */

struct aob_trace_capture {
    struct aob_gpu *gpu;
    struct aob_planes planes;
    struct aob_first first;        /* where no past is given */
    struct aob_gpu_buffer *buffer; /* a head (trace.glsl), then words */
    size_t words, host_words;      /* that fit into the buffer, and that may be held here */
    struct aob_trace_counts {      /* of a pass, by its index in the graph */
        uint32_t slots;            /* the most words of an invocation */
        uint32_t fragments;        /* of a pass of triangles */
        double seconds;            /* of the draw */
    } counts[AOB_MAX_PASS];
};

struct aob_trace_draw {
    struct aob_gpu_part part;
    uint32_t slots, room; /* words of an invocation, and fragments, that may be written; 0: nothing is */
    struct aob_trace_counts saw; /* filled in */
};
bool aob_trace_draw(struct aob_trace *trace, int pass, struct aob_trace_draw *draw, struct aob_error *error);

/* `count` words from the buffer's word `first` on. */
bool aob_trace_read(const struct aob_trace *trace, size_t first, size_t count, uint32_t *words,
                    struct aob_error *error);

/* Whether each of the words is AOB_TRACE_NONE or a texel of the pass; else one line. A text that reads outside a texture
 * through names of the prelude's own would lead a reader of the words astray. */
bool aob_trace_check(const struct aob_trace_pass *pass, const uint32_t *words, size_t count,
                     struct aob_error *error);

/* trace_screen.c and trace_fragments.c, for a pass whose counts are known. The cost is added to trace->cost; with no sink
 * nothing is captured. */
bool aob_trace_screen_cost(struct aob_trace *trace, int pass, struct aob_error *error);
bool aob_trace_screen(struct aob_trace *trace, int pass, const struct aob_trace_sink *sink,
                      struct aob_error *error);
bool aob_trace_fragments_cost(struct aob_trace *trace, int pass, struct aob_error *error);
bool aob_trace_fragments(struct aob_trace *trace, int pass, const struct aob_trace_sink *sink,
                         struct aob_error *error);
#endif
