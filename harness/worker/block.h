/* The inside of a block job (job/block_job.h): what its parts share. */
#ifndef AOB_WORKER_BLOCK_H
#define AOB_WORKER_BLOCK_H
#include <jansson.h>
#include "frame/frame.h"
#include "job/block_job.h"
#include "worker.h"

/* One block while it is worked on. */
struct aob_block {
    struct aob_block_job job;
    struct aob_registry
        registry;               /* with the modules of the cases, each loaded when its first case is set up */
    struct aob_gbuffer gbuffer; /* canonical: what scores know of the view */
    struct aob_gbuffer drawn;   /* by the device, where the job says raster; else empty */
    struct aob_mesh mesh;       /* where the job says raster or triangles; else empty */
    struct aob_geometry geometry; /* where it says triangles; else empty */
    json_t *difference;           /* of the two; NULL where there is but one */
    struct aob_gpu *gpu;
    struct aob_screen
        screens[AOB_BLOCK_MAX + 1]; /* one for each encoding and fetch; the first: the fixed pass */
    struct aob_options screen_options[AOB_BLOCK_MAX + 1];
    size_t screen_count;
    struct aob_frame fixed, frames[AOB_BLOCK_MAX];
    size_t case_of_frame[AOB_BLOCK_MAX], frame_count;
    double setup_ms[AOB_BLOCK_MAX];
    bool good[AOB_BLOCK_MAX]; /* of each frame, where the job scores: its image is a visibility */
    struct aob_block_shares shares;
};

/* Times the frames that the job wants timed, and replies with what they are and their rounds. */
bool aob_block_measure(struct aob_worker *worker, struct aob_block *block, struct aob_error *error);

/* Runs the frame once more, scores its image against the targets and writes the EXR that the case asks for. Puts
 * `errors` into the answer, and `status` invalid where the image is no visibility. */
bool aob_block_score(struct aob_block *block, size_t f, json_t *answer, struct aob_error *error);

/* Where the job says so: draws the mesh on the block's device into `drawn`, for the techniques to read, and fills
 * `difference`. */
bool aob_block_draw(struct aob_block *block, struct aob_error *error);
#endif
