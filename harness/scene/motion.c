#include "motion.h"

static bool same(struct aob_vec3 a, struct aob_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

bool aob_motion_has_camera(const struct aob_motion *motion)
{
    return !same(motion->eye, motion->last_eye) || !same(motion->target, motion->last_target);
}

static struct aob_vec3 between(struct aob_vec3 first, struct aob_vec3 last, int frame, int frames)
{
    if (frame == frames - 1)
        return last;
    double share = (double)frame / (frames - 1);
    return aob_vec_add(first, aob_vec_scale(aob_vec_sub(last, first), share));
}

struct aob_camera aob_motion_camera(const struct aob_motion *motion, const struct aob_camera *lens, int frame)
{
    struct aob_camera camera = *lens;
    camera.moves = frame > 0 && aob_motion_has_camera(motion);
    camera.eye = between(motion->eye, motion->last_eye, frame, motion->frames);
    camera.target = between(motion->target, motion->last_target, frame, motion->frames);
    camera.previous_eye = camera.previous_target = aob_vec(0, 0, 0);
    if (camera.moves) {
        camera.previous_eye = between(motion->eye, motion->last_eye, frame - 1, motion->frames);
        camera.previous_target = between(motion->target, motion->last_target, frame - 1, motion->frames);
    }
    return camera;
}

void aob_motion_print(const struct aob_motion *motion, struct aob_text *text)
{
    aob_text_add(text, " motion %d from %.17g %.17g %.17g %.17g %.17g %.17g", motion->frames, motion->eye.x,
                 motion->eye.y, motion->eye.z, motion->target.x, motion->target.y, motion->target.z);
}
