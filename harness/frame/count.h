/* What the passes of a frame execute, counted by the passes themselves. A counted frame is made of the same shader texts:
 * their SPIR-V is optimised as a driver would (shader/optimise.h), each basic block counts its runs (shader/counters.h), and
 * a block's operations (shader/blocks.h) times its runs are what was executed. Loops and branches count as they went in each
 * pixel. Threads: as the device's.
 *
 * Of a technique that keeps a history the counted frame is one that has a frame before it, as of a trace (trace.h).
 *
 * The vertex text of a pass of triangles is not counted, and neither is it traced (trace.h). */
#ifndef AOB_FRAME_COUNT_H
#define AOB_FRAME_COUNT_H
#include "frame.h"
#include "profile/operations.h"

struct aob_count_desc {
    struct aob_screen *screen; /* must outlive the count, as for aob_frame_init */
    const struct aob_technique *technique;
    const void *values;
    enum aob_fetch fetch;
    uint32_t wanted;             /* as of a frame (struct aob_frame_desc) */
    const struct aob_past *past; /* as of a trace (struct aob_trace_desc) */
    uint64_t
        limit; /* runs that a counter can hold: a pass of more is drawn in parts; 0: 2^32, and it is that at most */
};

struct aob_count_pass {
    uint64_t invocations;        /* as many as pixels, but of fragments */
    struct aob_operations whole; /* of all of them together */
};

struct aob_count {
    struct aob_frame
        frame; /* the counted one, drawn by aob_count_run; all its textures can be read back. Its image may differ
                               from the plain one's by last bits, as its numbers are rounded elsewhere */
    struct aob_count_pass passes[AOB_MAX_PASS]; /* by index in the graph; zeros for one that was pruned */
    bool
        unfit; /* after a refusal: such a count is not possible here (unsupported): the device draws nothing or its fragment
                   programs write no storage buffers, a text holds what cannot be counted, a pixel runs too much, or what
                   aob_frame_init calls unfit */
    struct aob_counting *counting; /* its own */
};

/* Compiles the counted frame. False after one line, and leaves nothing behind but `unfit`. */
bool aob_count_init(struct aob_count *count, const struct aob_count_desc *desc, struct aob_error *error);
void aob_count_finish(struct aob_count *count);

/* Draws each live pass in order and fills in `passes`. May be called again: the counts are the same. */
bool aob_count_run(struct aob_count *count, struct aob_error *error);
#endif
