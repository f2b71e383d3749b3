/* A view on a device, of which frames of techniques are made: what the jobs `block` and `cache` begin with. */
#ifndef AOB_WORKER_DRAWING_H
#define AOB_WORKER_DRAWING_H
#include <jansson.h>
#include "frame/frame.h"
#include "job/drawing_job.h"
#include "plan/plan.h"
#include "scene/mesh.h"
#include "technique/registry.h"

struct aob_drawing {
    const struct aob_job_drawing *job; /* borrowed */
    struct aob_registry registry; /* with the modules of the cases, each loaded when its first frame is set */
    struct aob_gbuffer gbuffer;   /* canonical: what scores know of the view */
    struct aob_gbuffer drawn;     /* by the device, where the job says raster; else empty */
    struct aob_mesh mesh;         /* where the job says raster or triangles; else empty */
    struct aob_geometry geometry; /* where it says triangles; else empty */
    json_t *difference;           /* of the two G-buffers; NULL where there is but one */
    struct aob_gpu *gpu;
    struct aob_screen
        screens[AOB_BLOCK_MAX + 1]; /* one for each encoding and fetch; the first: the fixed pass */
    struct aob_options screen_options[AOB_BLOCK_MAX + 1];
    size_t screen_count;
};

/* Reads the view's G-buffer. False after a line; it is to be finished either way. */
bool aob_drawing_load(struct aob_drawing *drawing, const struct aob_job_drawing *job,
                      struct aob_error *error);

/* Opens the device and brings there what all frames need. False: it cannot be had here (unsupported). */
bool aob_drawing_open(struct aob_drawing *drawing, struct aob_error *error);
void aob_drawing_finish(
    struct aob_drawing *drawing); /* after the frames that are made of it; of a zeroed one too */

/* What a frame is made of. */
struct aob_drawing_part {
    const struct aob_technique *technique;
    struct aob_screen *screen; /* in the encodings of the case's options, made when they are first wanted */
    enum aob_fetch fetch;
    uint32_t wanted;                         /* outputs besides visibility (frame/frame.h) */
    unsigned char values[4 * AOB_MAX_PARAM]; /* the technique's own struct */
    bool unfit; /* after a refusal: the device lacks what the case's options need (unsupported) */
};
bool aob_drawing_set(struct aob_drawing *drawing, const struct aob_job_frame *frame,
                     struct aob_drawing_part *part, struct aob_error *error);

/* Another frame of a sequence, seen by that camera, in all screens that there are. The G-buffer must outlive the next call, or
 * the drawing. */
bool aob_drawing_show(struct aob_drawing *drawing, const struct aob_gbuffer *gbuffer,
                      const struct aob_camera *camera, struct aob_error *error);

/* Who measures, once the device is open: the `fingerprint` of a record. A new object. */
json_t *aob_drawing_fingerprint(const struct aob_drawing *drawing);

/* For aob_drawing_open, where the job says so: draws the mesh on the device into `drawn`, for the techniques to read, and
 * fills `difference`. */
bool aob_drawing_draw(struct aob_drawing *drawing, struct aob_error *error);
#endif
