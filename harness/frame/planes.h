/* What the passes of a frame may read, as a trace numbers it (profile/trace.h): the frame's textures, and for each pass
 * the planes of texels behind its bindings. Plain data; no device is needed. */
#ifndef AOB_FRAME_PLANES_H
#define AOB_FRAME_PLANES_H
#include "frame.h"
#include "prelude.h"
#include "profile/trace.h"

struct aob_planes {
    struct aob_trace_frame frame;
    struct aob_trace_pass passes[AOB_MAX_PASS]; /* by index in the graph; zeros for one that was pruned */
    /* Of what a pass has at an image's binding, by the level that it shows: index into the pass's planes. */
    unsigned char reads[AOB_MAX_PASS][AOB_BINDING_IMAGE_COUNT][AOB_MAX_LEVEL];
};

/* `graph` is one that the screen serves. False after one line if a pass has more texels than numbers. */
bool aob_planes_init(struct aob_planes *planes, const struct aob_pass_graph *graph,
                     const struct aob_screen *screen, struct aob_error *error);

/* Of all planes of the pass together. */
uint32_t aob_planes_texels(const struct aob_trace_pass *pass);
#endif
