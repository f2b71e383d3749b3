/* Two exhibits that show the same surfaces from elsewhere: what the one's image shows of the other's. Noise stays with the
 * pixels, so such images are compared by the means of blocks. */
#ifndef AOB_STRESS_MATCH_H
#define AOB_STRESS_MATCH_H
#include "trial.h"

/* A point p of the one scene is p.x x + p.y y + p.z z + by in the other. */
struct aob_motion {
    struct aob_vec3 x, y, z, by;
};
extern const struct aob_motion aob_motion_none;
/* About an axis through `centre`; counter-clockwise for whom the unit vector `axis` points at. */
struct aob_motion aob_motion_turn(struct aob_vec3 centre, struct aob_vec3 axis, double deg);
struct aob_motion aob_motion_mirror(void); /* at the plane x = 0 */
struct aob_vec3 aob_motion_of(const struct aob_motion *motion, struct aob_vec3 point);
/* Moves a mesh that has no normals of its own. A mirrored one keeps its fronts. */
void aob_motion_apply(const struct aob_motion *motion, struct aob_mesh *mesh);

struct aob_match {
    const struct aob_exhibit *exhibit, *other;
    struct aob_motion motion; /* from the exhibit's scene to the other's */
};
/* For each surface of the exhibit the value of the other's pixel, if that shows it too: not farther than three pixels from
 * it, as far as a pixel's centre may lie on a flat floor. `seen` tells which those are. */
void aob_match_fetch(const struct aob_match *match, const float *other_image, float *image, bool *seen);

/* Largest difference of the means of a block of `size` x `size` pixels, over blocks of which three quarters are seen; `at` is
 * its first pixel. NAN without any. */
double aob_match_blocks(const struct aob_exhibit *exhibit, const float *image, const float *wanted,
                        const bool *seen, int size, size_t *at);
#endif
