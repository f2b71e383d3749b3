/* A camera, and the projection of its image. Right-handed world, +Y up; the view looks along -Z. */
#ifndef AOB_SCENE_CAMERA_H
#define AOB_SCENE_CAMERA_H
#include <stdbool.h>
#include "base/error.h"
#include "base/text.h"
#include "base/vec.h"
#include "affine.h"

struct aob_camera {
    struct aob_vec3 eye, target; /* scene units */
    double fov_deg;              /* vertical field of view, perspective; ignored if ortho_height > 0 */
    double ortho_height;         /* > 0: orthographic, scene units from the top to the bottom of the image */
    /* The lens shift moves the image within its plane, x right and y up, both in heights of the image: {0.5, 0} shows
     * what lay half a height further right. The direction of the look and the scale stay. */
    double shift[2];
    /* If `moves`, the camera's pose one frame earlier; else the camera is still. The lens (field of view, height,
     * shift) was the same. */
    bool moves;
    struct aob_vec3 previous_eye, previous_target;
};
enum { AOB_SHIFT_MAX = 16 }; /* heights of the image */

/* Maps image positions to view space: x = (qx - cx) * sx * s, y = -(qy - cy) * sy * s with s = depth for a
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

/* Checks that eye and target are finite and differ, that the field of view is in 1..170 and each shift within
 * AOB_SHIFT_MAX, and that the previous pose is as good. False after one line. */
bool aob_camera_check(const struct aob_camera *camera, struct aob_error *error);
struct aob_frame_axes
aob_camera_axes(const struct aob_camera *camera); /* looking straight up or down is fine */

/* The projection of an image of width x height pixels with `guard` more on each side. The inner image keeps its field
 * of view. */
struct aob_projection aob_camera_projection(const struct aob_camera *camera, int width, int height,
                                            int guard);

/* The ray through image position q in world space: its origin, and its direction, scaled so that the distance along
 * it is the depth. */
void aob_camera_ray(const struct aob_camera *camera, const struct aob_projection *projection, double qx,
                    double qy, struct aob_vec3 *origin, struct aob_vec3 *direction);

/* The camera of the previous frame, which stands still. For a camera that does not move it is the same one. */
struct aob_camera aob_camera_previous(const struct aob_camera *camera);

/* From this frame's view space to that of the frame before, for what stands still. */
struct aob_affine aob_camera_then(const struct aob_camera *camera);

/* The image position of `from_eye`, which is a world position less the eye or, in perspective, a direction to the
 * infinitely far. False if it lies behind a perspective camera. */
bool aob_camera_project(const struct aob_camera *camera, const struct aob_projection *projection,
                        struct aob_vec3 from_eye, double q[2]);

/* Prints every number that decides the picture, for keys. Without `motion` it leaves the previous pose out. */
void aob_camera_print(const struct aob_camera *camera, bool motion, struct aob_text *text);
#endif
