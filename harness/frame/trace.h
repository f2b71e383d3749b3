/* What the passes of a frame fetch, written down by the passes themselves. A traced frame is made of the same shader
 * texts: the prelude's reads put the number of each texel into the next slot of their invocation (profile/trace.h says
 * how texels are numbered), in a storage buffer of the device. Pass by pass, the frame is drawn in strips whose words fit
 * into that buffer, and they are handed on in bands. Threads: as the device's.
 *
 * Of a technique that keeps a history the traced frame is one that has a frame before it, as the frames that are timed have.
 *
 * What is written down is what the texts ask for, so the same texel twice where a text asks twice; a driver may merge
 * such reads. The vertex text of a pass of triangles is not traced. */
#ifndef AOB_FRAME_TRACE_H
#define AOB_FRAME_TRACE_H
#include "frame.h"
#include "profile/trace.h"

/* Ceilings where a caller sets none. 128 MiB is what every storage buffer of Mesa's drivers may have. */
enum { AOB_TRACE_DEVICE_BYTES = 128 << 20, AOB_TRACE_HOST_BYTES = 512 << 20 };

struct aob_trace_desc {
    struct aob_screen *screen; /* must outlive the trace, as for aob_frame_init */
    const struct aob_technique *technique;
    const void *values;
    enum aob_fetch fetch;
    uint32_t wanted; /* as of a frame (struct aob_frame_desc) */
    const struct aob_past *
        past; /* what the frame before left (past.h), which must outlive the trace; NULL: of a technique with a history
                 the frame 0 is drawn here, by plain programs, and frame 1 is traced */
    size_t
        device_bytes; /* of the buffer, at most; 0: AOB_TRACE_DEVICE_BYTES. A device with less has its own limit */
    size_t host_bytes; /* of the words held here at one time, at most; 0: AOB_TRACE_HOST_BYTES */
};

struct aob_trace_cost { /* of a capture, known before it */
    double words;       /* of all invocations of all passes */
    size_t strips;      /* draws that are needed, at least */
    double seconds;     /* about; what the sink takes is not in it */
};

struct aob_trace {
    struct aob_frame frame;          /* the traced one; all its textures can be read back */
    struct aob_trace_frame textures; /* what the sink is told of them */
    struct aob_trace_cost cost;
    bool
        unfit; /* after a refusal: such a trace is not possible here (unsupported): the device draws nothing or its
                   fragment programs write no storage buffers, a ceiling is too low for the size, or what
                   aob_frame_init calls unfit */
    struct aob_trace_capture *capture; /* its own */
};

/* Compiles the traced frame, draws it once to learn how many slots each pass needs, and draws a strip of each pass, twice,
 * to foretell the cost. False after one line, and leaves nothing behind but `unfit`. */
bool aob_trace_init(struct aob_trace *trace, const struct aob_trace_desc *desc, struct aob_error *error);
void aob_trace_finish(struct aob_trace *trace);

/* Captures each live pass in order. May be called again: the words are the same. */
bool aob_trace_run(struct aob_trace *trace, const struct aob_trace_sink *sink, struct aob_error *error);

/* How many texels differ, in any bit, between the traced frame and a plain one of the same technique, values and screen
 * that has been run last for the same frame number: over all targets of all live passes that can be read back in both. 0 is what shall be: a driver
 * that optimises the two texts differently traces another image than it draws. */
bool aob_trace_compare(struct aob_trace *trace, const struct aob_frame *plain, size_t *differ,
                       struct aob_error *error);
#endif
