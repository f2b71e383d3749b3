/* The surface that the depth of a capture shows about a pixel. It serves capture_normal.c.
 *
 * On each axis of the image the tangent goes to the neighbour on whose side the depth runs straight: the one where two
 * pixels foretell the pixel's own depth best (on a plane 1/depth is linear in the image; in an orthographic view the
 * depth is). So each side of a step or a crease is its own plane. Where the depth is straight on neither side, the
 * neighbour nearer in depth is taken. The cross product of the two tangents is the normal. */
#ifndef AOB_GBUFFER_CAPTURE_SURFACE_H
#define AOB_GBUFFER_CAPTURE_SURFACE_H
#include "capture.h"

struct aob_capture_surface {
    struct aob_vec3 normal; /* view space, unit, towards the camera; a pixel that stands alone faces it */
    /* By how much the depth bends there, or how coarse its steps are, over the way to the neighbour; of the worse axis.
     * It is about the angle, in radians, by which the normal may be wrong. INFINITY: nothing is known. */
    double doubt;
};
bool aob_capture_has_surface(const struct aob_capture *capture, int x, int y); /* false outside as well */
struct aob_capture_surface aob_capture_surface_at(const struct aob_capture *capture,
                                                  const struct aob_projection *view, int x, int y);

/* The unit vector from the pixel's surface to the camera. */
struct aob_vec3 aob_capture_to_camera(const struct aob_projection *view, int x, int y);
#endif
