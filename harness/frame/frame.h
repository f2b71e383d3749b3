/* A technique on a device: its graph's textures, programs and passes, ready to be run again and again. */
#ifndef AOB_FRAME_FRAME_H
#define AOB_FRAME_FRAME_H
#include "base/error.h"
#include "gpu/gpu.h"
#include "screen.h"
#include "technique/graph.h"
#include "technique/option.h"

struct aob_past;
struct aob_planes;
struct aob_programs;
struct aob_frame {
    const struct aob_screen *screen; /* must outlive it */
    struct aob_pass_graph graph;
    enum aob_fetch fetch;
    unsigned char values[4 * AOB_MAX_PARAM];           /* the technique's own struct */
    struct aob_gpu_texture *textures[AOB_MAX_TEXTURE]; /* NULL where unused */
    struct aob_gpu_texture
        *earlier[AOB_MAX_TEXTURE]; /* the other one of what is kept from frame to frame, else NULL */
    bool follows; /* those are another frame's: this one reads them whenever it is drawn, and turns nothing */
    struct aob_gpu_program *programs[AOB_MAX_PASS];
    struct aob_programs *lender;               /* whose they are; NULL: the frame's own */
    struct aob_gpu_pass *passes[AOB_MAX_PASS]; /* NULL where pruned */
    /* The same with the two textures of what is kept exchanged, for every other frame: what one frame writes is what the next one
     * reads as previous. NULL where a pass has none of them. */
    struct aob_gpu_pass *turned[AOB_MAX_PASS];
    bool turn;                 /* the next run draws these */
    int number;                /* of the frame that runs draw */
    size_t memory_bytes;       /* of the technique's own textures */
    bool readable;             /* all textures can be read back, not outputs only */
    struct aob_planes *planes; /* of a traced frame, or NULL, like the next two */
    const struct aob_gpu_rewrite *rewrites;
    const struct aob_gpu_buffer *storage;
    bool
        unfit; /* after a refusal: the scene is not for this technique, or too large, or the device lacks something that it
                   needs (unsupported) */
};

struct aob_frame_desc {
    const struct aob_technique *technique;
    const void *values; /* the technique's own struct */
    enum aob_fetch fetch;
    uint32_t wanted; /* outputs besides visibility, and thrift: bits as of aob_options_wanted */
    bool readable;   /* as above */
    struct aob_programs
        *programs; /* frame/programs.h; borrowed from, must outlive the frame. NULL: it compiles its own */
    /* frame/past.h: what another frame of the same technique, values and screen has left. Of a technique that keeps a history this is
     * then the frame after it, however often it is drawn; it must outlive this one. NULL: frames follow each other here. */
    const struct aob_past *past;
    /* For frame/trace.c and frame/count.c. Each pass can be drawn in parts, and writes down what it does in `storage`: what
     * it reads, with `planes`, which are filled in and outlive the frame; or what its rewrite makes it write. There is a
     * rewrite for each pass, by its index in the graph. */
    struct aob_planes *planes;
    const struct aob_gpu_rewrite *rewrites;
    const struct aob_gpu_buffer *storage;
};
bool aob_frame_init_desc(struct aob_frame *frame, struct aob_screen *screen,
                         const struct aob_frame_desc *desc, struct aob_error *error);

/* Builds the graph (module code runs here), compiles and allocates. Only visibility is wanted. False leaves nothing behind
 * but `unfit`. */
bool aob_frame_init(struct aob_frame *frame, struct aob_screen *screen, const struct aob_technique *technique,
                    const void *values, enum aob_fetch fetch, struct aob_error *error);
void aob_frame_finish(struct aob_frame *frame);

/* What the next runs see: the frame's number (`aob_frame` in GLSL, 0 after aob_frame_init, but with a past), the values of the uniform
 * parameters, and what its screen shows (aob_screen_show). Frame 0 forgets what earlier frames left. No program or texture is made
 * again; tables keep what they were filled with. False, and nothing changed, if a parameter that is no uniform has
 * another value than the frame was built with, or if check() refuses the values or build() lays other passes for them;
 * false too if the device fails. */
bool aob_frame_set(struct aob_frame *frame, int number, const void *values, struct aob_error *error);

/* What running a frame took, summed over its repeats. Which clocks are there, and of what, is told at aob_gpu_run. */
struct aob_frame_time {
    struct aob_gpu_time whole;
    struct aob_gpu_time passes[AOB_MAX_PASS]; /* graph.pass_count of them; zeros for one that was pruned */
};

/* All live passes in order, the whole frame `repeats` (>= 1) times; `time` may be NULL. Of a technique that keeps a history each
 * repeat is a frame of its own, of one number, which reads what the one before left. */
bool aob_frame_run(struct aob_frame *frame, int repeats, struct aob_frame_time *time,
                   struct aob_error *error);

/* An output that the graph gives (aob_graph_gives), guard band cropped: width x height pixels of `components` floats,
 * those of the texel from aob_graph_output_component on, row 0 at the top. The texture has as many. */
bool aob_frame_read(struct aob_frame *frame, enum aob_output which, int components, float *pixels,
                    struct aob_error *error);

/* The texture of the graph that the last run wrote. */
const struct aob_gpu_texture *aob_frame_texture(const struct aob_frame *frame, int index);
#endif
