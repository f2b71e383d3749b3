/* A camera, and the projection of its image. Right-handed world, +Y up; the view looks along -Z. */
#ifndef AOB_SCENE_CAMERA_H
#define AOB_SCENE_CAMERA_H
#include <stdbool.h>
#include "base/vec.h"
#include "base/error.h"

struct aob_camera {
    struct aob_vec3 eye, target; /* scene units */
    double fov_deg;              /* vertical field of view, perspective; ignored if ortho_height > 0 */
    double ortho_height;         /* > 0: orthographic, scene units from the top to the bottom of the image */
};

/* How image positions map to view space: x = (qx - cx) * sx * s, y = -(qy - cy) * sy * s with s = depth for a
 * perspective and 1 for an orthographic view; q in pixels, pixel centres at +.5, row 0 at the top. */
struct aob_projection {
    bool perspective;
    int width, height; /* pixels, guard band included */
    double sx, sy, cx, cy;
};

/* Axes of view space in world space, unit length: right (+X), up (+Y), back (+Z, against the look). */
struct aob_frame_axes {
    struct aob_vec3 right, up, back;
};

/* eye != target, finite, fov in 1..170; else one line. */
bool aob_camera_check(const struct aob_camera *camera, struct aob_error *error);
struct aob_frame_axes
aob_camera_axes(const struct aob_camera *camera); /* looking straight up or down is fine */

/* Of an image of width x height pixels with `guard` more on each side: the inner image keeps its field of
 * view. */
struct aob_projection aob_camera_projection(const struct aob_camera *camera, int width, int height,
                                            int guard);

/* Ray through image position q: origin, and direction scaled so that distance along it is depth. World space.
 */
void aob_camera_ray(const struct aob_camera *camera, const struct aob_projection *projection, double qx,
                    double qy, struct aob_vec3 *origin, struct aob_vec3 *direction);
#endif
