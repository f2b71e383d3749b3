/* A sequence of frames: the camera goes on a straight line, eye and target each, and what moves of the scene moves on. */
#ifndef AOB_SCENE_MOTION_H
#define AOB_SCENE_MOTION_H
#include "camera.h"

struct aob_motion {
    int frames; /* 0: there is no sequence */
    /* Of the camera in frame 0 and in the last one, frames - 1; the same twice: it is still. */
    struct aob_vec3 eye, target, last_eye, last_target;
};

/* Whether the camera moves. */
bool aob_motion_has_camera(const struct aob_motion *motion);

/* The camera in a frame, with the lens of `lens`. In frame 0 it is still; later it moves, if it ever does, from where it was in
 * the frame before. First and last place are to the bit what the motion says. */
struct aob_camera aob_motion_camera(const struct aob_motion *motion, const struct aob_camera *lens,
                                    int frame);

/* Prints every number that decides a motion, for keys: " motion 16 from " and where the camera is in frame 0. */
void aob_motion_print(const struct aob_motion *motion, struct aob_text *text);
#endif
