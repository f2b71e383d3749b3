/* A view of the data on a device, and techniques on it: what every section that draws is made of. */
#ifndef AOB_GPU_CHECK_CANVAS_H
#define AOB_GPU_CHECK_CANVAS_H
#include "check_data.h"
#include "frame/frame.h"

struct aob_canvas {
    struct aob_gpu *gpu;
    const struct aob_check_view *view;
    struct aob_gbuffer gbuffer;
    struct aob_geometry geometry; /* the scene's triangles */
    struct aob_screen screen;     /* in the encodings and the light of the last aob_canvas_show */
    struct aob_options options;   /* of that */
};

/* False after one line; a finished or zeroed canvas is left. `gpu` and `view` must outlive it. */
bool aob_canvas_init(struct aob_canvas *canvas, struct aob_gpu *gpu, const struct aob_check_view *view,
                     struct aob_error *error);
void aob_canvas_finish(struct aob_canvas *canvas);

/* A technique on the canvas. The frames of the canvas before must be finished where these options or this light differ from
 * theirs. False after one line; frame->unfit as of aob_frame_init. */
bool aob_canvas_show(struct aob_canvas *canvas, const struct aob_check_drawing *drawing,
                     struct aob_frame *frame, struct aob_error *error);

/* Draws so many frames of a technique that aob_canvas_show has made, numbered from 0, as if nothing moved. */
bool aob_canvas_draw(struct aob_frame *frame, int frames, struct aob_error *error);
#endif
