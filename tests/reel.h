/* A technique that draws one frame after another, in this process, for tests of what it keeps from frame to frame. */
#ifndef AOB_TESTS_REEL_H
#define AOB_TESTS_REEL_H
#include "rig.h"

struct aob_reel {
    struct aob_gpu *gpu;
    struct aob_screen screen;
    struct aob_frame frame;
    unsigned char values[4 * AOB_MAX_PARAM];
    int number; /* of the next frame */
};

/* `rig` is the first frame's view, and the others' until another is shown; params as of aob_rig_run. Ends the program on a failure, as the next
 * ones do. */
void aob_reel_init(struct aob_reel *reel, const struct aob_rig *rig, struct aob_gpu *gpu,
                   const char *technique, const char *params);

/* From now on frames are of this view, with the velocities that its G-buffer has. */
void aob_reel_show(struct aob_reel *reel, const struct aob_rig *rig);

/* Draws a frame; its visibility, width x height floats, unless `pixels` is NULL. */
void aob_reel_draw(struct aob_reel *reel, float *pixels);
void aob_reel_finish(struct aob_reel *reel);
#endif
