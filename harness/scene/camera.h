/* A camera, and the projection of its image. Right-handed world, +Y up; the view looks along -Z. */
#ifndef AOB_SCENE_CAMERA_H
#define AOB_SCENE_CAMERA_H
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"
#include "base/vec.h"

struct aob_camera {
    struct aob_vec3 eye, target; /* scene units */
    double fov_deg;              /* vertical field of view, perspective; ignored if ortho_height > 0 */
    double ortho_height;         /* > 0: orthographic, scene units from the top to the bottom of the image */
    /* Lens shift: how far the image is moved within its plane, x right and y up, in heights of the image (both; so
     * {0.5, 0} shows what lay half a height further right). The direction of the look and the scale stay. */
    double shift[2];
    /* One frame earlier, if `moves`; else the camera is still. The lens (field of view, height, shift) was the same. */
    bool moves;
    struct aob_vec3 previous_eye, previous_target;
};
enum { AOB_SHIFT_MAX = 16 }; /* heights of the image */

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

/* eye != target, finite, fov in 1..170, each shift within AOB_SHIFT_MAX, likewise the previous pose; else one line. */
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

/* The camera of the previous frame, still; of a camera that does not move it is the same one. */
struct aob_camera aob_camera_previous(const struct aob_camera *camera);

/* Image position of `from_eye`: world position less eye or, in perspective, a direction to the infinitely far. False
 * behind a perspective camera. */
bool aob_camera_project(const struct aob_camera *camera, const struct aob_projection *projection,
                        struct aob_vec3 from_eye, double q[2]);

/* Every number that decides the picture, for keys. Without `motion` the previous pose is left out. */
void aob_camera_print(const struct aob_camera *camera, bool motion, struct aob_text *text);
#endif
